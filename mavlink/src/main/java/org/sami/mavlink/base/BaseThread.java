package org.sami.mavlink.base;

import java.lang.System.Logger.Level;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Executor;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;

/** The thread that owns the state of one base, or of several, so that it wakes as often for several as for one. Safe for use by several threads. */
public final class BaseThread implements AutoCloseable {
    /** Between two ticks. */
    static final long TICK_MS = 100;

    private static final System.Logger LOG = System.getLogger(BaseThread.class.getName());

    private final ScheduledThreadPoolExecutor executor;
    private final List<Runnable> ticks = new CopyOnWriteArrayList<>();

    /** A thread that runs. */
    public BaseThread() {
        executor = new ScheduledThreadPoolExecutor(1, work -> {
            Thread thread = new Thread(work, "mavlink base");
            thread.setDaemon(true);
            return thread;
        });
        executor.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
        var unused = executor.scheduleAtFixedRate(
                () -> ticks.forEach(BaseThread::run), TICK_MS, TICK_MS, TimeUnit.MILLISECONDS);
    }

    /** Runs work of a base; a fault in it is logged and goes no further. */
    static void run(Runnable work) {
        try {
            work.run();
        } catch (RuntimeException e) { // the ticks of all bases, or the rest of a batch, would end without a word
            LOG.log(Level.ERROR, "a fault in a base of vehicles", e);
        }
    }

    /** Runs work on the thread; throws {@link java.util.concurrent.RejectedExecutionException} after the end. */
    Executor executor() {
        return executor;
    }

    /** Runs work on the thread once a time has passed. */
    void later(Runnable work, long afterMs) {
        var unused = executor.schedule(work, afterMs, TimeUnit.MILLISECONDS);
    }

    /** Has work done at each tick. */
    void begin(Runnable tick) {
        ticks.add(tick);
    }

    /** Ends what {@link #begin} began. */
    void end(Runnable tick) {
        ticks.remove(tick);
    }

    /** Ends the thread. */
    @Override
    public void close() {
        executor.shutdown();
    }
}
