package org.sami.crw.sim.run.incident;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.session.SessionListener;
import org.sami.session.record.SensorValue;

/** Counts readings of which none is within 1 m of one that was counted before, of all boats together (thesis 8.2). For the fleet's thread. */
final class UniqueReadings implements SessionListener {
    private static final double APART_M = 1;

    private final LocalFrame plane;
    private final Map<Long, List<double[]>> cells = new HashMap<>(); // by square of 1 m
    private int count;

    UniqueReadings(LocalFrame plane) {
        this.plane = plane;
    }

    @Override
    public void onReading(SensorValue reading) {
        double lat = reading.position().latDeg();
        double lon = reading.position().lonDeg();
        double[] at = {plane.eastM(lat, lon), plane.northM(lat, lon)};
        int east = (int) Math.floor(at[0] / APART_M);
        int north = (int) Math.floor(at[1] / APART_M);
        for (int i = east - 1; i <= east + 1; i++) {
            for (int j = north - 1; j <= north + 1; j++) {
                if (cells.getOrDefault(key(i, j), List.of()).stream()
                        .anyMatch(other -> Math.hypot(other[0] - at[0], other[1] - at[1]) <= APART_M)) {
                    return;
                }
            }
        }
        cells.computeIfAbsent(key(east, north), square -> new ArrayList<>()).add(at);
        count++;
    }

    private static long key(int east, int north) {
        return ((long) east << 32) ^ (north & 0xffffffffL);
    }

    int count() {
        return count;
    }
}
