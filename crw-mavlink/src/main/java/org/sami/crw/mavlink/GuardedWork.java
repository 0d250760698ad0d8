package org.sami.crw.mavlink;

import java.lang.System.Logger.Level;
import java.util.Arrays;

/** Runs work for one vehicle so that a fault in it does not stop the work for others. */
final class GuardedWork {
    private static final System.Logger LOG = System.getLogger(GuardedWork.class.getName());
    private static final String OURS = "org.sami.";

    private GuardedWork() {}

    /** Does a piece of work; what is thrown in it is logged in a line, so that what comes after it is still done. */
    static void run(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException | Error e) { // repeated work would end without a word
            log("a fault in what speaks for vehicles", e);
        }
    }

    /** Logs what was thrown in one line; where it comes from in full only with the level of debugging. */
    static void log(String what, Throwable thrown) {
        LOG.log(Level.ERROR, what + ": " + words(thrown));
        LOG.log(Level.DEBUG, what, thrown);
    }

    /** What was thrown, and the first place of this project where: {@code IllegalStateException: why, at MissionStore.look(MissionStore.java:120)}. */
    static String words(Throwable thrown) {
        String why = thrown.getMessage() == null ? "" : ": " + thrown.getMessage();
        return thrown.getClass().getSimpleName()
                + why.replaceAll("\\s+", " ")
                + Arrays.stream(thrown.getStackTrace())
                        .filter(place -> place.getClassName().startsWith(OURS))
                        .findFirst()
                        .map(place -> ", at " + place.getClassName().replaceFirst(".*\\.", "") + "."
                                + place.getMethodName() + "(" + place.getFileName() + ":" + place.getLineNumber() + ")")
                        .orElse("");
    }
}
