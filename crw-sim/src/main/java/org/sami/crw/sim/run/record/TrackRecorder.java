package org.sami.crw.sim.run.record;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.crw.report.BoatResult;
import org.sami.crw.report.LinkResult;
import org.sami.crw.report.NoteResult;
import org.sami.crw.report.TrackPoint;
import org.sami.crw.session.JoinOrder;
import org.sami.spn.engine.EngineView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;

/**
 * Records where boats are: a point a second while they move, none while they lie still. A boat that goes from each point to the next in a straight
 * line at a steady speed is at every moment within 0.2 m of its true position.
 *
 * <p>Memory does not grow with the length of a run: where tracks have more than {@link #MOST} points together, points of the longest ones that the
 * rest describes well enough are left out ({@link TrackThinning}); a note says how exact the tracks still are.
 */
public final class TrackRecorder implements ReportFold {
    /** Points kept for all boats together, about 15 MB. */
    static final int MOST = 200_000;

    private static final double REST_DISTANCE_M = 0.2;
    private static final double FIRST_TOLERANCE_M = 0.25;
    private static final int LEAST = 100; // of each boat, however many there are

    private final int most;
    private final Map<String, Track> tracks = new LinkedHashMap<>();
    private final JoinOrder joined = new JoinOrder();

    private static final class Track {
        private List<TrackPoint> points = new ArrayList<>();
        private Optional<Noted> lay = Optional.empty(); // the last position, if no point was recorded for it
        private double toleranceM;
        private double offM; // sum of the tolerances of all thinnings

        private boolean isEmpty() {
            return points.isEmpty();
        }

        private TrackPoint last() {
            return points.get(points.size() - 1);
        }
    }

    /** A recorded position of a boat. */
    public record Noted(long atMillis, BoatState boat) {}

    /** A recorder without positions. */
    public TrackRecorder() {
        this(MOST);
    }

    TrackRecorder(int most) {
        this.most = most;
    }

    @Override
    public void onStep(long index, long atMillis, Input input, List<Effect> effects, EngineView view) {
        joined.onStep(input, effects);
    }

    @Override
    public void onPose(long atMillis, BoatState boat) {
        add(new Noted(atMillis, boat));
    }

    @Override
    public void addTo(ReportDraft report) {
        ReportEnd end = report.end();
        report.tracks(KnownTracks.reported(results(end.atMillis(), end.boats(), end.links())));
        report.note(notes(end.atMillis()));
    }

    /** Records the boats' positions; called once a second. Returns the points that were recorded. */
    public List<Noted> look(long nowMillis, List<BoatState> boats) {
        List<Noted> noted = new ArrayList<>();
        for (BoatState boat : boats) {
            Track track = track(boat);
            Noted seen = new Noted(nowMillis, boat);
            if (track.isEmpty() || moved(track.last(), boat) > REST_DISTANCE_M) {
                track.lay.ifPresent(noted::add); // it has lain there until then
                noted.add(seen);
                track.lay = Optional.empty();
            } else {
                track.lay = Optional.of(seen);
            }
        }
        noted.forEach(this::add);
        return noted;
    }

    /** Records a position from telemetry; each boat's points come in order of time. */
    public void add(Noted noted) {
        Track track = track(noted.boat);
        track.points.add(point(noted.atMillis, noted.boat));
        int share = Math.max(LEAST, most / tracks.size());
        if (track.points.size() > share) {
            thin(track, share / 2);
        }
    }

    /** Leaves out points until there is room for as many again. */
    private static void thin(Track track, int enough) {
        double toleranceM = Math.max(FIRST_TOLERANCE_M, track.toleranceM);
        List<TrackPoint> thinned = TrackThinning.within(toleranceM, track.points);
        while (thinned.size() > enough) {
            toleranceM *= 2;
            thinned = TrackThinning.within(toleranceM, track.points);
        }
        track.points = thinned;
        track.toleranceM = toleranceM;
        track.offM += toleranceM;
    }

    private Track track(BoatState boat) {
        return tracks.computeIfAbsent(boat.id(), id -> new Track());
    }

    /** A note on the boats whose tracks were thinned, if any, with their tolerance. */
    public List<NoteResult> notes(long atMillis) {
        double worst = tracks.values().stream().mapToDouble(t -> t.offM).max().orElse(0);
        long thinned = tracks.values().stream().filter(t -> t.toleranceM > 0).count();
        return thinned == 0
                ? List.of()
                : List.of(new NoteResult(
                        atMillis,
                        "tracks",
                        0,
                        String.format(
                                Locale.ROOT,
                                "points were left out of the tracks of %d of %d boats, for there were more than %d; "
                                        + "what is left is right to %.2f m",
                                thinned,
                                tracks.size(),
                                most,
                                worst + REST_DISTANCE_M)));
    }

    private static double moved(TrackPoint from, BoatState to) {
        return PlaneMath.length(
                PlaneMath.length(to.eastM() - from.eastM(), to.northM() - from.northM()), to.altM() - from.altM());
    }

    private static TrackPoint point(long nowMillis, BoatState boat) {
        return new TrackPoint(
                nowMillis,
                boat.eastM(),
                boat.northM(),
                boat.latDeg(),
                boat.lonDeg(),
                boat.speedMps(),
                boat.batteryPercent(),
                boat.altM());
    }

    /**
     * The results of the boats, each with its track up to its present position.
     *
     * @param links gives each boat's link
     */
    public List<BoatResult> results(long nowMillis, List<BoatState> boats, Function<String, LinkResult> links) {
        List<BoatResult> results = new ArrayList<>();
        for (BoatState boat : boats) {
            List<TrackPoint> track = new ArrayList<>();
            Optional.ofNullable(tracks.get(boat.id())).ifPresent(known -> track.addAll(known.points));
            if (track.isEmpty() || track.get(track.size() - 1).atMillis() < nowMillis) {
                track.add(point(nowMillis, boat));
            }
            results.add(new BoatResult(
                    boat.id(),
                    links.apply(boat.id()),
                    boat.distanceM(),
                    boat.batteryPercent(),
                    boat.recharges(),
                    joined.indexOf(boat.id()),
                    track));
        }
        return results;
    }
}
