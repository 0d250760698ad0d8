package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.MotionDefaults;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.LocationResult.Visit;

/**
 * Records which locations boats report as visited: by their message or, behind TCP, by a reported position within {@link #RADIUS_M} (the 3 m within
 * which they have arrived, and what they drive between two looks). {@link TrueVisits} has the true positions of simulated boats.
 */
public final class VisitRecorder {
    public static final double RADIUS_M = MotionDefaults.ARRIVAL_RADIUS_M + 0.5;

    private final List<LocationResult> locations = new ArrayList<>();
    private int visited;

    /** Adds a location; a second one at the same point is the same location. */
    public void add(double latDeg, double lonDeg, double eastM, double northM) {
        boolean known = locations.stream().anyMatch(l -> l.latDeg() == latDeg && l.lonDeg() == lonDeg);
        if (!known) {
            locations.add(new LocationResult(locations.size() + 1, latDeg, lonDeg, eastM, northM, Optional.empty()));
        }
    }

    /** Whether some locations have not been visited. */
    public boolean isLookingOut() {
        return visited < locations.size();
    }

    /** Checks the reported positions. Returns the locations that were visited now. */
    public List<LocationResult> look(long nowMillis, List<BoatState> boats) {
        if (!isLookingOut()) {
            return List.of();
        }
        List<LocationResult> news = new ArrayList<>();
        for (int i = 0; i < locations.size(); i++) {
            LocationResult location = locations.get(i);
            Optional<String> visitor = location.visited() ? Optional.empty() : visitor(location, boats);
            if (visitor.isPresent()) {
                news.add(visited(i, nowMillis, visitor.get()));
            }
        }
        return news;
    }

    private static Optional<String> visitor(LocationResult location, List<BoatState> boats) {
        for (BoatState boat : boats) {
            double eastM = boat.eastM() - location.eastM();
            double northM = boat.northM() - location.northM();
            boolean mayBeNear = Math.abs(eastM) <= RADIUS_M && Math.abs(northM) <= RADIUS_M;
            if (mayBeNear && Math.hypot(eastM, northM) <= RADIUS_M) {
                return Optional.of(boat.id());
            }
        }
        return Optional.empty();
    }

    /**
     * Takes a boat's report of a visit; a point that is no location changes nothing. The earliest visit counts, in whatever order visits become
     * known.
     */
    public void visited(double latDeg, double lonDeg, long atMillis, String boatId) {
        for (int i = 0; i < locations.size(); i++) {
            LocationResult location = locations.get(i);
            boolean earlier =
                    atMillis < location.reported().map(Visit::atMillis).orElse(Long.MAX_VALUE);
            if (location.latDeg() == latDeg && location.lonDeg() == lonDeg && earlier) {
                visited(i, atMillis, boatId);
                return;
            }
        }
    }

    private LocationResult visited(int index, long atMillis, String boatId) {
        LocationResult location = locations.get(index);
        LocationResult now = new LocationResult(
                location.number(),
                location.latDeg(),
                location.lonDeg(),
                location.eastM(),
                location.northM(),
                Optional.of(new Visit(atMillis, boatId)));
        locations.set(index, now);
        visited += location.visited() ? 0 : 1;
        return now;
    }

    /** Number of locations reported as visited. */
    public int visited() {
        return visited;
    }

    /** Number of locations. */
    public int count() {
        return locations.size();
    }

    /** The locations after the first {@code count}, in order. */
    List<LocationResult> locationsFrom(int count) {
        return locations.subList(count, locations.size());
    }

    /** All locations, in the order in which they were given. */
    public List<LocationResult> locations() {
        return List.copyOf(locations);
    }
}
