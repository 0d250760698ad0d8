package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.crw.report.LocationResult;
import org.sami.crw.report.LocationResult.Truth;
import org.sami.crw.report.LocationResult.Visit;

/**
 * Measures how near simulated boats truly come to the locations of a run, whatever they report. Between two looks a boat is assumed to go straight.
 * For the run's thread.
 */
public final class TrueVisits implements ReportFold {
    /** Boats farther away are not measured, in metres. */
    static final double REACH_M = 25;

    private final VisitRecorder reported;
    private final List<Nearest> locations = new ArrayList<>();
    private final Map<Long, List<Nearest>> cells = new HashMap<>();
    private final Map<String, Place> before = new HashMap<>();

    /** A location, and the nearest approach of boats. */
    private static final class Nearest {
        private final double eastM;
        private final double northM;
        private double nearestM = REACH_M;
        private Optional<Visit> visit = Optional.empty();

        Nearest(LocationResult location) {
            eastM = location.eastM();
            northM = location.northM();
        }

        void passed(Place from, double toEastM, double toNorthM, Visit by) {
            double alongEast = toEastM - from.eastM;
            double alongNorth = toNorthM - from.northM;
            double square = alongEast * alongEast + alongNorth * alongNorth;
            double part = square == 0
                    ? 0
                    : Math.max(
                            0,
                            Math.min(
                                    1,
                                    ((eastM - from.eastM) * alongEast + (northM - from.northM) * alongNorth) / square));
            double distanceM =
                    PlaneMath.length(from.eastM + part * alongEast - eastM, from.northM + part * alongNorth - northM);
            nearestM = Math.min(nearestM, distanceM);
            if (visit.isEmpty() && distanceM <= Truth.RADIUS_M) {
                visit = Optional.of(by);
            }
        }

        Truth truth() {
            return new Truth(visit, nearestM < REACH_M ? OptionalDouble.of(nearestM) : OptionalDouble.empty());
        }
    }

    /** A boat's position at the last look, with the locations around it. */
    private static final class Place {
        private double eastM;
        private double northM;
        private long cell;
        private List<Nearest> near = List.of();
        private int known;
    }

    /**
     * A watch over the locations of a run.
     *
     * @param reported knows them, also those that are still to be given
     */
    public TrueVisits(VisitRecorder reported) {
        this.reported = reported;
    }

    /** Records the true positions; called often, as boats go straight only for moments. */
    public void look(long nowMillis, List<BoatState> boats) {
        List<LocationResult> given = reported.locationsFrom(locations.size());
        for (LocationResult location : given) {
            Nearest added = new Nearest(location);
            locations.add(added);
            cells.computeIfAbsent(cell(cell(added.eastM), cell(added.northM)), cell -> new ArrayList<>())
                    .add(added);
        }
        for (BoatState boat : boats) {
            look(nowMillis, boat);
        }
    }

    private void look(long nowMillis, BoatState boat) {
        Place place = before.get(boat.id());
        if (place == null) {
            place = new Place();
            place.eastM = boat.eastM();
            place.northM = boat.northM();
            before.put(boat.id(), place);
        }
        long east = cell(boat.eastM());
        long north = cell(boat.northM());
        if (place.cell != cell(east, north) || place.known != locations.size()) {
            place.cell = cell(east, north);
            place.known = locations.size();
            place.near = around(east, north);
        }
        if (!place.near.isEmpty()) {
            Visit visit = new Visit(nowMillis, boat.id());
            for (Nearest location : place.near) {
                location.passed(place, boat.eastM(), boat.northM(), visit);
            }
        }
        place.eastM = boat.eastM();
        place.northM = boat.northM();
    }

    private List<Nearest> around(long east, long north) {
        List<Nearest> near = new ArrayList<>();
        for (long i = east - 1; i <= east + 1; i++) {
            for (long j = north - 1; j <= north + 1; j++) {
                near.addAll(cells.getOrDefault(cell(i, j), List.of()));
            }
        }
        return near;
    }

    private static long cell(double metres) {
        return (long) Math.floor(metres / REACH_M);
    }

    private static long cell(long east, long north) {
        return (east << Integer.SIZE) ^ (north & 0xFFFF_FFFFL);
    }

    @Override
    public void addTo(ReportDraft report) {
        report.locations(locations());
    }

    /** The run's locations with what boats reported and where they truly were. */
    public List<LocationResult> locations() {
        List<LocationResult> all = new ArrayList<>();
        for (LocationResult location : reported.locations()) {
            int index = all.size();
            all.add(location.with(
                    index < locations.size()
                            ? locations.get(index).truth()
                            : new Truth(Optional.empty(), OptionalDouble.empty())));
        }
        return all;
    }
}
