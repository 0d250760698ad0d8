package org.sami.ui.map;

import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.geo.GeoBounds;

/**
 * Values on a grid of cells.
 *
 * @param title what was measured
 * @param unit of the values; empty text where they have none
 * @param rows of values from north to south
 * @param values row by row, each from west to east; not a number where nothing is known
 * @param least the value at the cold end of the scale
 * @param most the value at the hot end; larger than {@code least}
 * @param threshold cells with a smaller value are not shown; none where all are
 */
public record HeatMap(
        String title,
        String unit,
        GeoBounds bounds,
        int columns,
        int rows,
        List<Double> values,
        double least,
        double most,
        OptionalDouble threshold) {
    public HeatMap {
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(unit, "unit");
        Objects.requireNonNull(bounds, "bounds");
        Objects.requireNonNull(threshold, "threshold");
        values = List.copyOf(values);
        if (columns < 1 || rows < 1 || values.size() != columns * rows) {
            throw new IllegalArgumentException(
                    "A heat map of " + columns + " by " + rows + " cells has not " + values.size() + " values");
        }
        if (!(least < most)) {
            throw new IllegalArgumentException("The scale of a heat map does not go from " + least + " to " + most);
        }
    }

    /** The value of a cell; not a number where nothing is known. */
    double value(int column, int row) {
        return values.get(row * columns + column);
    }

    /** Where a value lies on the scale: 0 at the cold end, 1 at the hot one. */
    double part(double value) {
        return Math.max(0, Math.min(1, (value - least) / (most - least)));
    }

    /** Whether a value is shown. */
    boolean isShown(double value) {
        return !Double.isNaN(value) && (threshold.isEmpty() || value >= threshold.getAsDouble());
    }

    /** The value of the cell in which a point lies; none outside, and where nothing is known. */
    OptionalDouble at(GeoPoint point) {
        if (!bounds.contains(point)) {
            return OptionalDouble.empty();
        }
        double east = (point.lonDeg() - bounds.westDeg()) / Math.max(1e-12, bounds.eastDeg() - bounds.westDeg());
        double south = (bounds.northDeg() - point.latDeg()) / Math.max(1e-12, bounds.northDeg() - bounds.southDeg());
        double value = value(Math.min(columns - 1, (int) (east * columns)), Math.min(rows - 1, (int) (south * rows)));
        return Double.isNaN(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
    }
}
