package org.sami.crw.service.field;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.value.GeoPoint;

/**
 * Where a field has one value: pieces of lines, each within four neighbouring cells (marching squares over the cells' centres).
 * Immutable.
 *
 * @param value in the unit of the field
 */
public record ContourLine(double value, List<Segment> segments) {

    /** A straight piece. */
    public record Segment(GeoPoint from, GeoPoint to) {}

    public ContourLine {
        segments = List.copyOf(segments);
    }

    /** The line of a value on a grid; nothing is drawn next to cells without a value. */
    public static ContourLine of(FieldGrid grid, double value) {
        List<Segment> segments = new ArrayList<>();
        for (int row = 0; row + 1 < grid.rows(); row++) {
            for (int column = 0; column + 1 < grid.columns(); column++) {
                addSquare(grid, column, row, value, segments);
            }
        }
        return new ContourLine(value, segments);
    }

    /** The line enters and leaves a square where two neighbouring corners lie on either side of the value. */
    private static void addSquare(FieldGrid grid, int column, int row, double value, List<Segment> segments) {
        int[][] corners = {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}};
        for (int[] corner : corners) {
            if (Double.isNaN(grid.at(corner[0], corner[1]))) {
                return;
            }
        }
        List<GeoPoint> crossings = new ArrayList<>();
        for (int i = 0; i < corners.length; i++) {
            int[] from = corners[i];
            int[] to = corners[(i + 1) % corners.length];
            double a = grid.at(from[0], from[1]);
            double b = grid.at(to[0], to[1]);
            if (a >= value != b >= value) {
                double part = (value - a) / (b - a);
                crossings.add(grid.centre(from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])));
            }
        }
        for (int i = 0; i + 1 < crossings.size(); i += 2) {
            segments.add(new Segment(crossings.get(i), crossings.get(i + 1)));
        }
    }
}
