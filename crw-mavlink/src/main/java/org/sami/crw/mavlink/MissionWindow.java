package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sami.mavlink.mission.MissionItem;

/**
 * The part of a list of items that a vehicle holds. A list of at most {@link #MOST_WHOLE} items is held whole, each item in the slot of its number, and a longer
 * one too where the vehicle has room for it.
 *
 * <p>Else a longer one is held in parts, in a circular buffer: home in slot 0, {@link #SLOTS} slots, and behind them a jump back to slot 1. In front of the first
 * item that is not held stands the stop, an item with which the vehicle keeps its place: it never drives into old items. While the vehicle drives, the next
 * {@link #STEP} items are written into slots that it has left behind, with a stop of their own behind them, and only after the vehicle has taken them all, the old
 * stop is replaced by the item that belongs there. Immutable.
 *
 * <p>Source: ArduPilot's items 17 (keep the place) and 177 (jump, -1 for without end). It goes on along its leg while slots far from the vehicle are written,
 * but begins the leg again, from a standstill ({@link ChangeMoment}).
 */
final class MissionWindow {
    static final int MOST_WHOLE = 602; // autopilots hold some 650 items and more
    static final int SLOTS = 600; // sent in 12 s at the pace of an autopilot
    static final int STEP =
            300; // large, as each change is a stop on ArduPilot's boats; divides SLOTS, so that what is written never
    // spans both ends of the buffer

    private static final int KEPT = 10; // items behind the vehicle that are not overwritten
    private static final int NAV_LOITER_UNLIMITED = 17;
    private static final int JUMP = 177;
    private static final int FOREVER = -1;

    private final List<MissionItem> all;
    private final int to;
    private final int stop;
    private final boolean whole;

    /**
     * A part.
     *
     * @param all the items of the list, home first
     * @param to the first item that is not held, or the size of the list
     * @param stop where the vehicle stops; less than {@code to} while what lies between is being written
     */
    private MissionWindow(List<MissionItem> all, int to, int stop) {
        this(all, to, stop, all.size() <= MOST_WHOLE);
    }

    private MissionWindow(List<MissionItem> all, int to, int stop, boolean whole) {
        this.all = all;
        this.to = to;
        this.stop = stop;
        this.whole = whole;
    }

    /** All of a list, for a vehicle that has room for it. */
    static MissionWindow whole(List<MissionItem> all) {
        return new MissionWindow(all, all.size(), all.size(), true);
    }

    /** The part to hold for a vehicle that drives to an item. */
    static MissionWindow of(List<MissionItem> all, int item) {
        int end = all.size();
        if (end > MOST_WHOLE) {
            int reaches = Math.max(1, item - KEPT) + SLOTS - 1;
            end = reaches >= end ? end : reaches / STEP * STEP;
        }
        return new MissionWindow(all, end, end);
    }

    /**
     * The part that a vehicle is found to hold; empty where it holds another mission.
     *
     * @param hint the end of the part that it was last known to hold: of a list that leads twice along the same places the first that fits from there on counts
     */
    static Optional<MissionWindow> found(List<MissionItem> all, List<MissionItem> held, int hint) {
        if (whole(all).isHeld(held)) {
            return Optional.of(whole(all));
        }
        MissionWindow first = of(all, 1);
        int least = hint > first.to && (hint % STEP == 0 || hint == all.size()) && hint <= all.size() ? hint : first.to;
        List<MissionWindow> ends = new ArrayList<>();
        for (int end = least; end < all.size(); end += STEP) {
            ends.add(new MissionWindow(all, end, end));
        }
        ends.add(new MissionWindow(all, all.size(), all.size()));
        return ends.stream()
                .filter(each -> each.isHeld(held))
                .findFirst()
                .or(() -> ends.stream()
                        .filter(each -> each.to < all.size() && each.isBeingLengthened(held))
                        .map(MissionWindow::longer)
                        .findFirst());
    }

