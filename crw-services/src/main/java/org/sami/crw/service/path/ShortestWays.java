package org.sami.crw.service.path;

import java.util.List;
import org.locationtech.jts.geom.Coordinate;
import org.sami.crw.service.Interruption;

/**
 * The lengths of the shortest ways between some places of a visibility graph, all at once: what sees what is tested once, then each place searches
 * through the corners (E. W. Dijkstra, A note on two problems in connexion with graphs, 1959). For n corners and p places O((n + p)²) tests and
 * O(p n²) steps.
 */
final class ShortestWays {
    private final VisibilityGraph graph;
    private final List<Coordinate> corners;
    private final List<Coordinate> places;
    private final double[][] betweenCorners;
    /** From each place to each corner, straight; infinite where that is not free, or on no shortest way. */
    private final double[][] toCorner;

    ShortestWays(VisibilityGraph graph, List<Coordinate> places) {
        this.graph = graph;
        this.places = places;
        corners = graph.corners();
        betweenCorners = new double[corners.size()][corners.size()];
        toCorner = new double[places.size()][corners.size()];
        for (int a = 0; a < corners.size(); a++) {
            Interruption.check();
            Coordinate at = corners.get(a);
            for (int b = 0; b < a; b++) {
                double straight = graph.isTangent(b, at) ? fromCorner(a, corners.get(b)) : Double.POSITIVE_INFINITY;
                betweenCorners[a][b] = straight;
                betweenCorners[b][a] = straight;
            }
            for (int place = 0; place < places.size(); place++) {
                toCorner[place][a] = fromCorner(a, places.get(place));
            }
        }
    }

    private double fromCorner(int corner, Coordinate other) {
        Coordinate at = corners.get(corner);
        return graph.isTangent(corner, other) && graph.sees(at, other) ? at.distance(other) : Double.POSITIVE_INFINITY;
    }

    /** By the places' indices; infinite where there is no way. */
    double[][] lengthsM() {
        double[][] lengthM = new double[places.size()][places.size()];
        for (int from = 0; from < lengthM.length; from++) {
            Interruption.check();
            double[] byCorner = lengthsToCorners(from);
            for (int to = 0; to < from; to++) {
                double least = graph.sees(places.get(from), places.get(to))
                        ? places.get(from).distance(places.get(to))
                        : Double.POSITIVE_INFINITY;
                for (int corner = 0; corner < byCorner.length; corner++) {
                    least = Math.min(least, byCorner[corner] + toCorner[to][corner]);
                }
                lengthM[from][to] = least;
                lengthM[to][from] = least;
            }
        }
        return lengthM;
    }

    private double[] lengthsToCorners(int place) {
        double[] length = toCorner[place].clone();
        boolean[] done = new boolean[length.length];
        for (int next = nearest(length, done); next >= 0; next = nearest(length, done)) {
            done[next] = true;
            for (int corner = 0; corner < length.length; corner++) {
                length[corner] = Math.min(length[corner], length[next] + betweenCorners[next][corner]);
            }
        }
        return length;
    }

    /** The corner that is nearest of those that are not done; below zero where none can be reached. */
    private static int nearest(double[] length, boolean[] done) {
        int nearest = -1;
        for (int corner = 0; corner < length.length; corner++) {
            if (!done[corner]
                    && length[corner] < Double.POSITIVE_INFINITY
                    && (nearest < 0 || length[corner] < length[nearest])) {
                nearest = corner;
            }
        }
        return nearest;
    }
}
