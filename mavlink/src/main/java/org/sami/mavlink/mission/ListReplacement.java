package org.sami.mavlink.mission;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.IntStream;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Replaces a list that a vehicle holds, and reads it back: only a list that came back equal counts. Where it is known what the vehicle holds and only a part of
 * it differs, that part is sent alone. A list that comes back different is sent again, whole, and so is one
 * of which a part is refused; what the vehicle refuses whole is not sent again.
 *
 * <p>It may be replaced in steps, each a list: the next one is sent once the vehicle has said that it has taken the one before, or has been read to hold it; the
 * last one is read back.
 */
public final class ListReplacement extends AbstractListTransfer {
    private static final int ROUNDS = 3;

    private final VehicleId vehicle;
    private final HeldKind kind;
    private final Deque<List<MissionItem>> later = new ArrayDeque<>(); // the lists of the steps after this one
    private final Consumer<Object> send;
    private List<MissionItem> items;
    private List<MissionItem> readBack = List.of();
    private int rounds = 1;
    private ListTransfer step;

    /**
     * A transfer that is not begun yet.
     *
     * @param lists the new list, numbered from 0 in its order, after those of the steps before. Item 0 of a mission is the vehicle's home, which it keeps as it is
     * @param known what the vehicle held when it was read last; empty where it was not
     */
    public ListReplacement(
            VehicleId vehicle,
            HeldKind kind,
            List<List<MissionItem>> lists,
            Optional<List<MissionItem>> known,
            Consumer<Object> send) {
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.kind = Objects.requireNonNull(kind, "kind");
        this.send = Objects.requireNonNull(send, "send");
        lists.stream().map(ListReplacement::numbered).forEach(later::addLast);
        items = later.removeFirst();
        step = known.flatMap(this::part).orElseGet(this::whole);
    }

    private static List<MissionItem> numbered(List<MissionItem> items) {
        return IntStream.range(0, items.size())
                .mapToObj(i -> items.get(i).at(i))
                .toList();
    }

    private ListTransfer whole() {
        return items.isEmpty()
                ? new ListClearing(vehicle, kind, send)
                : new ListUpload(vehicle, kind, items, 0, items.size(), send);
    }

    /** Sends the part that differs; empty where the whole list must be sent. */
    private Optional<ListTransfer> part(List<MissionItem> known) {
        int[] differ = IntStream.range(firstCompared(), items.size())
                .filter(i -> i >= known.size() || !items.get(i).isSameAs(known.get(i)))
                .toArray();
        if (known.size() != items.size() || items.isEmpty()) {
            return Optional.empty();
        }
        if (differ.length == 0) {
            return Optional.of(new ListDownload(vehicle, kind, send));
        }
        int from = differ[0];
        int to = differ[differ.length - 1] + 1;
        return kind == HeldKind.MISSION && 2 * (to - from) <= items.size()
                ? Optional.of(new ListUpload(vehicle, kind, items, from, to, send))
                : Optional.empty();
    }

    private int firstCompared() {
        return kind == HeldKind.MISSION ? 1 : 0;
    }

    @Override
    public void begin(long nowMs) {
        step.begin(nowMs);
    }

    @Override
    public void tick(long nowMs) {
        step.tick(nowMs);
        goOn(nowMs);
    }

    @Override
    public void take(Object message, long nowMs) {
        step.take(message, nowMs);
        goOn(nowMs);
    }

    private void goOn(long nowMs) {
        if (isOver() || !step.isOver()) {
            return;
        }
        if (step.failure().isPresent()) {
            boolean wasPart = step instanceof ListUpload upload && upload.isPart();
            again(step.failure().get(), wasPart, nowMs);
        } else if (step instanceof ListDownload download) {
            readBack = download.items();
            difference()
                    .ifPresentOrElse(
                            why -> again(new IllegalStateException(why), true, nowMs), () -> isHeld(readBack, nowMs));
        } else if (!later.isEmpty() && step instanceof ListUpload upload && upload.isTaken()) {
            isHeld(items, nowMs);
        } else {
            next(new ListDownload(vehicle, kind, send), nowMs);
        }
    }

    private void isHeld(List<MissionItem> held, long nowMs) {
        if (later.isEmpty()) {
            succeed();
        } else {
            items = later.removeFirst();
            next(part(held).orElseGet(this::whole), nowMs);
        }
    }

    private void again(IllegalStateException why, boolean worthIt, long nowMs) {
        if (worthIt && rounds < ROUNDS) {
            rounds++;
            next(whole(), nowMs);
        } else {
            fail(why);
        }
    }

    private void next(ListTransfer transfer, long nowMs) {
        step = transfer;
        step.begin(nowMs);
    }

    private Optional<String> difference() {
        String head = "vehicle " + vehicle + " holds another " + kind.words() + " than it was sent: ";
        // an empty mission comes back as home alone, or as nothing
        boolean sameLength = readBack.size() == items.size()
                || (kind == HeldKind.MISSION && items.isEmpty() && readBack.size() == 1);
        if (!sameLength) {
            return Optional.of(head + readBack.size() + " items and not " + items.size());
        }
        return IntStream.range(firstCompared(), items.size())
                .filter(i -> !items.get(i).isSameAs(readBack.get(i)))
                .mapToObj(i -> head + "item " + i + " is " + readBack.get(i) + " and not " + items.get(i))
                .findFirst();
    }

    /** What the vehicle holds, as it was read back; empty until the transfer has ended well. */
    public List<MissionItem> readBack() {
        return isDone() ? readBack : List.of();
    }
}
