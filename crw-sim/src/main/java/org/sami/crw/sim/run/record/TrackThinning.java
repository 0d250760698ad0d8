package org.sami.crw.sim.run.record;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Deque;
import java.util.List;
import org.sami.boat.server.vehicle.PlaneMath;
import org.sami.crw.report.TrackPoint;

/**
 * Leaves points out of a track. A boat that goes in a straight line at a steady speed between two kept points is at every moment within a tolerance
 * of its true position: the algorithm of Douglas and Peucker with distances at equal times.
 */
final class TrackThinning {
    private TrackThinning() {}

    private record Span(int from, int to) {}

    /** The kept points in order, with the first and the last. */
    static List<TrackPoint> within(double toleranceM, List<TrackPoint> track) {
        if (track.size() < 3) {
            return new ArrayList<>(track);
        }
        BitSet kept = new BitSet(track.size());
        kept.set(0);
        kept.set(track.size() - 1);
        Deque<Span> open = new ArrayDeque<>();
        open.push(new Span(0, track.size() - 1));
        while (!open.isEmpty()) {
            Span span = open.pop();
            int farthest = farthest(track, span, toleranceM);
            if (farthest >= 0) {
                kept.set(farthest);
                open.push(new Span(span.from, farthest));
                open.push(new Span(farthest, span.to));
            }
        }
        List<TrackPoint> points = new ArrayList<>(kept.cardinality());
        kept.stream().forEach(i -> points.add(track.get(i)));
        return points;
    }

    /** The point of a span that is farthest from steady motion between its ends; -1 where all are within the tolerance. */
    private static int farthest(List<TrackPoint> track, Span span, double toleranceM) {
        TrackPoint from = track.get(span.from);
        TrackPoint to = track.get(span.to);
        int farthest = -1;
        double most = toleranceM;
        for (int i = span.from + 1; i < span.to; i++) {
            TrackPoint point = track.get(i);
            double part = (double) (point.atMillis() - from.atMillis()) / Math.max(1, to.atMillis() - from.atMillis());
            double east = from.eastM() + part * (to.eastM() - from.eastM());
            double north = from.northM() + part * (to.northM() - from.northM());
            double up = from.altM() + part * (to.altM() - from.altM());
            double off =
                    PlaneMath.length(PlaneMath.length(point.eastM() - east, point.northM() - north), point.altM() - up);
            if (off > most) {
                most = off;
                farthest = i;
            }
        }
        return farthest;
    }
}
