package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.Progress;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.mission.MissionItem;

/**
 * A list of waypoints as a mission of an autopilot, and how far the vehicle is along it. Item 0 is the vehicle's home. Before a waypoint to which it goes at
 * another speed than to the one before stands an item that changes the speed; behind the last one stands an item with which it keeps its place there.
 */
final class DrivenList {
    private static final int NAV_WAYPOINT = 16;
    private static final int NAV_LOITER_UNLIMITED = 17;
    private static final int CHANGE_SPEED = 178;
    private static final int ON_THE_GROUND = 3; // the frame: height over home
    private static final int WITHOUT_PLACE = 2;
    private static final int GROUND_SPEED = 1;

    private final UploadWaypoints upload;
    private final List<Integer> itemOf = new ArrayList<>(); // by waypoint
    private final List<MissionItem> items = new ArrayList<>();
    private int next;
    private boolean completed;

    DrivenList(UploadWaypoints upload) {
        this.upload = upload;
        List<Waypoint> waypoints = upload.waypoints();
        if (waypoints.isEmpty()) {
            completed = true;
            return;
        }
        items.add(at(0, NAV_WAYPOINT, waypoints.get(0))); // the autopilot puts its home there
        Optional<Double> speed = Optional.empty();
        for (Waypoint waypoint : waypoints) {
            if (!speed.equals(Optional.of(waypoint.speedMps()))) {
                speed = Optional.of(waypoint.speedMps());
                items.add(new MissionItem(
                        items.size(), CHANGE_SPEED, WITHOUT_PLACE, 0, 0, 0, GROUND_SPEED, waypoint.speedMps(), -1, 0));
            }
            itemOf.add(items.size());
            items.add(at(items.size(), NAV_WAYPOINT, waypoint));
        }
        items.add(at(items.size(), NAV_LOITER_UNLIMITED, waypoints.get(waypoints.size() - 1)));
    }

    private static MissionItem at(int number, int command, Waypoint waypoint) {
        return new MissionItem(number, command, ON_THE_GROUND, waypoint.latDeg(), waypoint.lonDeg(), 0, 0, 0, 0, 0);
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

    /** The items of the mission, home first. */
    List<MissionItem> items() {
        return List.copyOf(items);
    }

    /** The item of a waypoint. */
    int itemOf(int waypoint) {
        return itemOf.get(waypoint);
    }

    /** Whether a mission that a vehicle holds is this one, but for its home. */
    boolean isHeld(List<MissionItem> held) {
        if (held.size() != items.size()) {
            return false;
        }
        for (int i = 1; i < items.size(); i++) {
            if (!items.get(i).isSameAs(held.get(i))) {
                return false;
            }
        }
        return true;
    }

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
        completed = false;
    }

    /** The vehicle reports an item as reached. Returns whether that is progress along the list. */
    boolean reached(int item) {
        int before = itemOf.indexOf(item);
        return before >= 0 && advance(before + 1);
    }

    /** The vehicle reports the item to which it goes, so the waypoints before it are done. Returns whether that is progress. */
    boolean current(int item) {
        int behind = (int) itemOf.stream().filter(each -> each < item).count();
        return item > 0 && advance(behind);
    }

    /** Marks that many waypoints as reached. Returns whether that is progress. */
    boolean advance(int behind) {
        if (behind <= next || completed) {
            return false;
        }
        next = behind;
        completed = next == waypoints().size();
        return true;
    }
}
