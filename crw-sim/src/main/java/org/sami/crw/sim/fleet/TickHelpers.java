package org.sami.crw.sim.fleet;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.locks.LockSupport;
import java.util.function.IntConsumer;
import org.jspecify.annotations.Nullable;

/**
 * Threads that do the same for many while another one, the caller, does something else, again and again, each time for some hundred microseconds. When the
 * caller needs it done it takes part, a few at a time until none is left. It waits for nothing but what a helper has begun: where the machine has no core for
 * helpers, it does all itself, and where one has lost its core in between it does so for a while.
 *
 * <p>A helper without work spins for a while before it sleeps, because waking it takes as long as the work. For one calling thread; closed helpers
 * help no more.
 */
class TickHelpers implements AutoCloseable {
    private static final int AT_A_TIME = 8;
    private static final int SPINS = 2000; // some ten microseconds
    private static final long YIELD_NANOS = 20_000;
    private static final int LOST_CORE_PARKS = 10; // after so many parks the helper's core belongs to another process
    // ticks that the caller then computes alone: first the former, doubled up to the latter each time that a core is
    // lost
    // again within RESET_TIMES shared ticks
    private static final int LEAST_ALONE_TIMES = 50;
    private static final int MOST_ALONE_TIMES = 800;
    private static final int RESET_TIMES = 1000;
    // longer than the pause between two ticks of a run at full speed
    private static final long LOOKOUT_NANOS = 300_000;

    private final List<Helper> helpers = new ArrayList<>();
    private volatile Work work = new Work(0, i -> {});
    private Optional<Work> begun = Optional.empty(); // and not awaited yet; for the caller
    private int aloneFor; // so many times more
    private int aloneNext = LEAST_ALONE_TIMES;
    private int sharedTimes = RESET_TIMES; // since a helper lost its core
    private volatile boolean closed;

    /** Starts so many of them; with none, the caller does all itself. */
    TickHelpers(int count) {
        for (int i = 1; i <= count; i++) {
            Helper helper = new Helper("crw-ticks-" + i);
            helpers.add(helper);
            helper.start();
        }
    }

    /**
     * Begins to do something for each number from 0 on, in any order and on any of the threads; what was begun before is done.
     *
     * @param size how many
     */
    void begin(int size, IntConsumer action) {
        begun = Optional.of(new Work(size, action));
        if (aloneFor > 0) {
            aloneFor--;
            return;
        }
        work = begun.get();
        for (Helper helper : helpers) {
            helper.wake();
        }
    }

    /**
     * Returns when all that was begun is done; the caller does what nobody else does. What the action throws does not keep it from the other numbers; of
     * several faults that of the least number is thrown on, once.
     */
    void await() {
        if (begun.isPresent()) {
            Work awaited = begun.get();
            begun = Optional.empty();
            awaited.takePart();
            if (awaited.await() > LOST_CORE_PARKS) {
                goOnAlone();
            } else if (aloneFor == 0) {
                sharedTimes++;
            }
        }
    }

    private void goOnAlone() {
        aloneNext = sharedTimes < RESET_TIMES ? Math.min(MOST_ALONE_TIMES, 2 * aloneNext) : LEAST_ALONE_TIMES;
        aloneFor = aloneNext;
        sharedTimes = 0;
    }

    @Override
    public void close() {
        closed = true;
        helpers.forEach(LockSupport::unpark);
    }

    /** What is to be done for one call. */
    private static final class Work {
        private final int size;
        private final IntConsumer action;
        private final int batches;
        private final AtomicInteger taken = new AtomicInteger(); // batches, by all threads
        private final AtomicInteger takenByHelpers = new AtomicInteger();
        private final AtomicInteger done = new AtomicInteger();
        private int faultAt = Integer.MAX_VALUE;
        private @Nullable Throwable fault;

        Work(int size, IntConsumer action) {
            this.size = size;
            this.action = action;
            batches = (size + AT_A_TIME - 1) / AT_A_TIME;
        }

        /** The caller begins with the first, helpers with the last: most boats are at the same core in each tick, which has them in its cache. */
        void takePart() {
            for (int batch = 0; taken.getAndIncrement() < batches; batch++) {
                act(batch);
            }
        }

        void help() {
            while (taken.getAndIncrement() < batches) {
                act(batches - 1 - takenByHelpers.getAndIncrement());
            }
        }

        private void act(int batch) {
            int from = batch * AT_A_TIME;
            int to = Math.min(size, from + AT_A_TIME);
            for (int i = from; i < to; i++) {
                actOn(i);
            }
            done.addAndGet(to - from);
        }

        @SuppressWarnings("CatchingUnchecked") // the caller gets whatever it is
        private void actOn(int i) {
            try {
                action.accept(i);
            } catch (RuntimeException | Error thrown) {
                keep(i, thrown);
            }
        }

        private synchronized void keep(int i, Throwable thrown) {
            if (i < faultAt) {
                faultAt = i;
                fault = thrown;
            }
        }

        /**
         * Waits for what a helper has begun, which takes some microseconds, but for one that has lost its core.
         *
         * @return how often the caller has parked
         */
        int await() {
            int looks = 0;
            for (; done.get() < size; looks++) {
                if (looks < SPINS) {
                    Thread.onSpinWait();
                } else {
                    LockSupport.parkNanos(YIELD_NANOS);
                }
            }
            rethrow();
            return Math.max(0, looks - SPINS);
        }

        private synchronized void rethrow() {
            if (fault instanceof Error error) {
                throw error;
            } else if (fault != null) {
                throw (RuntimeException) fault;
            }
        }
    }

    private final class Helper extends Thread {
        private Work last = work; // of which this helper knows; for its own thread once that has started
        private volatile boolean sleeps;

        Helper(String name) {
            super(name);
            setDaemon(true);
        }

        void wake() {
            if (sleeps) {
                LockSupport.unpark(this);
            }
        }

        @Override
        public void run() {
            while (!closed) {
                Work next = work;
                if (next == last) {
                    awaitOther();
                } else {
                    next.help();
                    last = next;
                }
            }
        }

        private void awaitOther() {
            long until = System.nanoTime() + LOOKOUT_NANOS;
            while (work == last && !closed) {
                if (System.nanoTime() < until) {
                    Thread.onSpinWait();
                } else {
                    sleeps = true;
                    if (work == last && !closed) {
                        LockSupport.park(this);
                    }
                    sleeps = false;
                }
            }
        }
    }
}
