package org.sami.work.postgres;

import java.io.IOException;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;

/** Takes runs and makes them, several side by side, until none is left on any machine: a run whose worker dies is made here. */
public final class RunLoop {
    private static final long LOOK_MILLIS = 500;

    private final SharedRuns runs;
    private final Job job;
    private final ExecutorService pool;
    private final BlockingQueue<Made> made = new LinkedBlockingQueue<>();
    private int underWay;

    /** Makes a run. */
    @FunctionalInterface
    public interface Job {
        /** What comes of a run; empty where it was stopped. A run that fails gives a result that says so. */
        Optional<String> make(int run);
    }

    private record Made(int run, Optional<String> result, Optional<Throwable> fault) {}

    private RunLoop(SharedRuns runs, Job job, ExecutorService pool) {
        this.runs = runs;
        this.job = job;
        this.pool = pool;
    }

    /**
     * Works until all is done, or somebody wants it to stop.
     *
     * @param threads how many runs this worker makes at a time
     * @param stop asked often; who wants it at once interrupts the caller's thread as well
     * @param progress receives on the caller's thread how far all machines are, some times a second
     * @return whether all is done, or given up
     * @throws IllegalStateException where a run broke the program; another worker may try it once more
     */
    public static boolean work(SharedRuns runs, int threads, Job job, BooleanSupplier stop, Consumer<Standing> progress)
            throws IOException {
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            return new RunLoop(runs, job, pool).until(threads, stop, progress);
        } finally {
            pool.shutdown();
        }
    }

    private boolean until(int threads, BooleanSupplier stop, Consumer<Standing> progress) throws IOException {
        boolean interrupted = false;
        while (!stop.getAsBoolean() && !interrupted) {
            begin(threads);
            Standing standing = runs.standing();
            progress.accept(standing);
            if (underWay == 0 && standing.isOver()) {
                return true;
            }
            try {
                keepAll(made.poll(LOOK_MILLIS, TimeUnit.MILLISECONDS));
            } catch (InterruptedException wantsAnEnd) {
                interrupted = true;
            }
        }
        keepAll(made.poll());
        return false;
    }

    private void begin(int threads) throws IOException {
        while (underWay < threads) {
            OptionalInt taken = runs.take();
            if (taken.isEmpty()) {
                return;
            }
            int run = taken.getAsInt();
            pool.execute(() -> made.add(make(run)));
            underWay++;
        }
    }

    private Made make(int run) {
        try {
            return new Made(run, job.make(run), Optional.empty());
        } catch (RuntimeException
                | Error fault) { // memory that runs out is one: the run is told of before the process ends
            return new Made(run, Optional.empty(), Optional.of(fault));
        }
    }

    private void keepAll(@Nullable Made first) throws IOException {
        for (Made next = first; next != null; next = made.poll()) {
            underWay--;
            keep(next);
        }
    }

    private void keep(Made done) throws IOException {
        if (done.fault().isPresent()) {
            runs.endsWorker(done.run());
            throw new IllegalStateException(
                    "run " + done.run() + " broke the program", done.fault().get());
        }
        if (done.result().isPresent()) {
            runs.done(done.run(), done.result().get());
        }
    }
}
