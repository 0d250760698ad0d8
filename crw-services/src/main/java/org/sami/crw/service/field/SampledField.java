package org.sami.crw.service.field;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoPoint;

/**
 * Samples of one quantity, averaged over the square cells of a lattice. When there are too many cells, they double their side: memory is
 * bounded however long and far boats measure. For one thread.
 */
public final class SampledField {
    private static final double FIRST_CELL_M = 1;
    private static final int MOST_CELLS = 4096;

    /** A grid has at most so many cells a side. */
    private static final int LONGEST_SIDE = 100;

    /** Between samples that are at most so many cells apart values are interpolated. */
    private static final int REACH = 3;

    /** What is farther from the first sample was measured by a boat that did not know where it was. */
    private static final double FARTHEST_M = 20_000;

    private final LocalPlane plane;
    private double cellM = FIRST_CELL_M;
    private Map<Cell, Mean> cells = new LinkedHashMap<>();

    private record Cell(int column, int row) {
        Cell coarser() {
            return new Cell(Math.floorDiv(column, 2), Math.floorDiv(row, 2));
        }
    }

    private record Mean(double sum, long count) {
        Mean and(Mean other) {
            return new Mean(sum + other.sum, count + other.count);
        }

        double value() {
            return sum / count;
        }
    }

    private record Box(int west, int south, int east, int north) {
        int columns() {
            return east - west + 1;
        }

        int rows() {
            return north - south + 1;
        }
    }

    /** A field without samples on a plane; fields that are to be joined share one. */
    public SampledField(LocalPlane plane) {
        this.plane = Objects.requireNonNull(plane, "plane");
    }

    /** Adds a sample. One that is no number, or more than 20 km from the plane's origin, is left out. */
    public void add(GeoPoint at, double value) {
        double x = plane.x(at);
        double y = plane.y(at);
        if (!Double.isFinite(value) || Math.abs(x) > FARTHEST_M || Math.abs(y) > FARTHEST_M) {
            return;
        }
        Cell cell = new Cell((int) Math.floor(x / cellM), (int) Math.floor(y / cellM));
        cells.merge(cell, new Mean(value, 1), Mean::and);
        while (cells.size() > MOST_CELLS) {
            coarsen();
        }
    }

    /** Whether it has no samples. */
    public boolean isEmpty() {
        return cells.isEmpty();
    }

    /** A field with the samples of both, which lie on one plane. */
    public SampledField and(SampledField other) {
        SampledField joined = copy();
        SampledField added = other.copy();
        while (joined.cellM < added.cellM) {
            joined.coarsen();
        }
        while (added.cellM < joined.cellM) {
            added.coarsen();
        }
        added.cells.forEach((cell, mean) -> joined.cells.merge(cell, mean, Mean::and));
        return joined;
    }

    private SampledField copy() {
        SampledField copy = new SampledField(plane);
        copy.cellM = cellM;
        copy.cells = new LinkedHashMap<>(cells);
        return copy;
    }

    private void coarsen() {
        Map<Cell, Mean> coarser = new LinkedHashMap<>();
        cells.forEach((cell, mean) -> coarser.merge(cell.coarser(), mean, Mean::and));
        cells = coarser;
        cellM *= 2;
    }

    /** The values on a grid of at most 100 cells a side; empty where there is no sample. */
    public Optional<FieldGrid> grid() {
        if (isEmpty()) {
            return Optional.empty();
        }
        SampledField coarse = copy();
        Box box = coarse.box();
        while (Math.max(box.columns(), box.rows()) > LONGEST_SIDE) {
            coarse.coarsen();
            box = coarse.box();
        }
        return Optional.of(coarse.grid(box));
    }

    private Box box() {
        int west = Integer.MAX_VALUE;
        int south = Integer.MAX_VALUE;
        int east = Integer.MIN_VALUE;
        int north = Integer.MIN_VALUE;
        for (Cell cell : cells.keySet()) {
            west = Math.min(west, cell.column());
            east = Math.max(east, cell.column());
            south = Math.min(south, cell.row());
            north = Math.max(north, cell.row());
        }
        return new Box(west, south, east, north);
    }

    private FieldGrid grid(Box box) {
        double[] values = new double[box.columns() * box.rows()];
        for (int row = 0; row < box.rows(); row++) {
            for (int column = 0; column < box.columns(); column++) {
                values[row * box.columns() + column] = valueAt(new Cell(box.west() + column, box.south() + row));
            }
        }
        GeoPoint southWest = plane.point(box.west() * cellM, box.south() * cellM);
        GeoPoint next = plane.point((box.west() + 1) * cellM, (box.south() + 1) * cellM);
        return new FieldGrid(
                southWest,
                next.latDeg() - southWest.latDeg(),
                next.lonDeg() - southWest.lonDeg(),
                cellM,
                box.columns(),
                values);
    }

    /** The mean of a cell; where nothing was measured that of its neighbours, the nearer the heavier (inverse squared distance). */
    private double valueAt(Cell cell) {
        Mean own = cells.get(cell);
        if (own != null) {
            return own.value();
        }
        double sum = 0;
        double weights = 0;
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int north = -REACH; north <= REACH; north++) {
            for (int east = -REACH; east <= REACH; east++) {
                int squared = east * east + north * north;
                Mean near =
                        squared > REACH * REACH ? null : cells.get(new Cell(cell.column() + east, cell.row() + north));
                if (near != null) {
                    sum += near.value() / squared;
                    weights += 1.0 / squared;
                    least = Math.min(least, near.value());
                    greatest = Math.max(greatest, near.value());
                }
            }
        }
        return weights == 0
                ? Double.NaN
                : Math.max(least, Math.min(greatest, sum / weights)); // rounding adds no extreme
    }
}
