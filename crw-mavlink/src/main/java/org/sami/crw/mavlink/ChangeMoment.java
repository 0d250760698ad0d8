package org.sami.crw.mavlink;

import java.util.List;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;

/**
 * The moment at which a change of its mission costs a vehicle under way least: at a sharp turn, where it is slow in any case, as long as one comes in time; else at
 * once. For the gateway's thread.
 *
 * <p>Source: ArduPilot's boats begin the leg under way again from a standstill each time an item of their mission is written, wherever that is: 4.7.0-dev in
 * its simulator at 39 of 39 items. It looks for a change of the next three items only, but compares bytes of them that it has never set.
 */
final class ChangeMoment {
    private static final double SHARP_RAD = Math.toRadians(45);
    private static final double SPARE_S =
            90; // for the transfer and a lost link, before the vehicle comes to where its part ends
    private static final long FRESH_MS = 500;

    private int next = -1;
    private long sinceMs;

    /**
     * Whether that moment is now. To be called at each tick.
     *
     * @param goesTo the waypoint to which the vehicle is under way; the one before is reached
     * @param stop the number of waypoints after which it stops if nothing is changed before
     */
    boolean isNow(List<Waypoint> path, int goesTo, int stop, long atMs) {
        if (goesTo != next) {
            next = goesTo;
            sinceMs = atMs;
        }
        boolean hasJustTurned = atMs - sinceMs <= FRESH_MS && isSharp(path, goesTo - 1);
        return hasJustTurned || !comesToTurn(path, goesTo, stop);
    }

    private static boolean comesToTurn(List<Waypoint> path, int from, int stop) {
        double leftS = -SPARE_S;
        int latest = stop;
        while (latest > from && leftS < 0) {
            latest--;
            leftS += seconds(path, latest);
        }
        for (int turn = from; turn < latest; turn++) {
            if (isSharp(path, turn)) {
                return true;
            }
        }
        return false;
    }

    /** How long the leg to a waypoint takes. */
    private static double seconds(List<Waypoint> path, int to) {
        Waypoint at = path.get(to);
        Waypoint before = path.get(Math.max(0, to - 1));
        return new LocalFrame(before.latDeg(), before.lonDeg()).distanceM(at.latDeg(), at.lonDeg()) / at.speedMps();
    }

    private static boolean isSharp(List<Waypoint> path, int at) {
        if (at < 1 || at >= path.size() - 1) {
            return false;
        }
        double turn = heading(path.get(at), path.get(at + 1)) - heading(path.get(at - 1), path.get(at));
        return Math.abs(Math.IEEEremainder(turn, 2 * Math.PI)) >= SHARP_RAD;
    }

    private static double heading(Waypoint from, Waypoint to) {
        LocalFrame frame = new LocalFrame(from.latDeg(), from.lonDeg());
        return Math.atan2(frame.eastM(to.latDeg(), to.lonDeg()), frame.northM(to.latDeg(), to.lonDeg()));
    }
}
