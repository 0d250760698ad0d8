package org.sami.crw.operator.alarm;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.proxy.status.BoatPose;

/** How fast robots climb or descend, by the heights that they report: no report says it. For one thread. */
final class ClimbRate {
    /** Reports nearer in time, in ms, are not compared: a shaking height would look like a fast climb. */
    private static final long APART_MS = 900;

    private static final double STEADY_MPS = 0.3;

    private final Map<String, Known> robots = new HashMap<>();

    private record Known(double altM, long boatTimeMs, double upMps) {}

    /** The rate in m/s, negative down, after this report; 0 before the second one, and for one that keeps its height. */
    double at(String robot, BoatPose pose) {
        Known next = Optional.ofNullable(robots.get(robot))
                .filter(known -> pose.boatTimeMs() >= known.boatTimeMs) // else it has started anew
                .map(known -> after(known, pose))
                .orElseGet(() -> new Known(pose.position().altM(), pose.boatTimeMs(), 0));
        robots.put(robot, next);
        return next.upMps;
    }

    void remove(String robot) {
        robots.remove(robot);
    }

    private static Known after(Known known, BoatPose pose) {
        long ms = pose.boatTimeMs() - known.boatTimeMs;
        if (ms < APART_MS) {
            return known;
        }
        double altM = pose.position().altM();
        double upMps = (altM - known.altM) * 1000 / ms;
        return new Known(altM, pose.boatTimeMs(), Math.abs(upMps) < STEADY_MPS ? 0 : upMps);
    }
}
