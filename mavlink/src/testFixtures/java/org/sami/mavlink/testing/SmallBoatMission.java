package org.sami.mavlink.testing;

import io.dronefleet.mavlink.common.MavMissionResult;
import io.dronefleet.mavlink.common.MavMissionType;
import io.dronefleet.mavlink.common.MissionAck;
import io.dronefleet.mavlink.common.MissionClearAll;
import io.dronefleet.mavlink.common.MissionCount;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.common.MissionRequestInt;
import io.dronefleet.mavlink.common.MissionRequestList;
import io.dronefleet.mavlink.common.MissionWritePartialList;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.mavlink.mission.HeldKind;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * The mission of a small boat or copter, and the protocol that brings it there and back. As with ArduPilot the items of a part count one by one as they come, are
 * asked for one at each step of the vehicle, and are taken unasked in their order. Safe for use by several threads.
 */
public final class SmallBoatMission {
    private static final int AUTOPILOT = 1;
    private static final int WAYPOINT = 16;
    private static final int KEEP_PLACE = 17;
    private static final int JUMP = 177;
    private static final int CHANGE_SPEED = 178;
    private static final int USUAL_ROOM = 650;
    private static final int NO_ITEMS = 65_535;

    private final VehicleId vehicle;
    private List<MissionItemInt> items = new ArrayList<>();
    private List<MissionItemInt> coming = new ArrayList<>();
    private int awaited; // the item that is asked for next
    private int last; // of those that come
    private boolean isPart;
    private boolean isChanged; // since the last step
    private boolean isAsking; // for the next item of a part
    private boolean refuses;
    private int room = USUAL_ROOM;
    private int uploads;
    private int current;
    private boolean waits;
    private int stops;
    private final List<MissionItemInt> visited = new ArrayList<>();
    private Optional<MissionItemInt> home = Optional.empty(); // read as item 0 in place of what was sent

    /** No mission, of the vehicle with a system id. */
    SmallBoatMission(int system) {
        vehicle = new VehicleId(system, AUTOPILOT);
    }

    synchronized boolean isEmpty() {
        return items.size() < 2;
    }

    /** How many items it holds, home included. */
    public synchronized int size() {
        return items.size();
    }

    /** How many whole missions were sent to it. */
    public synchronized int uploads() {
        return uploads;
    }

    /** It refuses each mission, and each part of one, from now on, or no longer. */
    public synchronized void refuse(boolean now) {
        refuses = now;
    }

    /** It has room for that many items from now on, home included: an autopilot with a memory card. */
    public synchronized void room(int items) {
        room = items;
    }

    /** Somebody else has given it this mission, home first. */
    public synchronized void put(List<MissionItem> others) {
        items = new ArrayList<>(others.stream()
                .map(item -> item.message(vehicle, HeldKind.MISSION))
                .toList());
        current = 0;
    }

    /** It holds no mission any longer: another ground station has taken it away. */
    public synchronized void lose() {
        items = new ArrayList<>();
    }

    /** One of its items; empty where it has no such one. */
    Optional<MissionItemInt> item(int number) {
        return number < items.size() ? Optional.of(items.get(number)) : Optional.empty();
    }

    /** How many items it has, as ArduPilot says it: without home. */
    synchronized int total() {
        return items.isEmpty() ? NO_ITEMS : items.size() - 1;
    }

    synchronized int current() {
        return current;
    }

    /** It is armed at a place, which is its home from now on. */
    synchronized void home(double latDeg, double lonDeg) {
        home = Optional.of(MissionItem.waypoint(0, latDeg, lonDeg, 0, 0).message(vehicle, HeldKind.MISSION));
    }

    /** It goes to another of its items from now on. */
    public synchronized void setCurrent(int item) {
        current = item;
    }

    /** The place of the item under way, after the items without places before it; empty where there is none. */
    synchronized Optional<MissionItemInt> place(SmallBoatMotion motion) {
        current = Math.max(1, current);
        for (int i = 0; i < items.size() && current < items.size() && !hasPlace(items.get(current)); i++) {
            MissionItemInt item = items.get(current);
            if (number(item) == JUMP) {
                current = (int) item.param1();
            } else {
                motion.speed(item.param2());
                current++;
            }
        }
        return current < items.size() ? Optional.of(items.get(current)) : Optional.empty();
    }

    private static boolean hasPlace(MissionItemInt item) {
        return number(item) != CHANGE_SPEED && number(item) != JUMP;
    }

