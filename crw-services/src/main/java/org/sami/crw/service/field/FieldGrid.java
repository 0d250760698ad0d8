package org.sami.crw.service.field;

import java.util.Arrays;
import java.util.Objects;
import java.util.OptionalDouble;
import org.sami.spn.value.GeoPoint;

/** Values on a grid of cells that are equal in WGS-84 degrees and about square on the water; immutable. */
public final class FieldGrid {
    private final GeoPoint southWest;
    private final double latStepDeg;
    private final double lonStepDeg;
    private final double cellM;
    private final int columns;
    private final double[] values;
    private final double least;
    private final double greatest;

    /** @param values row by row from the south-west, each from west to east; NaN where nothing is known, not everywhere */
    FieldGrid(GeoPoint southWest, double latStepDeg, double lonStepDeg, double cellM, int columns, double[] values) {
        this.southWest = Objects.requireNonNull(southWest, "southWest");
        this.latStepDeg = latStepDeg;
        this.lonStepDeg = lonStepDeg;
        this.cellM = cellM;
        this.columns = columns;
        this.values = values.clone();
        least = Arrays.stream(values).filter(Double::isFinite).min().orElseThrow();
        greatest = Arrays.stream(values).filter(Double::isFinite).max().orElseThrow();
    }

    /** The outer corner of the first cell. */
    public GeoPoint southWest() {
        return southWest;
    }

    /** Height of a cell in degrees of latitude. */
    public double latStepDeg() {
        return latStepDeg;
    }

    /** Width of a cell in degrees of longitude. */
    public double lonStepDeg() {
        return lonStepDeg;
    }

    /** Side of a cell in metres. */
    public double cellM() {
        return cellM;
    }

    /** Cells from west to east. */
    public int columns() {
        return columns;
    }

    /** Cells from south to north. */
    public int rows() {
        return values.length / columns;
    }

    /** The least value that is known. */
    public double least() {
        return least;
    }

    /** The greatest value that is known. */
    public double greatest() {
        return greatest;
    }

    /** The value of a cell, by its column from the west and its row from the south; empty where nothing is known. */
    public OptionalDouble value(int column, int row) {
        double value = at(column, row);
        return Double.isNaN(value) ? OptionalDouble.empty() : OptionalDouble.of(value);
    }

    double at(int column, int row) {
        return values[Objects.checkIndex(row, rows()) * columns + Objects.checkIndex(column, columns)];
    }

    /** The centre of a cell; fractions are between centres. */
    public GeoPoint centre(double column, double row) {
        return GeoPoint.of(
                southWest.latDeg() + (row + 0.5) * latStepDeg, southWest.lonDeg() + (column + 0.5) * lonStepDeg);
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof FieldGrid grid
                && grid.southWest.equals(southWest)
                && grid.columns == columns
                && grid.cellM == cellM
                && Arrays.equals(grid.values, values);
    }

    @Override
    public int hashCode() {
        return Objects.hash(southWest, columns, Arrays.hashCode(values));
    }

    @Override
    public String toString() {
        return columns + " x " + rows() + " cells of " + cellM + " m from " + southWest;
    }
}
