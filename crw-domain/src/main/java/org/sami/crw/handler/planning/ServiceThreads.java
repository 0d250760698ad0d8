package org.sami.crw.handler.planning;

import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.TimeUnit;
import java.util.function.BiConsumer;

/**
 * Threads for the computations of services, separate from the fleet's: sessions in real time have to keep their links alive meanwhile. A computation
 * beyond a time limit is given up.
 */
public final class ServiceThreads implements AutoCloseable {
    /** The time after which an operator would ask for something else. */
    public static final long STANDARD_LIMIT_MILLIS = 60_000;

    private static final long SLOW_MILLIS = 5000;
    private static final int THREADS = 2;

    private final long limitMillis;
    private final BiConsumer<String, Throwable> onFault;
    private final ExecutorService threads = Executors.newFixedThreadPool(THREADS, daemons("service"));
    private final ScheduledExecutorService timeouts =
            Executors.newSingleThreadScheduledExecutor(daemons("service-timeouts"));

    /** Threads with a limit for each computation. */
    public ServiceThreads(long limitMillis) {
        this(limitMillis, (thread, fault) -> {});
    }

    /**
     * The same.
     *
     * @param onFault receives the thread's name and the error that the machine throws at a computation, which then fails
     */
    public ServiceThreads(long limitMillis, BiConsumer<String, Throwable> onFault) {
        this.limitMillis = limitMillis;
        this.onFault = onFault;
    }

    /** The machine threw something at a computation. */
    void fault(Throwable thrown) {
        onFault.accept(Thread.currentThread().getName(), thrown);
    }

    private static ThreadFactory daemons(String name) {
        return action -> {
            Thread thread = new Thread(action, name);
            thread.setDaemon(true);
            return thread;
        };
    }

    Future<?> start(Runnable work) {
        return threads.submit(work);
    }

    /** Has something computed that nobody gives up; nothing when the threads are closed. What it throws goes to the thread's handler of faults. */
    void execute(Runnable work) {
        try {
            threads.execute(work);
        } catch (RejectedExecutionException closed) {
            // nobody wants to know it any more
        }
    }

    /** Has somebody look after a computation: every few seconds, and when its time is over. */
    Future<?> lookAfter(Runnable progress) {
        return timeouts.scheduleAtFixedRate(
                progress,
                Math.min(SLOW_MILLIS, limitMillis),
                Math.min(SLOW_MILLIS, limitMillis),
                TimeUnit.MILLISECONDS);
    }

    long limitMillis() {
        return limitMillis;
    }

    /** Gives up what is being computed. */
    @Override
    public void close() {
        timeouts.shutdownNow();
        threads.shutdownNow();
    }
}
