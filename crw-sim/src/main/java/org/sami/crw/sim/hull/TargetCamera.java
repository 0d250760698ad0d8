package org.sami.crw.sim.hull;

import java.util.List;
import org.sami.boat.server.vehicle.Sensor;

/**
 * The camera that looks down from a simulated copter, with a detector behind it: reports a target that lies in its picture once a second, as the target's
 * number, latitude and longitude. The higher the copter, the more it sees.
 */
final class TargetCamera implements Sensor {
    private static final double HALF_WIDTH = 0.7; // of the picture, as a part of the altitude: a lens of 70 degrees
    private static final double LEAST_ALTITUDE_M = 5;

    private final SimulatedHull hull;
    private final TargetField targets;

    TargetCamera(SimulatedHull hull, long fieldSeed) {
        this.hull = hull;
        targets = new TargetField(fieldSeed);
    }

    @Override
    public String name() {
        return "camera";
    }

    @Override
    public String channel() {
        return "target";
    }

    @Override
    public String unit() {
        return "";
    }

    @Override
    public long periodMs() {
        return 1000;
    }

    @Override
    public List<Double> read() {
        double altM = hull.altM().orElse(0);
        if (altM < LEAST_ALTITUDE_M) {
            return List.of();
        }
        return targets.near(hull.latDeg(), hull.lonDeg(), altM * HALF_WIDTH).stream()
                .findFirst()
                .map(target -> List.of((double) target.number(), target.latDeg(), target.lonDeg()))
                .orElse(List.of());
    }
}
