package org.sami.crw.session;

import java.io.Closeable;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.Executor;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.session.fault.ThreadGuard;

/** The threads of a session and its time: in real time threads of its own, else the caller's one thread. */
final class SessionThreads implements Closeable {
    /** On the caller's one thread nobody waits for a listener but the caller. */
    private static final long NEVER_SLOW_MILLIS = Long.MAX_VALUE;

    private static final long SLOW_MILLIS = 50;

    /** In simulated time ten looks a second would take longer than all else, and nobody watches that closely. */
    private static final long ONE_THREAD_SHOW_MS = 10_000;

    /** So many boats' pictures come at once. */
    private static final int MOST_FETCHING = 4;

    private static final int IDLE_S = 10;

    private final ThreadGuard guard;
    private final Optional<RealTimeLoop> loop;
    private final Scheduler scheduler;
    private final Executor engine;
    private final Executor front;
    private final Executor files;
    private final Executor drawing;
    private final Executor fetching;
    private final List<ExecutorService> own = new ArrayList<>();
    private final CompletableFuture<Void> ended = new CompletableFuture<>();
    private volatile boolean halted;

    /**
     * The engine's thread does not run yet.
     *
     * @param startMillis the session's time now
     */
    SessionThreads(SessionRuntime runtime, long startMillis, ThreadGuard guard) {
        this.guard = guard;
        if (runtime instanceof SessionRuntime.RealTime real) {
            RealTimeLoop running = new RealTimeLoop(startMillis, real.clock());
            loop = Optional.of(running);
            scheduler = running;
            engine = running;
            front = real.front().orElseGet(() -> newThread("session", guard));
            files = newThread("files", this::lost);
            drawing = newThread("map", this::lost);
            fetching = newPool("pictures", MOST_FETCHING);
        } else {
            SessionRuntime.OneThread one = (SessionRuntime.OneThread) runtime;
            loop = Optional.empty();
            scheduler = one.clock();
            engine = one.executor();
            front = one.executor();
            files = one.executor();
            drawing = Runnable::run;
            fetching = Runnable::run;
        }
    }

    private void lost(Thread thread, Throwable fault) {
        guard.lost(thread.getName(), fault);
    }

    private ExecutorService newThread(String name, Thread.UncaughtExceptionHandler handler) {
        ExecutorService made = Executors.newSingleThreadExecutor(work -> {
            Thread thread = new Thread(work, name);
            thread.setDaemon(true);
            thread.setUncaughtExceptionHandler(handler);
            return thread;
        });
        own.add(made);
        return made;
    }

    /** Threads that end while there is nothing to do. */
    private ExecutorService newPool(String name, int most) {
        ThreadPoolExecutor made =
                new ThreadPoolExecutor(most, most, IDLE_S, TimeUnit.SECONDS, new LinkedBlockingQueue<>(), work -> {
                    Thread thread = new Thread(work, name);
                    thread.setDaemon(true);
                    thread.setUncaughtExceptionHandler(this::lost);
                    return thread;
                });
        made.allowCoreThreadTimeOut(true);
        own.add(made);
        return made;
    }

    /** Whether they are threads of the session's own, in real time. */
    boolean isRealTime() {
        return loop.isPresent();
    }

    /** The session's time; its actions run on the engine's thread. */
    Scheduler scheduler() {
        return scheduler;
    }

    long nowMs() {
        return scheduler.nowMs();
    }

    Executor engine() {
        return engine;
    }

    /** Where models live and results arrive. */
    Executor front() {
        return front;
    }

    /** Reads and writes files. */
    Executor files() {
        return files;
    }

    /** Computes what is only to be drawn or judged. */
    Executor drawing() {
        return drawing;
    }

    /** Waits for boats' files. */
    Executor fetching() {
        return fetching;
    }

    /** How long a listener may hold up the engine or the fleet, in milliseconds, before that is logged. */
    long slowMillis() {
        return isRealTime() ? SLOW_MILLIS : NEVER_SLOW_MILLIS;
    }

    /** How often models look at what changes by itself, in milliseconds. */
    long showMillis() {
        return isRealTime() ? OperatorModels.SHOW_MILLIS : ONE_THREAD_SHOW_MS;
    }

    /** Starts the engine's thread, if it is the session's own. */
    void start() {
        loop.ifPresent(real -> {
            Thread thread = new Thread(() -> run(real), "engine");
            thread.setDaemon(true);
            thread.start();
        });
    }

    private void run(RealTimeLoop real) {
        try {
            real.run(() -> halted, fault -> guard.caught("engine", fault));
        } finally {
            ended.complete(null);
        }
    }

    /** The engine's thread ends after its present work. The stage completes then. */
    CompletionStage<Void> halt() {
        halted = true;
        return ended;
    }

    @Override
    public void close() {
        own.forEach(ExecutorService::shutdown);
    }
}
