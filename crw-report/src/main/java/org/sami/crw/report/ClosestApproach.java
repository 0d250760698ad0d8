package org.sami.crw.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.function.Supplier;
import org.sami.crw.report.PairOfTracks.Track;

/**
 * How near boats came to one another in a run, by their tracks: every two of them at equal times, as long as both were there. Between two
 * points a boat goes on a straight line at a steady speed. The difference of heights counts: a copter that flies 40 m over a boat is 40 m
 * from it.
 *
 * @param ever the nearest of all; empty for fewer than two boats
 * @param underWay the nearest from the moment on at which both of the two had left where they began, by {@link #LEFT_M}: boats mostly
 *     lie side by side at the start. Empty where no two had
 * @param near of every two that came nearer than {@link #NEAR_M} where they were nearest, the nearest first
 * @param nearMillis how long every two of these were nearer than that, all taken together, in milliseconds
 */
public record ClosestApproach(
        Optional<Approach> ever, Optional<Approach> underWay, List<Approach> near, long nearMillis) {
    /** What boats keep from one another in still water, in metres (docs/decisions, 0320). */
    public static final double NEAR_M = 3;

    /** A boat that is so far from its first point has left it, in metres. */
    public static final double LEFT_M = 10;

    public ClosestApproach {
        Objects.requireNonNull(ever, "ever");
        Objects.requireNonNull(underWay, "underWay");
        near = List.copyOf(near);
    }

    /** Looks through the tracks of all boats. */
    public static ClosestApproach of(List<BoatResult> boats) {
        Optional<Approach> ever = Optional.empty();
        Optional<Approach> underWay = Optional.empty();
        List<Approach> near = new ArrayList<>();
        double nearMillis = 0;
        List<Long> left = boats.stream().map(boat -> leftAt(boat.track())).toList();
        List<Track> tracks = boats.stream().map(Track::of).toList();
        for (int i = 0; i < boats.size(); i++) {
            for (int j = i + 1; j < boats.size(); j++) {
                PairOfTracks pair = new PairOfTracks(tracks.get(i), tracks.get(j));
                double nearestM = ever.map(Approach::distanceM).orElse(Double.MAX_VALUE);
                Optional<Approach> nearest = pair.nearerThan(Math.max(NEAR_M, nearestM), 0);
                if (nearest.isPresent() && nearest.get().distanceM() < NEAR_M) {
                    near.add(nearest.get());
                    nearMillis += pair.millisNearer(NEAR_M);
                }
                ever = nearest.filter(approach -> approach.distanceM() < nearestM)
                        .or(known(ever));
                underWay = pair.nearer(underWay, Math.max(left.get(i), left.get(j)));
            }
        }
        near.sort(Comparator.comparingDouble(Approach::distanceM));
        return new ClosestApproach(ever, underWay, near, Math.round(nearMillis));
    }

    private static Supplier<Optional<Approach>> known(Optional<Approach> approach) {
        return () -> approach;
    }

    /** When a boat had left its first point; never is the end of all time. */
    private static long leftAt(List<TrackPoint> track) {
        for (TrackPoint point : track) {
            TrackPoint first = track.get(0);
            if (Math.hypot(point.eastM() - first.eastM(), point.northM() - first.northM()) >= LEFT_M) {
                return point.atMillis();
            }
        }
        return Long.MAX_VALUE;
    }
}
