package org.sami.crw.session;

import java.util.Objects;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.Executor;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.PriorityBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * The engine's thread of a session in real time, as an executor and as a scheduler: does one after another what it is given and
 * what has come due. Time counts on from a start by a steady clock; setting the machine's clock changes nothing.
 *
 * <p>Work and actions may be given from any thread; one thread calls {@link #run}.
 */
public final class RealTimeLoop implements Executor, Scheduler {
    /** No wait is longer, so that neither who wants an end nor who schedules from elsewhere need wake it. */
    private static final long LONGEST_WAIT_MS = 50;

    private final long startMs;
    private final LongSupplier clockMs;
    private final long originMs;
    private final BlockingQueue<Runnable> posted = new LinkedBlockingQueue<>();
    private final PriorityBlockingQueue<Entry> timed = new PriorityBlockingQueue<>();
    private final AtomicLong scheduled = new AtomicLong();

    /**
     * A loop whose time begins now.
     *
     * @param startMs its time now: 0, or where an earlier process came to
     * @param steadyMs milliseconds that never run back
     */
    public RealTimeLoop(long startMs, LongSupplier steadyMs) {
        this.startMs = startMs;
        this.clockMs = Objects.requireNonNull(steadyMs, "steadyMs");
        originMs = steadyMs.getAsLong();
    }

    @Override
    public long nowMs() {
        return startMs + clockMs.getAsLong() - originMs;
    }

    @Override
    public void execute(Runnable work) {
        posted.add(Objects.requireNonNull(work, "work"));
    }

    @Override
    public void at(long timeMs, Runnable action) {
        timed.add(new Entry(timeMs, scheduled.getAndIncrement(), Objects.requireNonNull(action, "action")));
    }

    /** Every so often from now on, the first time at once; never twice for a time that was missed. */
    public void every(long periodMs, Runnable action) {
        action.run();
        after(periodMs, () -> every(periodMs, action));
    }

    /** Works until somebody wants an end, which is asked before each piece of work, or the thread is interrupted. What work throws ends it. */
    public void run(BooleanSupplier isOver) {
        run(isOver, fault -> {
            if (fault instanceof Error error) {
                throw error;
            }
            throw (RuntimeException) fault;
        });
    }

    /**
     * As {@link #run(BooleanSupplier)}, and goes on after work that threw something.
     *
     * @param onFault is given what was thrown, a {@link RuntimeException} or an {@link Error}
     */
    public void run(BooleanSupplier isOver, Consumer<Throwable> onFault) {
        try {
            while (!isOver.getAsBoolean()) {
                Runnable next = next();
                if (next != null) {
                    run(next, onFault);
                }
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private static void run(Runnable work, Consumer<Throwable> onFault) {
        try {
            work.run();
        } catch (RuntimeException | Error fault) {
            onFault.accept(fault);
        }
    }

    /** What is to be done now; null if nothing has come for a while. What was posted goes first, unless something is overdue. */
    private Runnable next() throws InterruptedException {
        long untilDueMs = untilDue();
        if (untilDueMs < -LONGEST_WAIT_MS) {
            return timed.remove().action;
        }
        Runnable work = posted.poll(Math.max(0, Math.min(LONGEST_WAIT_MS, untilDueMs)), TimeUnit.MILLISECONDS);
        return work == null && untilDue() <= 0 ? timed.remove().action : work;
    }

    private long untilDue() {
        Entry first = timed.peek();
        return first == null ? Long.MAX_VALUE : first.timeMs - nowMs();
    }

    private record Entry(long timeMs, long order, Runnable action) implements Comparable<Entry> {
        @Override
        public int compareTo(Entry other) {
            int byTime = Long.compare(timeMs, other.timeMs);
            return byTime != 0 ? byTime : Long.compare(order, other.order);
        }
    }
}
