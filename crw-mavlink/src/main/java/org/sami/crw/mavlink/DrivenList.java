package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.sami.boat.link.Progress;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.mission.MissionItem;

/**
 * A list of waypoints as a mission of an autopilot, and how far the vehicle is along it. Item 0 is the vehicle's home. Before a waypoint to which it goes at
 * another speed than to the one before stands an item that changes the speed; behind the last one stands an item with which it keeps its place there. Of a long
 * list the vehicle holds a part ({@link MissionWindow}); progress counts over the whole list.
 *
 * <p>What flies has the altitudes of its waypoints, metres over its home. Its list begins with a take-off to the altitude of the first waypoint, unless that is
 * on the ground, and a last waypoint on the ground is a landing, with which the mission ends.
 */
final class DrivenList {
    private static final int NAV_WAYPOINT = 16;
    private static final int NAV_LOITER_UNLIMITED = 17;
    private static final int NAV_LAND = 21;
    private static final int NAV_TAKE_OFF = 22;
    private static final double LAND_YAW = 1; // ArduPilot ignores it and says 1 when it is read back
    private static final int CHANGE_SPEED = 178;
    private static final int OVER_HOME = 3; // the frame of heights
    private static final int WITHOUT_PLACE = 2;
    private static final int GROUND_SPEED = 1;

    private final UploadWaypoints upload;
    private final boolean flies;
    private final List<Integer> itemOf = new ArrayList<>(); // by waypoint
    private final List<MissionItem> items = new ArrayList<>();
    private final int hint;
    private MissionWindow window;
    private boolean isWindowKnown; // else it is looked for in what the vehicle holds
    private int next;
    private int seen; // the most waypoints that were known to lie behind the vehicle since it was sent along the list
    private boolean completed;
    private boolean isReplacingStop; // of this window

    /** A list from its beginning. */
    DrivenList(UploadWaypoints upload) {
        this(upload, 0, false);
    }

    /** A list from its beginning, of a vehicle that flies or does not. */
    static DrivenList of(UploadWaypoints upload, boolean flies) {
        return new DrivenList(upload, 0, flies);
    }

    /**
     * A list that an earlier base gave to the vehicle.
     *
     * @param hint the end of the part that the vehicle was then known to hold
     * @param next the waypoint to which it was under way; their number where it had come to the end
     */
    static DrivenList kept(UploadWaypoints upload, int hint, int next, boolean flies) {
        DrivenList list = new DrivenList(upload, hint, flies);
        list.advance(next);
        return list;
    }

    private DrivenList(UploadWaypoints upload, int hint, boolean flies) {
        this.upload = upload;
        this.flies = flies;
        this.hint = hint;
        List<Waypoint> waypoints = upload.waypoints();
        completed = waypoints.isEmpty();
        if (!completed) {
            fill(waypoints);
        }
        window = MissionWindow.of(items, 1);
    }

    private void fill(List<Waypoint> waypoints) {
        items.add(at(0, NAV_WAYPOINT, waypoints.get(0))); // the autopilot puts its home there
        if (isInTheAir(0)) {
            items.add(at(1, NAV_TAKE_OFF, waypoints.get(0)));
        }
        Optional<Double> speed = Optional.empty();
        for (Waypoint waypoint : waypoints) {
            if (!speed.equals(Optional.of(waypoint.speedMps()))) {
                speed = Optional.of(waypoint.speedMps());
                items.add(new MissionItem(
                        items.size(), CHANGE_SPEED, WITHOUT_PLACE, 0, 0, 0, GROUND_SPEED, waypoint.speedMps(), -1, 0));
            }
            int command = flies && !isInTheAir(itemOf.size()) ? NAV_LAND : NAV_WAYPOINT;
            itemOf.add(items.size());
            items.add(at(items.size(), command, waypoint));
        }
        if (!lands()) {
            items.add(at(items.size(), NAV_LOITER_UNLIMITED, waypoints.get(waypoints.size() - 1)));
        }
    }

    private MissionItem at(int number, int command, Waypoint waypoint) {
        double altM = flies ? waypoint.altM() : 0;
        double yaw = command == NAV_LAND ? LAND_YAW : 0;
        return new MissionItem(number, command, OVER_HOME, waypoint.latDeg(), waypoint.lonDeg(), altM, 0, 0, 0, yaw);
    }

    private boolean isInTheAir(int waypoint) {
        return flies && waypoints().get(waypoint).altM() > CopterMotion.GROUND_M;
    }

    /** Whether it ends with a landing. */
    boolean lands() {
        return flies && !waypoints().isEmpty() && !isInTheAir(waypoints().size() - 1);
    }

    /** The waypoint on which it lands before its end, counted from 1; empty where it does not. */
    Optional<Integer> landingUnderWay() {
        return IntStream.range(0, waypoints().size() - 1)
                .filter(waypoint -> flies
                        && !isInTheAir(waypoint)
                        && IntStream.range(waypoint, waypoints().size()).anyMatch(this::isInTheAir))
                .mapToObj(waypoint -> waypoint + 1)
                .findFirst();
    }

    /** Whether a vehicle on the ground has nothing to do for it from a waypoint on. */
    boolean isOnTheGround(int from) {
        return flies && IntStream.range(from, waypoints().size()).noneMatch(this::isInTheAir);
    }

