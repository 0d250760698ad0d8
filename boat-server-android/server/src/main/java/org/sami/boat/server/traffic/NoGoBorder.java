package org.sami.boat.server.traffic;

import java.util.List;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * The edge of what a boat is not to enter, as far as it is near, on the plane of {@link Surroundings}. A boat that has left its line keeps as far off it as
 * its line does, and where it is nearer already it comes no nearer; and it stays where it can go straight back to its line, so that nothing bars
 * it from there (docs/decisions, 0321).
 */
final class NoGoBorder {
    /** Nothing is near. */
    static final NoGoBorder NONE = new NoGoBorder(0, new StoppingWay[0]);

    /** What is heard of is so much more than what is near, in metres; who has come farther knows nothing of what is near now. */
    private static final double KNOWN_WITHIN_M = 20;

    /** Straight back to its line a boat keeps off by this part of what it else keeps. */
    private static final double BACK = 0.5;

    private static final double ROUNDING_M = 1e-6;

    private final double keepM;
    private final StoppingWay[] edges;
    private final double[] leastM; // to each edge
    private final double[] backM; // from each edge to the straight way back to the line
    private double knownEastM = Double.NaN; // where the boat was when it looked first
    private double knownNorthM;
    private LineAhead line;
    private double eastM;
    private double northM;
    private double alongEast; // unit vector of the line
    private double alongNorth;
    private boolean seesLine = true;

    private NoGoBorder(double keepM, StoppingWay[] edges) {
        this.keepM = keepM;
        this.edges = edges;
        leastM = new double[edges.length];
        backM = new double[edges.length];
    }

    /** What a base tells of. */
    static NoGoBorder of(NoGoEdges told, LocalFrame plane) {
        List<NoGoEdge> rows = told.edges();
        StoppingWay[] edges = new StoppingWay[rows.size()];
        for (int i = 0; i < edges.length; i++) {
            NoGoEdge row = rows.get(i);
            edges[i] = StoppingWay.between(
                    plane.eastM(row.fromLatDeg(), row.fromLonDeg()),
                    plane.northM(row.fromLatDeg(), row.fromLonDeg()),
                    plane.eastM(row.toLatDeg(), row.toLonDeg()),
                    plane.northM(row.toLatDeg(), row.toLonDeg()));
        }
        return new NoGoBorder(told.keepM(), edges);
    }

    boolean isEmpty() {
        return edges.length == 0;
    }

    /** Whether it was told of when the boat was elsewhere. */
    boolean isPast(double atEastM, double atNorthM) {
        if (Double.isNaN(knownEastM)) {
            knownEastM = atEastM;
            knownNorthM = atNorthM;
        }
        return PlaneMath.length(atEastM - knownEastM, atNorthM - knownNorthM) > KNOWN_WITHIN_M;
    }

    /**
     * Sees how far the boat is to keep off, before it is asked what that allows.
     *
     * @param own where the boat can stop
     * @param withinM as far along the line as it matters how near the line is
     */
    void look(double atEastM, double atNorthM, StoppingWay own, LineAhead along, double withinM) {
        line = along;
        eastM = atEastM;
        northM = atNorthM;
        alongEast = StrictMath.sin(line.courseRad());
        alongNorth = StrictMath.cos(line.courseRad());
        StoppingWay near = StoppingWay.between(
                lineEastM(line.onLineM(-withinM)),
                lineNorthM(line.onLineM(-withinM)),
                lineEastM(line.onLineM(withinM)),
                lineNorthM(line.onLineM(withinM)));
        StoppingWay back = back(eastM, northM);
        seesLine = true;
        for (int i = 0; i < edges.length; i++) {
            backM[i] = back.distanceM(edges[i], BACK * keepM) - ROUNDING_M;
            double mostM = near.distanceM(edges[i], own.distanceM(edges[i], keepM)) - ROUNDING_M;
            leastM[i] = backM[i] > 0 ? back.distanceM(edges[i], mostM) : mostM;
            seesLine &= backM[i] > 0;
        }
    }

    /** Whether nothing bars the boat from going straight back to its line. */
    boolean seesLine() {
        return seesLine;
    }

    /** Whether a boat may go where it stops on that way. */
    boolean allows(StoppingWay way) {
        StoppingWay back = back(way.toEastM(), way.toNorthM());
        for (int i = 0; i < edges.length; i++) {
            if (way.distanceM(edges[i], keepM) < leastM[i] || back.distanceM(edges[i], keepM) < backM[i]) {
                return false;
            }
        }
        return true;
    }

    /** Whether a boat keeps off as far as where it is, or as it is to keep, on a straight way from there. */
    boolean allowsStraight(double fromEastM, double fromNorthM, double toEastM, double toNorthM) {
        StoppingWay here = StoppingWay.between(fromEastM, fromNorthM, fromEastM, fromNorthM);
        StoppingWay way = StoppingWay.between(fromEastM, fromNorthM, toEastM, toNorthM);
        for (StoppingWay edge : edges) {
            if (way.distanceM(edge, keepM) < here.distanceM(edge, keepM) - ROUNDING_M) {
                return false;
            }
        }
        return true;
    }

    /** From a place to what is nearest to it on the line. */
    private StoppingWay back(double atEastM, double atNorthM) {
        double onLineM = line.onLineM((atEastM - eastM) * alongEast + (atNorthM - northM) * alongNorth);
        return StoppingWay.between(atEastM, atNorthM, lineEastM(onLineM), lineNorthM(onLineM));
    }

    /** A place on the line, so many metres farther along it than the boat. */
    private double lineEastM(double alongM) {
        return eastM + alongM * alongEast - line.besideM() * alongNorth;
    }

    private double lineNorthM(double alongM) {
        return northM + alongM * alongNorth + line.besideM() * alongEast;
    }
}
