package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.operation.distance.IndexedFacetDistance;
import org.locationtech.jts.simplify.DouglasPeuckerSimplifier;
import org.sami.crw.service.Interruption;

/**
 * Moves ways to the middle of gaps that are too narrow for their clearance: each place of a way is moved straight away from the nearest edge until another
 * one is as near, or until the clearance is kept. The result lies on the medial axis of the gap (C. Ó'Dúnlaing, C. K. Yap, A "retraction" method for
 * planning the motion of a disc, 1985).
 */
final class CentredGaps {
    /** Distance between the places that are moved, as a share of their distance to the nearest edge, and its limits in metres. */
    private static final double STEP_SHARE = 1.0 / 8;

    private static final double LEAST_STEP_M = 0.05;
    private static final double MOST_STEP_M = 0.5;

    /** A way with more places in gaps is left as it is: it would take too long. */
    private static final int MOST_PLACES = 4000;

    /** Bends flatter than this share of the distance to an edge are straight, within these limits in metres. */
    private static final double FLAT_SHARE = 0.04;

    private static final double LEAST_FLAT_M = 0.02;
    private static final double MOST_FLAT_M = 0.2;

    private static final double ROUNDING_M = 1e-3;
    private static final int BISECTIONS = 24;
    private static final GeometryFactory FACTORY = new GeometryFactory();

    private final IndexedFacetDistance edges;
    private final double wantedM;
    private final double narrowM;

    /**
     * Gaps between forbidden areas.
     *
     * @param edges distances to the areas
     * @param wantedM the clearance that a way keeps where there is room
     * @param narrowM half the width up to which a gap is narrow, also where it has room for the clearance; at least the clearance
     */
    CentredGaps(IndexedFacetDistance edges, double wantedM, double narrowM) {
        this.edges = edges;
        this.wantedM = wantedM;
        this.narrowM = Math.max(wantedM, narrowM);
    }

    /** The same way, in the middle of the gaps that it passes; both its ends stay. */
    List<Coordinate> centred(List<Coordinate> way) {
        Centred centred = new Centred(way.get(0));
        for (int i = 1; i < way.size() && centred.places <= MOST_PLACES; i++) {
            Coordinate from = way.get(i - 1);
            Coordinate to = way.get(i);
            double lengthM = from.distance(to);
            double atM = nextM(clearanceM(from));
            while (atM < lengthM && centred.places <= MOST_PLACES) {
                Interruption.check();
                Coordinate place = along(from, to, atM / lengthM);
                atM += centred.pass(place, false);
            }
            if (i < way.size() - 1) {
                centred.pass(to, true);
            }
        }
        return centred.places > MOST_PLACES ? way : centred.to(way.get(way.size() - 1));
    }

    /** How far the next place may be from one at a distance from the edges: none between is in a gap that is not seen. */
    private double nextM(double clearanceM) {
        double stepM = Math.max(LEAST_STEP_M, Math.min(MOST_STEP_M, STEP_SHARE * clearanceM));
        return Math.max(stepM, clearanceM - narrowM);
    }

    /** A way as far as it has been moved. */
    private final class Centred {
        private final List<Coordinate> done = new ArrayList<>();
        private final List<Coordinate> moved = new ArrayList<>(); // in the present gap
        private double nearestM = Double.POSITIVE_INFINITY; // to an edge in the present gap
        private int places; // in gaps

        Centred(Coordinate from) {
            done.add(from);
        }

        /**
         * Goes on to a place.
         *
         * @param isTurn whether the way has a point there, which stays where nothing is narrow
         * @return how far off the next place may be, in metres
         */
        double pass(Coordinate place, boolean isTurn) {
            double hereM = clearanceM(place);
            Coordinate centre = hereM < narrowM ? centre(place, hereM) : place;
            if (!centre.equals2D(place)) {
                places++;
                moved.add(centre);
                nearestM = Math.min(nearestM, clearanceM(centre));
            } else {
                leaveGap();
                if (isTurn) {
                    done.add(place);
                }
            }
            return nextM(hereM);
        }

        private void leaveGap() {
            done.addAll(straightened(moved, nearestM));
            moved.clear();
            nearestM = Double.POSITIVE_INFINITY;
        }

        List<Coordinate> to(Coordinate end) {
            leaveGap();
            done.add(end);
            return done;
        }
    }

    /** The place to which one is moved; itself where it stays. */
    private Coordinate centre(Coordinate place, double hereM) {
        Coordinate edge = edges.nearestPoints(FACTORY.createPoint(place))[0];
        if (hereM < ROUNDING_M) {
            return place;
        }
        double eastward = (place.x - edge.x) / hereM;
        double northward = (place.y - edge.y) / hereM;
        double lowM = hereM;
        double highM = narrowM;
        if (isNearest(edge, eastward, northward, narrowM)) {
            lowM = narrowM;
        }
        for (int i = 0; i < BISECTIONS && highM - lowM > ROUNDING_M; i++) {
            double middleM = (lowM + highM) / 2;
            if (isNearest(edge, eastward, northward, middleM)) {
                lowM = middleM;
            } else {
                highM = middleM;
            }
        }
        double toM = intendedM(hereM, lowM);
        return toM <= hereM + ROUNDING_M ? place : new Coordinate(edge.x + toM * eastward, edge.y + toM * northward);
    }

    /**
     * How far off the edge a place is to be: in the middle of a gap that has no room for the clearance, at the clearance where there is more room than in
     * any narrow gap, and between them as far as the gap is narrow.
     *
     * @param halfM half the width of the gap
     */
    private double intendedM(double hereM, double halfM) {
        double openM = Math.max(hereM, Math.min(wantedM, halfM));
        double middleUpToM = (wantedM + narrowM) / 2;
        if (halfM <= middleUpToM) {
            return Math.min(halfM, narrowM);
        }
        double share = (narrowM - halfM) / (narrowM - middleUpToM);
        return narrowM > wantedM ? openM + Math.max(0, share) * (halfM - openM) : openM;
    }

    /** Whether no other edge is nearer than one, at so many metres from it. */
    private boolean isNearest(Coordinate edge, double eastward, double northward, double metres) {
        return clearanceM(new Coordinate(edge.x + metres * eastward, edge.y + metres * northward))
                >= metres - ROUNDING_M;
    }

    private double clearanceM(Coordinate place) {
        return edges.distance(FACTORY.createPoint(place));
    }

    private static Coordinate along(Coordinate from, Coordinate to, double part) {
        return new Coordinate(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y));
    }

    private static List<Coordinate> straightened(List<Coordinate> moved, double nearestM) {
        if (moved.size() < 3) {
            return List.copyOf(moved);
        }
        double flatM = Math.max(LEAST_FLAT_M, Math.min(MOST_FLAT_M, FLAT_SHARE * nearestM));
        Geometry line = FACTORY.createLineString(moved.toArray(Coordinate[]::new));
        return Arrays.asList(DouglasPeuckerSimplifier.simplify(line, flatM).getCoordinates());
    }
}