    /** The number of the item with which a copter on the ground begins; empty where the mission that it holds has none. */
    Optional<Integer> takeOffItem() {
        return !waypoints().isEmpty() && isInTheAir(0) && window.has(1)
                ? Optional.of(window.slot(1))
                : Optional.empty();
    }

    /** The altitude of the take-off with which it begins, metres over the vehicle's home; empty where it has none. */
    Optional<Double> takeOffM() {
        return waypoints().stream().findFirst().filter(first -> isInTheAir(0)).map(Waypoint::altM);
    }

    String id() {
        return upload.listId();
    }

    UploadWaypoints upload() {
        return upload;
    }

    List<Waypoint> waypoints() {
        return upload.waypoints();
    }

    // ---- what the vehicle holds of it

    /** The part of it that the vehicle holds, or is to hold. */
    MissionWindow window() {
        return window;
    }

    /** Another part of it. */
    void window(MissionWindow other) {
        isReplacingStop &= window == other;
        window = other;
        isWindowKnown = true;
    }

    /** The next part, and the order not to stop there once the vehicle has taken it, are on their way: it may drive past that before the base has read it back. */
    void replacesStop() {
        isReplacingStop = true;
    }

    /** The first item to which the vehicle cannot have come. */
    private int reach() {
        return isReplacingStop ? window.to() : window.stop();
    }

    /** All of it, for a vehicle that has room for it. */
    MissionWindow whole() {
        return MissionWindow.whole(items);
    }

    /** The part of it that a vehicle needs to drive from a waypoint on, or from its end. */
    MissionWindow windowFrom(int waypoint) {
        return MissionWindow.of(items, itemOf.get(Math.min(waypoint, itemOf.size() - 1)));
    }

    /** Whether the vehicle can drive to a waypoint with the part that it holds. */
    boolean has(int waypoint) {
        return window.has(itemOf.get(waypoint));
    }

    /** The part to send next to the vehicle as it drives; empty where nothing can be sent yet. */
    Optional<MissionWindow> nextWindow() {
        return completed ? Optional.empty() : window.next(itemOf.get(next));
    }

    /** How many waypoints come before an item of the whole list. */
    int waypointsUpTo(int item) {
        return (int) itemOf.stream().filter(each -> each < item).count();
    }

    /** The number that the item of a waypoint has in the mission of the vehicle. */
    int itemOf(int waypoint) {
        return window.slot(itemOf.get(waypoint));
    }

    /**
     * Whether a mission that a vehicle holds is this one, or the part of it that it is to hold. Where a part that an earlier base has brought there is found, that is
     * its part from then on.
     */
    boolean recognizes(List<MissionItem> held) {
        if (isWindowKnown) {
            return window.isHeld(held);
        }
        Optional<MissionWindow> found = MissionWindow.found(items, held, hint);
        found.ifPresent(this::window);
        return found.isPresent();
    }

    // ---- how far the vehicle is along it

    Progress progress() {
        return new Progress(id(), next, completed);
    }

    int next() {
        return next;
    }

    boolean isCompleted() {
        return completed;
    }

    /** It drives from a waypoint on. */
    void startAt(int waypoint) {
        next = waypoint;
        seen = waypoint;
        completed = false;
    }

    /** It drives on as it does, and progress counts from a waypoint that it may have passed. */
    void countFrom(int waypoint) {
        next = waypoint;
        completed = false;
    }

    /** The waypoint whose item has a number in the mission of the vehicle; empty where it is none of them. */
    Optional<Integer> waypointOf(int number) {
        return Optional.of(itemOf.indexOf(window.item(number))).filter(waypoint -> waypoint >= 0);
    }

    /** The vehicle reports an item of its mission as reached. Returns whether that is progress along the list. */
    boolean reached(int number) {
        int item = window.item(number);
        int before = itemOf.indexOf(item);
        return before >= 0 && item < reach() && advance(before + 1);
    }

    /** The vehicle reports the item to which it goes, so the waypoints before it are done. Returns whether that is progress. */
    boolean current(int number) {
        return advance(behind(number));
    }

    /** The waypoints that a vehicle would have passed, of which it has never said so, if it goes to an item of its mission. */
    List<Waypoint> passedBy(int number) {
        int behind = behind(number);
        return waypoints().subList(Math.min(passed(), behind), behind);
    }

    /** How many waypoints are known to lie behind the vehicle, also where progress counts from an earlier one. */
    int passed() {
        return Math.max(next, seen);
    }

    /** How many waypoints lie behind a vehicle that goes to an item of its mission; 0 where it cannot go there by the part that it holds. */
    private int behind(int number) {
        int item = window.item(number);
        return item > 0 && item <= reach() ? waypointsUpTo(item) : 0;
    }

    /** Whether a vehicle that goes to an item of its mission goes to a waypoint or to a later one. */
    boolean isPast(int number, int waypoint) {
        return window.item(number) >= itemOf.get(waypoint);
    }

    /** Marks that many waypoints as reached. Returns whether that is progress. */
    boolean advance(int behind) {
        if (behind <= next || completed) {
            return false;
        }
        next = behind;
        seen = Math.max(seen, next);
        completed = next == waypoints().size();
        return true;
    }
}
