package org.sami.spn.host;

import java.lang.System.Logger.Level;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;

/** Calls listeners in the order in which they were added, each guarded from the others' faults and timed. */
final class Listeners {
    private static final System.Logger LOG = System.getLogger(Listeners.class.getName());

    private final List<Entry> entries = new CopyOnWriteArrayList<>();
    private final long slowNanos;
    private final AtomicLong slow = new AtomicLong();
    private final AtomicLong faults = new AtomicLong();

    Listeners(long slowMillis) {
        this.slowNanos = TimeUnit.MILLISECONDS.toNanos(slowMillis);
    }

    Registration add(HostListener listener) {
        Entry entry = new Entry(Objects.requireNonNull(listener, "listener"));
        entries.add(entry);
        return () -> entries.remove(entry);
    }

    boolean isEmpty() {
        return entries.isEmpty();
    }

    /** Calls each listener; whatever one throws is logged and counted, and the next is called. */
    @SuppressWarnings("CatchingUnchecked") // also what is thrown sneakily must not reach the engine
    void each(Consumer<HostListener> call) {
        for (Entry entry : entries) {
            long begin = System.nanoTime();
            try {
                call.accept(entry.listener);
            } catch (Exception | LinkageError | StackOverflowError | AssertionError fault) {
                faults.incrementAndGet();
                LOG.log(Level.ERROR, () -> "listener " + entry.name() + " threw and was ignored", fault);
            }
            reportIfSlow(entry, System.nanoTime() - begin);
        }
    }

    private void reportIfSlow(Entry entry, long nanos) {
        if (nanos > slowNanos) {
            slow.incrementAndGet();
            LOG.log(
                    Level.WARNING,
                    () -> "listener " + entry.name() + " held the engine for " + TimeUnit.NANOSECONDS.toMillis(nanos)
                            + " ms");
        }
    }

    long slow() {
        return slow.get();
    }

    long faults() {
        return faults.get();
    }

    /** Gives each registration an identity of its own, so that a listener that was added twice is removed once. */
    private static final class Entry {
        private final HostListener listener;

        Entry(HostListener listener) {
            this.listener = listener;
        }

        String name() {
            return listener.getClass().getName();
        }
    }
}
