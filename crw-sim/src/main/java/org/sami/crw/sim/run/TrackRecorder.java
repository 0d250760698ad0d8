package org.sami.crw.sim.run;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.sami.crw.sim.report.BoatResult;
import org.sami.crw.sim.report.LinkResult;
import org.sami.crw.sim.report.TrackPoint;

/** Notes down where boats are: a point a second while they move, none while they lie still. */
public final class TrackRecorder {
    private static final double STILL_M = 0.2;

    private final Map<String, List<TrackPoint>> tracks = new LinkedHashMap<>();

    /** Looks where the boats are; to be called once a second. Returns those of which a point was noted down. */
    public List<BoatState> look(long nowMillis, List<BoatState> boats) {
        List<BoatState> noted = new ArrayList<>();
        for (BoatState boat : boats) {
            List<TrackPoint> track = tracks.computeIfAbsent(boat.id(), id -> new ArrayList<>());
            if (track.isEmpty() || moved(track.get(track.size() - 1), boat) > STILL_M) {
                track.add(point(nowMillis, boat));
                noted.add(boat);
            }
        }
        return noted;
    }

    private static double moved(TrackPoint from, BoatState to) {
        return Math.hypot(to.eastM() - from.eastM(), to.northM() - from.northM());
    }

    private static TrackPoint point(long nowMillis, BoatState boat) {
        return new TrackPoint(
                nowMillis,
                boat.eastM(),
                boat.northM(),
                boat.latDeg(),
                boat.lonDeg(),
                boat.speedMps(),
                boat.batteryPercent());
    }

    /**
     * What the boats did, each with its track to where it is now.
     *
     * @param links gives each boat's link
     */
    public List<BoatResult> results(long nowMillis, List<BoatState> boats, Function<String, LinkResult> links) {
        List<BoatResult> results = new ArrayList<>();
        for (BoatState boat : boats) {
            List<TrackPoint> track = new ArrayList<>(tracks.getOrDefault(boat.id(), List.of()));
            if (track.isEmpty() || track.get(track.size() - 1).atMillis() < nowMillis) {
                track.add(point(nowMillis, boat));
            }
            results.add(new BoatResult(
                    boat.id(),
                    links.apply(boat.id()),
                    boat.distanceM(),
                    boat.batteryPercent(),
                    boat.recharges(),
                    track));
        }
        return results;
    }
}
