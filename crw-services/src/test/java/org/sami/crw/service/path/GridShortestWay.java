package org.sami.crw.service.path;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.PriorityQueue;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoPoint;

/**
 * The shortest way over a grid of knight's and king's moves around the centre of the test's area: never shorter than the true one, and
 * at most 3 % longer but for what the grid's cells hide.
 */
final class GridShortestWay {
    private static final int[][] MOVES = {
        {1, 0}, {0, 1}, {1, 1}, {1, -1}, {2, 1}, {1, 2}, {2, -1}, {1, -2}, {3, 1}, {1, 3}, {3, -1}, {1, -3}
    };
    private final Water water;
    private final double cellM;
    private final int half;
    private final int width;

    GridShortestWay(Water water, double cellM, double halfM) {
        this.water = water;
        this.cellM = cellM;
        half = (int) Math.ceil(halfM / cellM);
        width = 2 * half + 1;
    }

    double lengthM(GeoPoint from, GeoPoint to) {
        double[] length = new double[width * width];
        Arrays.fill(length, Double.POSITIVE_INFINITY);
        PriorityQueue<double[]> open = new PriorityQueue<>((a, b) -> Double.compare(a[0], b[0]));
        length[cell(from)] = 0;
        open.add(new double[] {0, cell(from)});
        while (!open.isEmpty()) {
            double[] next = open.poll();
            int at = (int) next[1];
            if (at == cell(to)) {
                return next[0];
            }
            if (next[0] <= length[at]) {
                for (int neighbour : neighbours(at)) {
                    double through = next[0] + Geodesy.distanceM(point(at), point(neighbour));
                    if (through < length[neighbour] && water.clearanceM(List.of(point(at), point(neighbour))) > 0) {
                        length[neighbour] = through;
                        open.add(new double[] {through, neighbour});
                    }
                }
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    private List<Integer> neighbours(int cell) {
        List<Integer> neighbours = new ArrayList<>();
        for (int[] move : MOVES) {
            for (int sign : new int[] {1, -1}) {
                int x = cell % width + sign * move[0];
                int y = cell / width + sign * move[1];
                if (x >= 0 && y >= 0 && x < width && y < width) {
                    neighbours.add(y * width + x);
                }
            }
        }
        return neighbours;
    }

    private GeoPoint point(int cell) {
        return Geodesy.offset(AreaOfTest.CENTRE, (cell % width - half) * cellM, (cell / width - half) * cellM);
    }

    private int cell(GeoPoint point) {
        int x = (int) Math.round(water.plane().x(point) / cellM) + half;
        int y = (int) Math.round(water.plane().y(point) / cellM) + half;
        return y * width + x;
    }
}
