package org.sami.spn.host;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Predicate;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;

/**
 * What waits for the engine: postings from any thread, in order, unbounded but counted; and awaited telemetry, of which
 * only the latest per type and named robots is kept, so that it is bounded by the fleet.
 */
final class InputQueue {
    private final ConcurrentLinkedQueue<List<QueuedInput>> postings = new ConcurrentLinkedQueue<>();
    private final Map<Source, Occurrence> telemetry = new LinkedHashMap<>();
    private final AtomicLong queued = new AtomicLong();
    private final AtomicLong most = new AtomicLong();
    private final AtomicLong replaced = new AtomicLong();

    void add(List<QueuedInput> posting) {
        long now = queued.addAndGet(posting.size());
        if (now > most.get()) {
            most.accumulateAndGet(now, Math::max);
        }
        postings.add(posting);
    }

    void addTelemetry(Occurrence occurrence) {
        synchronized (telemetry) {
            if (telemetry.put(new Source(occurrence.type(), occurrence.proxies()), occurrence) != null) {
                replaced.incrementAndGet();
            }
        }
    }

    boolean isEmpty() {
        if (!postings.isEmpty()) {
            return false;
        }
        synchronized (telemetry) {
            return telemetry.isEmpty();
        }
    }

    /** Whole postings, until there are at least so many inputs or none waits. */
    List<QueuedInput> take(int atLeast) {
        List<QueuedInput> batch = new ArrayList<>();
        while (batch.size() < atLeast) {
            List<QueuedInput> posting = postings.poll();
            if (posting == null) {
                break;
            }
            batch.addAll(posting);
        }
        queued.addAndGet(-batch.size());
        return batch;
    }

    /** The waiting telemetry that is still needed; the rest is dropped. */
    List<QueuedInput> takeTelemetry(Predicate<String> wanted) {
        List<Occurrence> latest;
        synchronized (telemetry) {
            if (telemetry.isEmpty()) {
                return List.of();
            }
            latest = new ArrayList<>(telemetry.values());
            telemetry.clear();
        }
        List<QueuedInput> inputs = new ArrayList<>();
        for (Occurrence occurrence : latest) {
            if (wanted.test(occurrence.type())) {
                inputs.add(QueuedInput.of(new Input.Received(occurrence)));
            }
        }
        return inputs;
    }

    /** Lets go of everything; gives how many inputs that were. */
    long clear() {
        return take(Integer.MAX_VALUE).size();
    }

    long queued() {
        return queued.get();
    }

    long mostQueued() {
        return most.get();
    }

    long telemetryReplaced() {
        return replaced.get();
    }

    private record Source(String type, List<String> proxies) {}
}