    /** How often it went on after it had kept its place at an item for that. */
    public synchronized int stops() {
        return stops;
    }

    /** The waypoints that it has reached, in their order, as latitude and longitude in degrees. */
    public synchronized List<List<Double>> visited() {
        return visited.stream()
                .map(item -> List.of(item.x() / 1e7, item.y() / 1e7))
                .toList();
    }

    private static int number(MissionItemInt item) {
        return item.command().value();
    }

    /** The boat is at the item under way. The number of a waypoint that is reached by it. */
    synchronized Optional<Integer> arrived() {
        if (number(items.get(current)) == KEEP_PLACE) {
            waits = true;
            return Optional.empty();
        }
        stops += waits ? 1 : 0;
        waits = false;
        Optional<Integer> reached = number(items.get(current)) == WAYPOINT ? Optional.of(current) : Optional.empty();
        reached.ifPresent(item -> visited.add(items.get(item)));
        current++;
        return reached;
    }

    /** Whether a message is one of those by which missions come and go. */
    static boolean isAboutMission(Object message) {
        return message instanceof MissionRequestList
                || message instanceof MissionRequestInt
                || message instanceof MissionCount
                || message instanceof MissionWritePartialList
                || message instanceof MissionClearAll
                || message instanceof MissionItemInt;
    }

    /** What it answers. */
    synchronized List<Object> answers(Object message) {
        if (message instanceof MissionRequestList list) {
            return List.of(MissionCount.builder()
                    .count(isMission(list.missionType()) ? items.size() : 0)
                    .missionType(list.missionType())
                    .build());
        } else if (message instanceof MissionRequestInt asked && asked.seq() < items.size()) {
            return List.of(home.filter(at -> asked.seq() == 0).orElse(items.get(asked.seq())));
        } else if (message instanceof MissionCount count && isMission(count.missionType())) {
            if (refuses || count.count() > room) {
                return List.of(ack(MavMissionResult.MAV_MISSION_NO_SPACE));
            }
            return comes(new ArrayList<>(), 0, count.count() - 1);
        } else if (message instanceof MissionWritePartialList part && isMission(part.missionType())) {
            return refuses
                    ? List.of(ack(MavMissionResult.MAV_MISSION_DENIED))
                    : comes(new ArrayList<>(items), part.startIndex(), part.endIndex());
        } else if (message instanceof MissionClearAll) {
            items = new ArrayList<>();
            return List.of(ack(MavMissionResult.MAV_MISSION_ACCEPTED));
        } else if (message instanceof MissionItemInt item && item.seq() == awaited && awaited <= last) {
            return take(item);
        }
        return List.of();
    }

    /** Whether an item of it was written since the last step, each of which is asked once. */
    synchronized boolean takeChange() {
        boolean was = isChanged;
        isChanged = false;
        return was;
    }

    /** What it asks for at a step of the vehicle; empty where it asks for nothing. */
    synchronized Optional<Object> question() {
        Optional<Object> question = isAsking ? Optional.of(asked()) : Optional.empty();
        isAsking = false;
        return question;
    }

    private List<Object> comes(List<MissionItemInt> before, int first, int end) {
        coming = before;
        isPart = !before.isEmpty();
        isAsking = false;
        awaited = first;
        last = end;
        return List.of(asked());
    }

    private Object asked() {
        return MissionRequestInt.builder()
                .seq(awaited)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build();
    }

    private List<Object> take(MissionItemInt item) {
        if (item.seq() < coming.size()) {
            coming.set(item.seq(), item);
        } else {
            coming.add(item);
        }
        awaited++;
        isChanged |= isPart;
        isAsking = isPart && awaited <= last;
        if (isPart) {
            items = new ArrayList<>(coming);
        }
        if (awaited <= last) {
            return isPart ? List.of() : List.of(asked());
        }
        items = coming;
        uploads += isPart ? 0 : 1;
        return List.of(ack(MavMissionResult.MAV_MISSION_ACCEPTED));
    }

    private static MissionAck ack(MavMissionResult result) {
        return MissionAck.builder()
                .type(result)
                .missionType(MavMissionType.MAV_MISSION_TYPE_MISSION)
                .build();
    }

    private static boolean isMission(EnumValue<MavMissionType> type) {
        return type.entry() == MavMissionType.MAV_MISSION_TYPE_MISSION;
    }
}
