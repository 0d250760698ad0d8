package org.sami.boat.mavlink;

import java.util.List;
import java.util.function.DoubleConsumer;

/** A polygon of a fence; it may cross the date line. Immutable. */
final class FencePolygon implements FenceShape {
    private static final double DEGREE_M = 111_195; // mean of the earth's, for an area that need not be exact

    private final Position first; // corner
    private final double[] east; // degrees from the first corner
    private final double[] north;

    /** A polygon of at least three corners. */
    FencePolygon(List<Position> corners) {
        first = corners.get(0);
        east = corners.stream().mapToDouble(corner -> corner.eastDeg(first)).toArray();
        north = corners.stream().mapToDouble(corner -> corner.northDeg(first)).toArray();
    }

    @Override
    public boolean contains(Position at) {
        double x = at.eastDeg(first);
        double y = at.northDeg(first);
        boolean inside = false;
        for (int i = 0; i < east.length; i++) {
            int j = after(i);
            boolean spans = north[i] > y != north[j] > y;
            if (spans && x < east[i] + (east[j] - east[i]) * (y - north[i]) / (north[j] - north[i])) {
                inside = !inside;
            }
        }
        return inside;
    }

    @Override
    public void crossings(Position from, Position to, DoubleConsumer fractions) {
        double x = from.eastDeg(first);
        double y = from.northDeg(first);
        double dx = to.eastDeg(from);
        double dy = to.northDeg(from);
        for (int i = 0; i < east.length; i++) {
            int j = after(i);
            double edgeX = east[j] - east[i];
            double edgeY = north[j] - north[i];
            double across = dx * edgeY - dy * edgeX;
            if (across != 0) { // a way along an edge crosses its neighbours
                double ofWay = ((east[i] - x) * edgeY - (north[i] - y) * edgeX) / across;
                double ofEdge = ((east[i] - x) * dy - (north[i] - y) * dx) / across;
                if (ofWay >= 0 && ofWay <= 1 && ofEdge >= 0 && ofEdge <= 1) {
                    fractions.accept(ofWay);
                }
            }
        }
    }

    /** Whether two of its edges cross. */
    boolean crossesItself() {
        for (int i = 0; i < east.length; i++) {
            for (int j = i + 1; j < east.length; j++) {
                if (isOnBothSides(i, j) && isOnBothSides(j, i)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether the ends of an edge are on different sides of the line of another one; an end on the line is on neither. */
    private boolean isOnBothSides(int edge, int ofEdge) {
        return side(ofEdge, edge) * side(ofEdge, after(edge)) < 0;
    }

    private double side(int edge, int corner) {
        int end = after(edge);
        return Math.signum((east[end] - east[edge]) * (north[corner] - north[edge])
                - (north[end] - north[edge]) * (east[corner] - east[edge]));
    }

    /** About how large it is, in square metres. */
    double areaM2() {
        double twice = 0;
        for (int i = 0; i < east.length; i++) {
            int j = after(i);
            twice += east[i] * north[j] - east[j] * north[i];
        }
        return Math.abs(twice) / 2 * DEGREE_M * DEGREE_M * Math.cos(Math.toRadians(first.latDeg()));
    }

    private int after(int corner) {
        return (corner + 1) % east.length;
    }
}
