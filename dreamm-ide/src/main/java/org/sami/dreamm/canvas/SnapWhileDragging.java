package org.sami.dreamm.canvas;

import java.util.List;
import java.util.Optional;
import org.sami.spn.model.LayoutPoint;

/**
 * Where a vertex that is dragged comes to lie: in line with another vertex where it is near that, else on the grid.
 *
 * @param dx by how much all that is dragged moves
 * @param column the line on which it lies with another, in drawing units
 */
record SnapWhileDragging(double dx, double dy, Optional<Double> column, Optional<Double> row) {
    /** The distance of the grid's lines, in drawing units. */
    static final double GRID = 20;

    private static final double SNAP_DISTANCE = 7;

    /** As it is dragged, without a grid. */
    static SnapWhileDragging free(double dx, double dy) {
        return new SnapWhileDragging(dx, dy, Optional.empty(), Optional.empty());
    }

    /**
     * Where it comes to lie.
     *
     * @param from the centre of the vertex under the pointer, before
     * @param others centres of those that are not dragged
     */
    static SnapWhileDragging of(LayoutPoint from, double dx, double dy, List<LayoutPoint> others) {
        Optional<Double> column = nearest(from.x() + dx, others, true);
        Optional<Double> row = nearest(from.y() + dy, others, false);
        return new SnapWhileDragging(
                column.orElseGet(() -> onGrid(from.x() + dx)) - from.x(),
                row.orElseGet(() -> onGrid(from.y() + dy)) - from.y(),
                column,
                row);
    }

    private static double onGrid(double value) {
        return Math.round(value / GRID) * GRID;
    }

    private static Optional<Double> nearest(double value, List<LayoutPoint> others, boolean x) {
        Double best = null;
        for (LayoutPoint other : others) {
            double line = x ? other.x() : other.y();
            if (Math.abs(line - value) <= SNAP_DISTANCE
                    && (best == null || Math.abs(line - value) < Math.abs(best - value))) {
                best = line;
            }
        }
        return Optional.ofNullable(best);
    }
}
