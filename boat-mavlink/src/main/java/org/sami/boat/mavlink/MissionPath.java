package org.sami.boat.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.mission.MissionItem;

/**
 * A mission of a ground station as a waypoint list of a boat, and back. Item 0 is mostly the vehicle's home, as with ArduPilot. Immutable.
 *
 * @param waypoints what the boat drives to
 * @param items the number of the item of each waypoint
 * @param waitsS how long the boat waits at each, in seconds
 */
record MissionPath(List<Waypoint> waypoints, List<Integer> items, List<Double> waitsS) {
    private static final int WAYPOINT = 16;
    private static final int KEEP_PLACE = 17;
    private static final int KEEP_FOR = 19;
    private static final int RETURN = 20;
    private static final int CHANGE_SPEED = 178;
    private static final int GLOBAL = 0;
    private static final int GLOBAL_INT = 5;
    private static final double LONGEST_WAIT_S = 86_400;

    /** A path. */
    MissionPath {
        waypoints = List.copyOf(waypoints);
        items = List.copyOf(items);
        waitsS = List.copyOf(waitsS);
    }

    /** A mission without items. */
    static MissionPath none() {
        return new MissionPath(List.of(), List.of(), List.of());
    }

    /** Whether a boat has the command of an item. */
    static boolean isKnown(MissionItem item) {
        return switch (item.command()) {
            case WAYPOINT, KEEP_PLACE, KEEP_FOR, RETURN, CHANGE_SPEED -> true;
            default -> false;
        };
    }

    /** Why a boat cannot carry out an item, in words; empty where it can. */
    static Optional<String> whyNot(MissionItem item) {
        boolean places = item.command() == WAYPOINT || item.command() == KEEP_PLACE || item.command() == KEEP_FOR;
        if (places) {
            boolean maybeHome = item.number() == 0 && item.command() == WAYPOINT;
            if (!maybeHome && item.latDeg() == 0 && item.lonDeg() == 0) {
                return Optional.of("item " + item.number() + " is at 0, 0");
            }
            boolean waits = item.command() != KEEP_PLACE;
            return waits && !(waitS(item) >= 0 && waitS(item) <= LONGEST_WAIT_S)
                    ? Optional.of("item " + item.number() + " waits " + item.param1() + " s")
                    : Optional.empty();
        } else if (item.command() == CHANGE_SPEED) {
            return item.param2() > 0 || item.param2() == -1
                    ? Optional.empty()
                    : Optional.of("item " + item.number() + " has the speed " + item.param2());
        }
        return item.command() == RETURN
                ? Optional.empty()
                : Optional.of("item " + item.number() + ": a boat of SAMI has no " + item.commandName());
    }

    /** Not a number stands for the usual value, which is none. */
    private static double waitS(MissionItem item) {
        return Double.isNaN(item.param1()) ? 0 : item.param1();
    }

    /**
     * Whether it knows the frame of an item (MAV_FRAME). Heights do not matter to a boat, so it knows all frames with latitude and longitude, over the sea, home or terrain, in either
     * form, and that of commands without a place (2), which ArduPilot takes for places, too. It knows none that counts metres from somewhere.
     */
    static boolean isKnownFrame(MissionItem item) {
        return switch (item.frame()) {
            case 0, 2, 3, 5, 6, 10, 11 -> true;
            default -> false;
        };
    }

    /**
     * The path of a mission.
     *
     * @param speedMps of legs before the mission names a speed
     * @param mostMps no leg is faster
     * @param home where an item "return" leads
     */
    static MissionPath of(List<MissionItem> mission, double speedMps, double mostMps, Optional<Waypoint> home) {
        List<Waypoint> waypoints = new ArrayList<>();
        List<Integer> items = new ArrayList<>();
        List<Double> waits = new ArrayList<>();
        double speed = speedMps;
        for (MissionItem item : mission.subList(beginsWithHome(mission, home) ? 1 : 0, mission.size())) {
            if (item.command() == CHANGE_SPEED) {
                speed = item.param2() > 0 ? Math.min(mostMps, item.param2()) : speed;
                continue;
            }
            if (item.command() != RETURN) {
                waypoints.add(new Waypoint(item.latDeg(), item.lonDeg(), speed));
            } else if (home.isPresent()) {
                waypoints.add(new Waypoint(home.get().latDeg(), home.get().lonDeg(), speed));
            }
            if (items.size() < waypoints.size()) {
                items.add(item.number());
                waits.add(item.command() == KEEP_PLACE || item.command() == RETURN ? 0 : waitS(item));
            }
            if (item.command() == KEEP_PLACE || item.command() == RETURN) {
                break; // what comes after it is never reached
            }
        }
        return new MissionPath(waypoints, items, waits);
    }

    /** The mission that a boat's own list is, for stations that look at a boat which its base has sent. */
    static List<MissionItem> missionOf(List<Waypoint> list, Optional<Waypoint> home) {
        if (list.isEmpty()) {
            return List.of();
        }
        List<MissionItem> items = new ArrayList<>(List.of(homeItem(home.orElse(list.get(0)))));
        for (Waypoint point : list) {
            items.add(MissionItem.waypoint(items.size(), point.latDeg(), point.lonDeg(), 0, 0));
        }
        return items;
    }

    /**
     * Whether item 0 is the vehicle's home, as stations send it to ArduPilot, and no place to go to: it has an absolute height, or no place, or it is where the boat's home
     * is. MAVSDK sends no home: its item 0 is the first place, with a height over home.
     */
    static boolean beginsWithHome(List<MissionItem> mission, Optional<Waypoint> home) {
        if (mission.isEmpty() || mission.get(0).command() != WAYPOINT) {
            return false;
        }
        MissionItem first = mission.get(0);
        boolean absolute = first.frame() == GLOBAL || first.frame() == GLOBAL_INT;
        boolean placeless = first.latDeg() == 0 && first.lonDeg() == 0;
        return absolute
                || placeless
                || home.filter(at -> new LocalFrame(at.latDeg(), at.lonDeg()).distanceM(first.latDeg(), first.lonDeg())
                                <= MotionDefaults.ARRIVAL_RADIUS_M)
                        .isPresent();
    }

    /** A mission that came from a station, with the boat's own home as its item 0 where it begins with a home. */
    static List<MissionItem> withHome(List<MissionItem> mission, Optional<Waypoint> home) {
        if (home.isEmpty() || !beginsWithHome(mission, home)) {
            return mission;
        }
        List<MissionItem> own = new ArrayList<>(mission);
        own.set(0, homeItem(home.get()));
        return own;
    }

    private static MissionItem homeItem(Waypoint home) {
        return new MissionItem(0, WAYPOINT, GLOBAL, home.latDeg(), home.lonDeg(), 0, 0, 0, 0, 0);
    }

    /** The part from a waypoint on. */
    MissionPath from(int waypoint) {
        int size = items.size();
        return new MissionPath(
                waypoints.subList(waypoint, size), items.subList(waypoint, size), waitsS.subList(waypoint, size));
    }

    /** The item of a waypoint; of the last one where all are reached. */
    int itemOf(int waypoint) {
        return items.isEmpty() ? 0 : items.get(Math.min(waypoint, items.size() - 1));
    }

    /** The first waypoint of an item or of a later one; the number of waypoints where there is none. */
    int waypointOf(int item) {
        for (int i = 0; i < items.size(); i++) {
            if (items.get(i) >= item) {
                return i;
            }
        }
        return items.size();
    }
}
