package org.sami.boat.server.traffic;

import java.util.List;
import java.util.Optional;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * The edge of what a boat is not to enter, as far as it is near, on the plane of {@link Surroundings}. A boat that has left its line keeps as far off it as
 * its line does, and where it is nearer already it comes no nearer; and it stays where it can go straight back to its line, so that nothing bars
 * it from there. One that errors or a current have brought nearer goes off ({@link #off}); inside, it goes only where it is less deep (docs/decisions, 0321).
 */
final class NoGoBorder {
    /** Nothing is near. All boats share it: it records nothing. */
    static final NoGoBorder NONE = new NoGoBorder(0, new Segment[0]);

    /** How far a boat may have come since it was told of the edges, in metres: they reach that much farther than what is near. */
    private static final double KNOWN_WITHIN_M = 20;

    /** The part of its distance that a boat keeps on the straight way back to its line. */
    private static final double BACK = 0.5;

    /** A way that passes an edge nearer than that, in metres, is barred. */
    private static final double CLOSE_M = 0.3;

    private static final double ROUNDING_M = 1e-6;

    private final double keepM;
    private final Segment[] edges;
    private final double[] leastM; // to each edge
    private final double[] backM; // from each edge to the straight way back to the line
    private double knownEastM = Double.NaN; // where the boat was when it was told of them
    private double knownNorthM;
    private LineAhead line;
    private double eastM;
    private double northM;
    private double alongEast; // unit vector of the line
    private double alongNorth;
    private boolean seesLine = true;
    private double depthM; // of where the boat is; negative outside
    private Optional<LineAhead> off = Optional.empty();

    private NoGoBorder(double keepM, Segment[] edges) {
        this.keepM = keepM;
        this.edges = edges;
        leastM = new double[edges.length];
        backM = new double[edges.length];
    }

    /** The edges that a base tells of. */
    static NoGoBorder of(NoGoEdges told, LocalFrame plane) {
        List<NoGoEdge> rows = told.edges();
        Segment[] edges = new Segment[rows.size()];
        for (int i = 0; i < edges.length; i++) {
            NoGoEdge row = rows.get(i);
            edges[i] = Segment.between(
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

    /** How far the boat keeps off it where its line does, in metres. */
    double keepM() {
        return keepM;
    }

    /** Whether the boat was told of it so far from here that other edges may be near. */
    boolean isPast(double atEastM, double atNorthM) {
        if (isEmpty()) {
            return false;
        }
        if (Double.isNaN(knownEastM)) {
            knownEastM = atEastM;
            knownNorthM = atNorthM;
        }
        return PlaneMath.length(atEastM - knownEastM, atNorthM - knownNorthM) > KNOWN_WITHIN_M;
    }

    /**
     * Measures how far the boat is to keep off, before {@link #allows} is asked.
     *
     * @param own where the boat can stop
     * @param withinM as far along the line as it matters how near the line is
     */
    void measure(double atEastM, double atNorthM, Segment own, LineAhead along, double withinM) {
        if (isEmpty()) {
            return;
        }
        line = along;
        eastM = atEastM;
        northM = atNorthM;
        alongEast = StrictMath.sin(line.courseRad());
        alongNorth = StrictMath.cos(line.courseRad());
        Segment near = Segment.between(
                lineEastM(line.onLineM(-withinM)),
                lineNorthM(line.onLineM(-withinM)),
                lineEastM(line.onLineM(withinM)),
                lineNorthM(line.onLineM(withinM)));
        Segment back = back(eastM, northM);
        seesLine = true;
        measureNearness(near);
        for (int i = 0; i < edges.length; i++) {
            backM[i] = back.distanceM(edges[i], BACK * keepM) - ROUNDING_M;
            double mostM = near.distanceM(edges[i], own.distanceM(edges[i], keepM)) - ROUNDING_M;
            leastM[i] = backM[i] > 0 ? back.distanceM(edges[i], mostM) : mostM;
            seesLine &= backM[i] > 0;
        }
    }

    /** Measures how deep inside the boat is, and how it gets off an edge to which it is nearer than its line comes. */
    private void measureNearness(Segment near) {
        depthM = depthM(eastM, northM);
        off = Optional.empty();
        if (depthM(lineEastM(line.onLineM(0)), lineNorthM(line.onLineM(0))) > 0) {
            return; // there it has been sent
        }
        double mostM = 0;
        for (Segment edge : edges) {
            double hereM = edge.distanceM(eastM, northM);
            double nearerM = near.distanceM(edge, keepM) - hereM;
            if (depthM <= 0 && nearerM > mostM) {
                mostM = nearerM;
                off = Optional.of(LineAhead.straight(edge.awayRad(eastM, northM), nearerM));
            } else if (depthM > 0 && hereM == depthM) {
                off = Optional.of(LineAhead.straight(edge.awayRad(eastM, northM) + Math.PI, depthM + keepM));
            }
        }
    }

    /** How deep inside a place is, in metres; negative outside. What is not to be entered lies to starboard of its edges. */
    private double depthM(double atEastM, double atNorthM) {
        double nearestM = Double.MAX_VALUE;
        double portM = 0;
        for (Segment edge : edges) {
            double awayM = edge.distanceM(atEastM, atNorthM);
            double edgePortM = edge.portM(atEastM, atNorthM);
            boolean isAtSameCorner = awayM < nearestM + ROUNDING_M && Math.abs(edgePortM) > Math.abs(portM);
            if (awayM < nearestM - ROUNDING_M || isAtSameCorner) {
                nearestM = Math.min(awayM, nearestM);
                portM = edgePortM;
            }
        }
        return portM < -ROUNDING_M ? nearestM : -nearestM;
    }

    /** The line straight off an edge to which the boat is nearer than its line comes, or out of what it is not to enter; as long as it is too near. */
    Optional<LineAhead> off() {
        return off;
    }

    /** Whether nothing bars the boat from going straight back to its line. */
    boolean seesLine() {
        return seesLine;
    }

    /** Whether a boat may go where it stops on that way. */
    boolean allows(Segment way) {
        if (isEmpty()) {
            return true;
        }
        if (depthM > 0) {
            return depthM(way.toEastM(), way.toNorthM()) < depthM;
        }
        Segment back = back(way.toEastM(), way.toNorthM());
        for (int i = 0; i < edges.length; i++) {
            if (way.distanceM(edges[i], keepM) < leastM[i] || back.distanceM(edges[i], keepM) < backM[i]) {
                return false;
            }
        }
        return true;
    }

    /** Whether a boat keeps off as far as where it is, or as it is to keep, on a straight way from there. */
    boolean allowsStraight(double fromEastM, double fromNorthM, double toEastM, double toNorthM) {
        Segment here = Segment.between(fromEastM, fromNorthM, fromEastM, fromNorthM);
        Segment way = Segment.between(fromEastM, fromNorthM, toEastM, toNorthM);
        for (Segment edge : edges) {
            if (way.distanceM(edge, keepM) < here.distanceM(edge, keepM) - ROUNDING_M) {
                return false;
            }
        }
        return true;
    }

    /** Whether a straight way crosses an edge, or nearly so. */
    boolean bars(double fromEastM, double fromNorthM, double toEastM, double toNorthM) {
        Segment way = Segment.between(fromEastM, fromNorthM, toEastM, toNorthM);
        for (Segment edge : edges) {
            if (way.distanceM(edge, CLOSE_M) < CLOSE_M) {
                return true;
            }
        }
        return false;
    }

    /** From a place to what is nearest to it on the line. */
    private Segment back(double atEastM, double atNorthM) {
        double onLineM = line.onLineM((atEastM - eastM) * alongEast + (atNorthM - northM) * alongNorth);
        return Segment.between(atEastM, atNorthM, lineEastM(onLineM), lineNorthM(onLineM));
    }

    /** A place on the line, so many metres farther along it than the boat. */
    private double lineEastM(double alongM) {
        return eastM + alongM * alongEast - line.besideM() * alongNorth;
    }

    private double lineNorthM(double alongM) {
        return northM + alongM * alongNorth + line.besideM() * alongEast;
    }
}
