package org.sami.boat.server.traffic;

import java.util.List;
import java.util.Optional;
import org.sami.boat.link.NoGoEdge;
import org.sami.boat.link.NoGoEdges;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.PlaneMath;

/**
 * The edges of no-go areas near a boat, on the plane of {@link Surroundings}. A boat away from its line keeps the same distance from them as its line
 * does; where it is closer already, it comes no closer. It also stays where it can return straight to its line. A boat that errors or a current
 * have brought closer moves off ({@link #off}); a boat inside an area only moves towards its edge (docs/services.md).
 */
final class NoGoBorder {
    /** No edge is near. All boats share this instance: it records nothing. */
    static final NoGoBorder NONE = new NoGoBorder(0, new Segment[0]);

    /** How far a boat may move from where it received the edges, in metres: the base sends edges that much beyond those that matter. */
    private static final double VALID_WITHIN_M = 20;

    /** Share of its distance that a boat keeps on the straight way back to its line. */
    private static final double WAY_BACK_SHARE = 0.5;

    /** A way that passes an edge closer than this, in metres, is barred. */
    private static final double BARRED_WITHIN_M = 0.3;

    private static final double ROUNDING_M = 1e-6;

    private final double keepM;
    private final Segment[] edges;
    private final double[] leastM; // to each edge
    private final double[] backM; // from each edge to the straight way back to the line
    private double knownEastM = Double.NaN; // position of the boat when it received them
    private double knownNorthM;
    private LineAhead line = LineAhead.straight(0, 0);
    private double eastM;
    private double northM;
    private double alongEast; // unit vector of the line
    private double alongNorth;
    private boolean seesLine = true;
    private double depthM; // of the boat inside an area; negative outside
    private Optional<LineAhead> off = Optional.empty();

    private NoGoBorder(double keepM, Segment[] edges) {
        this.keepM = keepM;
        this.edges = edges;
        leastM = new double[edges.length];
        backM = new double[edges.length];
    }

    /** The edges that the base has sent. */
    static NoGoBorder of(NoGoEdges received, LocalFrame plane) {
        List<NoGoEdge> rows = received.edges();
        Segment[] edges = new Segment[rows.size()];
        for (int i = 0; i < edges.length; i++) {
            NoGoEdge row = rows.get(i);
            edges[i] = Segment.between(
                    plane.eastM(row.fromLatDeg(), row.fromLonDeg()),
                    plane.northM(row.fromLatDeg(), row.fromLonDeg()),
                    plane.eastM(row.toLatDeg(), row.toLonDeg()),
                    plane.northM(row.toLatDeg(), row.toLonDeg()));
        }
        return new NoGoBorder(received.keepM(), edges);
    }

    boolean isEmpty() {
        return edges.length == 0;
    }

    /** Distance from edges that the boat keeps where its line keeps it too, in metres. */
    double keepM() {
        return keepM;
    }

    /** Whether the boat has moved so far since it received the edges that unknown ones may be near. */
    boolean isPast(double atEastM, double atNorthM) {
        if (isEmpty()) {
            return false;
        }
        if (Double.isNaN(knownEastM)) {
            knownEastM = atEastM;
            knownNorthM = atNorthM;
        }
        return PlaneMath.length(atEastM - knownEastM, atNorthM - knownNorthM) > VALID_WITHIN_M;
    }

    /**
     * Measures the distances to keep; called before {@link #allows}.
     *
     * @param own stopping segment of the boat
     * @param withinM the stretch of the line, ahead and behind, whose distance from edges counts
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
            backM[i] = back.distanceM(edges[i], WAY_BACK_SHARE * keepM) - ROUNDING_M;
            double mostM = near.distanceM(edges[i], own.distanceM(edges[i], keepM)) - ROUNDING_M;
            leastM[i] = backM[i] > 0 ? back.distanceM(edges[i], mostM) : mostM;
            seesLine &= backM[i] > 0;
        }
    }

    /** Measures how deep inside an area the boat is, and the way off an edge to which it is closer than its line. */
    private void measureNearness(Segment near) {
        depthM = depthM(eastM, northM);
        off = Optional.empty();
        if (depthM(lineEastM(line.onLineM(0)), lineNorthM(line.onLineM(0))) > 0) {
            return; // its path leads inside
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

    /** How deep inside an area a place is, in metres; negative outside. Areas lie to starboard of their edges. */
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

    /** The line straight off an edge to which the boat is closer than its line, or out of an area; its length is how much is missing. */
    Optional<LineAhead> off() {
        return off;
    }

    /** Whether the boat can return straight to its line. */
    boolean seesLine() {
        return seesLine;
    }

    /** Whether the boat may enter this stopping segment. */
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

    /** Whether a straight way comes no closer to any edge than its beginning, or than the distance to keep. */
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
            if (way.distanceM(edge, BARRED_WITHIN_M) < BARRED_WITHIN_M) {
                return true;
            }
        }
        return false;
    }

    /** From a place to the nearest point of the line. */
    private Segment back(double atEastM, double atNorthM) {
        double onLineM = line.onLineM((atEastM - eastM) * alongEast + (atNorthM - northM) * alongNorth);
        return Segment.between(atEastM, atNorthM, lineEastM(onLineM), lineNorthM(onLineM));
    }

    /** A point of the line, {@code alongM} metres farther along it than the boat. */
    private double lineEastM(double alongM) {
        return eastM + alongM * alongEast - line.offsetM() * alongNorth;
    }

    private double lineNorthM(double alongM) {
        return northM + alongM * alongNorth + line.offsetM() * alongEast;
    }
}
