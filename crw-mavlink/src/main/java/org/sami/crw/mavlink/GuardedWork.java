package org.sami.crw.mavlink;

import java.lang.System.Logger.Level;

/** Runs work for one vehicle so that a fault in it does not stop the work for others. */
final class GuardedWork {
    private static final System.Logger LOG = System.getLogger(GuardedWork.class.getName());

    private GuardedWork() {}

    /** Does a piece of work; what is thrown in it is logged, so that what comes after it is still done. */
    static void run(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException | Error e) { // repeated work would end without a word
            LOG.log(Level.ERROR, "a fault in what speaks for vehicles", e);
        }
    }
}