    /** Whether a base has ended while it sent the next part to a vehicle that held this one. */
    private boolean isBeingLengthened(List<MissionItem> held) {
        List<MissionItem> before = items();
        List<MissionItem> after = longer().items();
        return held.size() == before.size()
                && IntStream.range(1, held.size())
                        .allMatch(slot -> before.get(slot).isSameAs(held.get(slot))
                                || after.get(slot).isSameAs(held.get(slot)));
    }

    private MissionWindow longer() {
        return new MissionWindow(all, Math.min(to + STEP, all.size()), to);
    }

    /** The first item that is held. */
    private int from() {
        return whole ? 1 : to == all.size() ? to - SLOTS : to - SLOTS + 1;
    }

    /** The first item that is not held, or the size of the list. */
    int to() {
        return to;
    }

    /** Whether the vehicle, from where the part begins, comes to an item before it stops. */
    boolean has(int item) {
        return item >= from() && item < stop;
    }

    /** The slot in which an item is held. */
    int slot(int item) {
        return whole ? item : (item - 1) % SLOTS + 1;
    }

    /** The item that is held in a slot; the stop's number where that stands there, 0 for home and the jump. */
    int item(int slot) {
        if (whole) {
            return slot;
        }
        return slot < 1 || slot > SLOTS ? 0 : from() + Math.floorMod(slot - slot(from()), SLOTS);
    }

    /** The item in front of which the vehicle stops; the size of the list where it stops nowhere before the end. */
    int stop() {
        return stop;
    }

    /** Whether the vehicle holds this part up to its end, as far as is known. */
    boolean isComplete() {
        return stop == to;
    }

    /** The part with its stop at the end, once all before is there. */
    MissionWindow stoppingAtItsEnd() {
        return new MissionWindow(all, to, to);
    }

    /** The part to send to a vehicle that drives to an item, its stop still where it was; empty where nothing can be sent yet. */
    Optional<MissionWindow> next(int item) {
        if (!isComplete()) {
            return Optional.of(this);
        }
        return of(all, item).to > to ? Optional.of(longer()) : Optional.empty();
    }

    /** How many items the mission of the vehicle has, home included. */
    int size() {
        return whole ? all.size() : SLOTS + 2;
    }

    /** The mission that the vehicle is to hold, home first. */
    List<MissionItem> items() {
        if (whole) {
            return all;
        }
        List<MissionItem> slots = new ArrayList<>(Collections.nCopies(size(), all.get(0)));
        IntStream.range(from(), from() + SLOTS).forEach(item -> slots.set(slot(item), content(item)));
        slots.set(SLOTS + 1, MissionItem.command(SLOTS + 1, JUMP, 1, FOREVER, 0));
        return Collections.unmodifiableList(slots);
    }

    private MissionItem content(int item) {
        return item < all.size() && (item == stop || item == to)
                ? stop(item)
                : all.get(item).at(slot(item));
    }

    /** Keeps the place of the last waypoint before it. */
    private MissionItem stop(int item) {
        int before = item - 1;
        while (all.get(before).latDeg() == 0 && all.get(before).lonDeg() == 0) { // it has no place
            before--;
        }
        MissionItem place = all.get(before);
        return new MissionItem(
                slot(item),
                NAV_LOITER_UNLIMITED,
                place.frame(),
                place.latDeg(),
                place.lonDeg(),
                place.heightM(), // a copter stays as high as it is
                0,
                0,
                0,
                0);
    }

    /** Whether a vehicle that holds such a mission drives along the list up to the stop, or up to the end of this part. Homes are not compared. */
    boolean isHeld(List<MissionItem> held) {
        List<MissionItem> items = items();
        if (held.size() != items.size()) {
            return false;
        }
        if (whole) {
            return IntStream.range(1, items.size())
                    .allMatch(slot -> items.get(slot).isSameAs(held.get(slot)));
        }
        boolean isUpToTheStop = items.get(SLOTS + 1).isSameAs(held.get(SLOTS + 1))
                && IntStream.range(from(), Math.min(stop + 1, all.size()))
                        .allMatch(item -> items.get(slot(item)).isSameAs(held.get(slot(item))));
        return isUpToTheStop || (!isComplete() && stoppingAtItsEnd().isHeld(held));
    }
}
