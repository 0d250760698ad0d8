package org.sami.boat.mavlink;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.Progress;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OnboardState.MissionProgress;

/**
 * The mission that ground stations have sent, and how far the boat is with it. It reaches the boat when it is started, so that what a station only prepares changes nothing. For
 * the boat's thread.
 */
final class BoatMission {
    private static final double MS = 1000;

    private final BoatClient boat;
    private List<MissionItem> items = List.of();
    private MissionPath path = MissionPath.none();
    private String listId = "";
    private int next; // waypoint
    private boolean isDone;
    private boolean isUnderWay;
    private boolean isOfBase; // a base's list, which is only shown
    private long waitsUntilMs = Long.MIN_VALUE;

    BoatMission(BoatClient boat) {
        this.boat = boat;
    }

    /** Takes a mission in place of the one before; nothing is sent to the boat. */
    void replace(List<MissionItem> mission) {
        items = List.copyOf(mission);
        path = MissionPath.none();
        listId = "";
        next = 0;
        isDone = false;
        isUnderWay = false;
        isOfBase = false;
    }

    /** Shows the list that a base has sent the boat as if it were a mission. */
    void show(List<MissionItem> mission, String list) {
        replace(mission);
        path = MissionPath.of(mission, 1, 1, Optional.empty());
        listId = list;
        isOfBase = true;
    }

    /** Whether there is nothing to go to. */
    boolean isEmpty(Optional<Waypoint> home) {
        return MissionPath.of(items, 1, 1, home).waypoints().isEmpty();
    }

    /** Whether the boat holds this list of it. */
    boolean isList(String id) {
        return !listId.isEmpty() && listId.equals(id);
    }

    /** The part that is carried out where it is started. */
    MissionPath ahead(Optional<Waypoint> home) {
        MissionPath whole = MissionPath.of(items, 1, 1, home);
        return isDone || next >= whole.waypoints().size() ? whole : whole.from(next);
    }

    /** The part that is carried out where it goes on at an item; no waypoint where none is at this item or a later one. */
    MissionPath aheadAt(int item, Optional<Waypoint> home) {
        MissionPath whole = MissionPath.of(items, 1, 1, home);
        return whole.from(whole.waypointOf(item));
    }

    /** Why it cannot be started; empty where it is under way. */
    Optional<String> start(double speedMps, double mostMps, Optional<Waypoint> home, long nowMs) {
        path = MissionPath.of(items, speedMps, mostMps, home);
        if (path.waypoints().isEmpty()) {
            return Optional.of("there is no mission");
        }
        if (isDone || next >= path.waypoints().size()) {
            next = 0;
        }
        isDone = false;
        isOfBase = false;
        waitsUntilMs = Long.MIN_VALUE;
        String id = boat.newListId();
        Optional<String> refused = boat.send(command -> new UploadWaypoints(command, id, path.waypoints()), nowMs);
        if (refused.isEmpty()) {
            listId = id;
            refused = drive(nowMs);
        }
        isUnderWay = refused.isEmpty();
        return refused;
    }

    private Optional<String> drive(long nowMs) {
        return boat.send(command -> new StartWaypoints(command, listId, next), nowMs);
    }

    /** It waits: the boat does something else. */
    void pause() {
        isUnderWay = false;
        waitsUntilMs = Long.MIN_VALUE;
    }

    /** Goes on at an item, now or when it is started; false where no place is at this item or a later one. */
    boolean goOnAt(int item, Optional<Waypoint> home) {
        MissionPath whole = MissionPath.of(items, 1, 1, home);
        int from = whole.waypointOf(item);
        if (item >= items.size() || from >= whole.waypoints().size()) {
            return false;
        }
        path = whole;
        next = from;
        isDone = false;
        return true;
    }

    boolean isUnderWay() {
        return isUnderWay;
    }

    /** The boat says how far it is; the item that is reached by that, where one is. */
    OptionalInt take(Progress progress, long nowMs) {
        boolean further = progress.nextIndex() > next
                && progress.nextIndex() <= path.waypoints().size();
        if (!isList(progress.listId()) || !further) {
            return OptionalInt.empty();
        }
        int reached = progress.nextIndex() - 1;
        next = progress.nextIndex();
        isDone = progress.completed();
        isUnderWay &= !isDone;
        double waitS = path.waitsS().get(reached);
        if (isUnderWay && waitS > 0) {
            waitsUntilMs = nowMs + Math.round(waitS * MS);
            boat.send(HoldPosition::new, nowMs);
        }
        return OptionalInt.of(path.itemOf(reached));
    }

    /** Goes on where the wait at a waypoint is over. */
    void tick(long nowMs) {
        if (isUnderWay && waitsUntilMs != Long.MIN_VALUE && nowMs >= waitsUntilMs) {
            waitsUntilMs = Long.MIN_VALUE;
            drive(nowMs);
        }
    }

    /** How far it is, for stations. */
    MissionProgress progress() {
        int item = path.items().isEmpty() ? 0 : path.itemOf(next);
        return new MissionProgress(item, isOfBase ? boat.mode() == BoatMode.PATH : isUnderWay, isDone);
    }
}
