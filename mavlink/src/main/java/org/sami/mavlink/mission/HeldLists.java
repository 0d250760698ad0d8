package org.sami.mavlink.mission;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.sami.mavlink.vehicle.VehicleId;

/** The transfers of lists with one vehicle, one after the other, and what it held when it was read last. Used by one thread. */
public final class HeldLists {
    private final VehicleId vehicle;
    private final Consumer<Object> send;
    private final Map<HeldKind, List<MissionItem>> known = new EnumMap<>(HeldKind.class);
    private final Deque<Waiting> waiting = new ArrayDeque<>();
    private final RepeatedAnswers answers = new RepeatedAnswers();

    /** A transfer that is made when its turn comes, what it brings, and who waits for it. */
    private static final class Waiting {
        private final HeldKind kind;
        private final Supplier<ListTransfer> maker;
        private final CompletableFuture<List<MissionItem>> result;
        private Optional<ListTransfer> transfer = Optional.empty();

        Waiting(HeldKind kind, Supplier<ListTransfer> maker, CompletableFuture<List<MissionItem>> result) {
            this.kind = kind;
            this.maker = maker;
            this.result = result;
        }

        void begin(long nowMs) {
            ListTransfer made = maker.get();
            transfer = Optional.of(made);
            made.begin(nowMs);
        }

        boolean isOver() {
            return transfer.filter(ListTransfer::isOver).isPresent();
        }
    }

    /**
     * No transfers yet.
     *
     * @param send sends a message of the library to the vehicle; may lose it
     */
    public HeldLists(VehicleId vehicle, Consumer<Object> send) {
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.send = Objects.requireNonNull(send, "send");
    }

    /** Reads a list. */
    public void read(HeldKind kind, long nowMs, CompletableFuture<List<MissionItem>> result) {
        add(new Waiting(kind, () -> new ListDownload(vehicle, kind, send), result), nowMs);
    }

    /** Replaces a list, in steps where there are several ({@link ListReplacement}); the result is what was read back. */
    public void replace(
            HeldKind kind, List<List<MissionItem>> lists, long nowMs, CompletableFuture<List<MissionItem>> result) {
        Supplier<ListTransfer> maker =
                () -> new ListReplacement(vehicle, kind, lists, Optional.ofNullable(known.get(kind)), send);
        add(new Waiting(kind, maker, result), nowMs);
    }

    private void add(Waiting next, long nowMs) {
        waiting.addLast(next);
        if (waiting.size() == 1) {
            next.begin(nowMs);
        }
    }

    /** The vehicle started again, or somebody else may have changed its lists. */
    public void forget() {
        known.clear();
    }

    /**
     * Takes what the vehicle sent. An answer that comes once more, as its datagram was doubled on the way, changes nothing: it would count for the next transfer.
     *
     * @param number the vehicle's number of the message ({@link org.sami.mavlink.link.ReceivedMessage})
     */
    public void take(Object message, int number, long nowMs) {
        if (answers.isRepeated(message, number, nowMs)) {
            return;
        }
        now().ifPresent(transfer -> transfer.take(message, nowMs));
        goOn(nowMs);
    }

    /** Whether a list is being read or sent, or waits for that. */
    public boolean isBusy() {
        return !waiting.isEmpty();
    }

    /** Sends again what is overdue. */
    public void tick(long nowMs) {
        now().ifPresent(transfer -> transfer.tick(nowMs));
        goOn(nowMs);
    }

    private Optional<ListTransfer> now() {
        return Optional.ofNullable(waiting.peekFirst()).flatMap(first -> first.transfer);
    }

    private void goOn(long nowMs) {
        while (!waiting.isEmpty() && waiting.getFirst().isOver()) {
            Waiting over = waiting.removeFirst();
            report(over);
            if (!waiting.isEmpty()) {
                waiting.getFirst().begin(nowMs);
            }
        }
    }

    private void report(Waiting over) {
        ListTransfer transfer = over.transfer.orElseThrow();
        if (transfer.failure().isPresent()) {
            known.remove(over.kind);
            over.result.completeExceptionally(transfer.failure().get());
            return;
        }
        List<MissionItem> items = transfer instanceof ListReplacement replacement
                ? replacement.readBack()
                : ((ListDownload) transfer).items();
        known.put(over.kind, items);
        over.result.complete(items);
    }

    /** Ends all that is open. */
    public void close() {
        waiting.forEach(each -> each.result.completeExceptionally(new IllegalStateException("the links are closed")));
        waiting.clear();
    }
}
