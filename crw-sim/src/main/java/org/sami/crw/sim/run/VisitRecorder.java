package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import org.sami.crw.sim.report.LocationResult;

/**
 * Watches which locations boats truly come to. A location counts as visited when a hull was within
 * {@link #RADIUS_M}: what a boat calls arrived (3 m), and what it drives between two looks.
 */
final class VisitRecorder {
    static final double RADIUS_M = 3.5;

    private final List<LocationResult> locations = new ArrayList<>();
    private int visited;

    /** Adds a location; a second one at the same point is the same. */
    void add(double latDeg, double lonDeg, double eastM, double northM) {
        boolean known = locations.stream().anyMatch(l -> l.latDeg() == latDeg && l.lonDeg() == lonDeg);
        if (!known) {
            locations.add(
                    new LocationResult(locations.size() + 1, latDeg, lonDeg, eastM, northM, OptionalLong.empty(), ""));
        }
    }

    /** Looks where the boats are. */
    void look(long nowMillis, List<BoatState> boats) {
        if (visited == locations.size()) {
            return;
        }
        for (int i = 0; i < locations.size(); i++) {
            LocationResult location = locations.get(i);
            if (!location.visited()) {
                look(nowMillis, i, location, boats);
            }
        }
    }

    private void look(long nowMillis, int index, LocationResult location, List<BoatState> boats) {
        for (BoatState boat : boats) {
            if (Math.hypot(boat.eastM() - location.eastM(), boat.northM() - location.northM()) <= RADIUS_M) {
                locations.set(
                        index,
                        new LocationResult(
                                location.number(),
                                location.latDeg(),
                                location.lonDeg(),
                                location.eastM(),
                                location.northM(),
                                OptionalLong.of(nowMillis),
                                boat.id()));
                visited++;
                return;
            }
        }
    }

    int visited() {
        return visited;
    }

    int count() {
        return locations.size();
    }

    List<LocationResult> locations() {
        return List.copyOf(locations);
    }
}
