package org.sami.crw.mavlink;

import java.util.Optional;
import org.sami.boat.link.MotionDefaults;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.traffic.StationGivingWay;
import org.sami.boat.server.traffic.Surroundings;
import org.sami.boat.server.vehicle.Kinematics;
import org.sami.boat.server.vehicle.LocalFrame;

/**
 * Decides where a vehicle that lies at the end of its path moves aside, so that others reach or pass that place, by the rule of the boats with our own server ({@link
 * StationGivingWay}), and when it goes back. For the gateway's thread.
 */
final class VehicleStation {
    /** How far from the end of its path it may lie: an autopilot comes to rest up to 2.5 m from where it was sent. */
    private static final double RADIUS_M = MotionDefaults.HOLD_RADIUS_M + 2.5;

    private static final double SAME_PLACE_M = 2; // nearer to the last one, another place is no reason to move again
    private static final long CLEAR_MS = 15_000; // for so long nobody has come by before it goes back
    private static final double MPS = 0.8;

    private final StationGivingWay rule;
    private Optional<Waypoint> station = Optional.empty();
    private Optional<Waypoint> aside = Optional.empty();
    private long clearSinceMs;

    VehicleStation(Surroundings surroundings, Kinematics vehicle, double positionErrorM) {
        rule = StationGivingWay.wide(surroundings, vehicle, RADIUS_M, positionErrorM);
    }

    /** It is under way, or does not lie at the end of its path by order of the base. */
    void leave() {
        station = Optional.empty();
        aside = Optional.empty();
    }

    /**
     * Where it is to go now; empty where it stays.
     *
     * @param end the end of its path
     */
    Optional<Waypoint> next(Waypoint end, long nowMs) {
        if (!station.equals(Optional.of(end))) {
            leave();
            station = Optional.of(end);
            rule.begin();
        }
        LocalFrame frame = new LocalFrame(end.latDeg(), end.lonDeg());
        Optional<Waypoint> room =
                rule.aside(frame, nowMs).map(at -> new Waypoint(at.originLatDeg(), at.originLonDeg(), MPS));
        if (room.isPresent() || !rule.isClear(frame, nowMs)) {
            clearSinceMs = nowMs;
        }
        if (room.isPresent()) {
            return room.filter(
                    place -> aside.filter(known -> isSame(known, place)).isEmpty());
        }
        return aside.isPresent() && nowMs - clearSinceMs >= CLEAR_MS
                ? Optional.of(new Waypoint(end.latDeg(), end.lonDeg(), MPS))
                : Optional.empty();
    }

    /** It has been sent to a place that was given as the next one. */
    void sentTo(Waypoint place) {
        aside = station.filter(end -> !isSame(end, place)).map(end -> place);
    }

    private static boolean isSame(Waypoint one, Waypoint other) {
        return new LocalFrame(one.latDeg(), one.lonDeg()).distanceM(other.latDeg(), other.lonDeg()) < SAME_PLACE_M;
    }
}
