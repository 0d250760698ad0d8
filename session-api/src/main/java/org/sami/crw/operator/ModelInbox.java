package org.sami.crw.operator;

import java.lang.System.Logger.Level;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.atomic.AtomicBoolean;

/**
 * Brings changes to the one thread that owns the models: the only hop between those who feed them and those who read them. Whoever posts
 * a change never waits. Changes that wait are made together, and published together afterwards.
 */
final class ModelInbox {
    private static final System.Logger LOG = System.getLogger(ModelInbox.class.getName());

    /** So many changes at most are made before others who use the owner's thread get their turn. */
    private static final int BATCH = 1000;

    private final Executor owner;
    private final Runnable afterBatch;
    private final Queue<Runnable> waiting = new ConcurrentLinkedQueue<>();
    private final AtomicBoolean scheduled = new AtomicBoolean();
    private boolean working; // for the owner's thread

    /**
     * An empty inbox.
     *
     * @param owner runs what it is given on one thread, one after the other
     * @param afterBatch called on that thread after changes were made
     */
    ModelInbox(Executor owner, Runnable afterBatch) {
        this.owner = owner;
        this.afterBatch = afterBatch;
    }

    /** Makes a change on the owner's thread, after those that were posted before. From any thread. */
    void post(Runnable change) {
        waiting.add(change);
        schedule();
    }

    private void schedule() {
        if (scheduled.compareAndSet(false, true)) {
            try {
                owner.execute(this::work);
            } catch (RejectedExecutionException stopped) {
                waiting.clear(); // nobody looks at the models any longer
            }
        }
    }

    private void work() {
        scheduled.set(false);
        if (working) {
            return; // the executor runs on the spot: whoever works already goes on, further up the stack
        }
        working = true;
        try {
            int made = 0;
            for (Runnable change = waiting.poll(); change != null; change = waiting.poll()) {
                make(change);
                if (++made >= BATCH) {
                    break;
                }
            }
            make(afterBatch);
        } finally {
            working = false;
        }
        if (!waiting.isEmpty()) {
            schedule();
        }
    }

    private static void make(Runnable change) {
        try {
            change.run();
        } catch (RuntimeException | AssertionError fault) { // the models go on with what comes next
            LOG.log(Level.ERROR, "a change of the operator's models failed", fault);
        }
    }
}
