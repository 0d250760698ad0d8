package org.sami.spn.host;

import java.lang.System.Logger.Level;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BiConsumer;
import java.util.function.Consumer;

/**
 * Calls listeners in the order in which they were added, each guarded from the others' faults. Every notification of several
 * listeners goes through this. Listeners may be added and removed from any thread.
 */
public final class ListenerList<L> {
    private static final System.Logger LOG = System.getLogger(ListenerList.class.getName());

    private final List<Entry<L>> entries = new CopyOnWriteArrayList<>();
    private final String held;
    private final long slowNanos;
    private final boolean isTimed;
    private final AtomicLong slow = new AtomicLong();
    private final AtomicLong faults = new AtomicLong();

    /** A list without listeners, which may take their time. */
    public ListenerList() {
        this("", Long.MAX_VALUE);
    }

    /**
     * A list without listeners that must be quick.
     *
     * @param held what a slow listener delays, such as {@code the engine}; for the log
     * @param slowMillis from how many milliseconds on a call is logged and counted as slow; with {@link Long#MAX_VALUE} none is timed
     */
    public ListenerList(String held, long slowMillis) {
        this.held = Objects.requireNonNull(held, "held");
        this.slowNanos = TimeUnit.MILLISECONDS.toNanos(slowMillis);
        isTimed = slowMillis < Long.MAX_VALUE;
    }

    /** Adds a listener, to be called last. One that is added twice is called twice. */
    public Registration add(L listener) {
        Entry<L> entry = new Entry<>(Objects.requireNonNull(listener, "listener"));
        entries.add(entry);
        return () -> entries.remove(entry);
    }

    /** Whether there is nobody to call. */
    public boolean isEmpty() {
        return entries.isEmpty();
    }

    /** Calls each listener; whatever one throws is logged and counted, and the next is called. */
    public void each(Consumer<? super L> call) {
        each(call, (listener, fault) -> {});
    }

    /**
     * Calls each listener; whatever one throws is logged and counted, and the next is called.
     *
     * @param onFault receives, after all calls, which listener threw what; must not throw
     */
    @SuppressWarnings("CatchingUnchecked") // also what is thrown sneakily must not reach the caller
    public void each(Consumer<? super L> call, BiConsumer<? super L, Throwable> onFault) {
        List<Runnable> reports = List.of();
        long begin = isTimed ? System.nanoTime() : 0;
        for (Entry<L> entry : entries) {
            try {
                call.accept(entry.listener);
            } catch (Exception | LinkageError | StackOverflowError | AssertionError fault) {
                faults.incrementAndGet();
                LOG.log(Level.ERROR, () -> "listener " + entry.name() + " threw and was ignored", fault);
                reports = new ArrayList<>(reports);
                reports.add(() -> onFault.accept(entry.listener, fault));
            }
            if (isTimed) {
                long end = System.nanoTime();
                reportIfSlow(entry, end - begin);
                begin = end;
            }
        }
        if (!reports.isEmpty()) {
            reports.forEach(Runnable::run);
        }
    }

    private void reportIfSlow(Entry<L> entry, long nanos) {
        if (nanos > slowNanos) {
            slow.incrementAndGet();
            LOG.log(
                    Level.WARNING,
                    () -> "listener " + entry.name() + " held " + held + " for " + TimeUnit.NANOSECONDS.toMillis(nanos)
                            + " ms");
        }
    }

    /** How many calls took longer than they should. */
    public long slow() {
        return slow.get();
    }

    /** How many calls threw. */
    public long faults() {
        return faults.get();
    }

    /** Gives each registration an identity of its own, so that a listener that was added twice is removed once. */
    private static final class Entry<L> {
        private final L listener;

        Entry(L listener) {
            this.listener = listener;
        }

        String name() {
            return listener.getClass().getName();
        }
    }
}
