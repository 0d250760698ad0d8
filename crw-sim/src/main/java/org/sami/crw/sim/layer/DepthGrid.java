package org.sami.crw.sim.layer;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.sami.spn.value.TextNumbers;

/**
 * The depth of a water by place: an ESRI ASCII grid in degrees (WGS 84), whose values are metres below the surface, positive downwards. Between the middles of its
 * cells the depth is interpolated. Immutable.
 */
public final class DepthGrid {
    /** The most cells of a grid. */
    public static final int MOST_CELLS = 250_000;

    /** The greatest depth, in metres. */
    public static final double DEEPEST_M = 11_000;

    private final String text;
    private final GridHead head;
    private final double[] depthsM; // from the northwest on, row by row; NaN without data

    private DepthGrid(String text, GridHead head, double[] depthsM) {
        this.text = text;
        this.head = head;
        this.depthsM = depthsM;
    }

    /**
     * The depth at a place in metres; empty on land, where the grid has no data, and outside it.
     *
     * @param latDeg in degrees
     * @param lonDeg in degrees
     */
    public OptionalDouble depthM(double latDeg, double lonDeg) {
        double column = (lonDeg - head.westDeg()) / head.widthDeg();
        double row = head.rows() - 1 - (latDeg - head.southDeg()) / head.heightDeg();
        int nearest = index((int) Math.round(row), (int) Math.round(column));
        if (nearest < 0 || !(depthsM[nearest] > 0)) {
            return OptionalDouble.empty();
        }
        int north = Math.max(0, Math.min(head.rows() - 2, (int) Math.floor(row)));
        int west = Math.max(0, Math.min(head.columns() - 2, (int) Math.floor(column)));
        int south = Math.min(head.rows() - 1, north + 1);
        int east = Math.min(head.columns() - 1, west + 1);
        double southward = Math.max(0, Math.min(1, row - north));
        double eastward = Math.max(0, Math.min(1, column - west));
        double depthM = (1 - southward)
                        * ((1 - eastward) * depthsM[index(north, west)] + eastward * depthsM[index(north, east)])
                + southward * ((1 - eastward) * depthsM[index(south, west)] + eastward * depthsM[index(south, east)]);
        // NaN next to a cell without data
        return OptionalDouble.of(depthM > 0 ? depthM : depthsM[nearest]);
    }

    private int index(int row, int column) {
        return row < 0 || row >= head.rows() || column < 0 || column >= head.columns()
                ? -1
                : row * head.columns() + column;
    }

    /**
     * Reads a file's text.
     *
     * @throws IllegalArgumentException saying in which line what is wrong
     */
    public static DepthGrid parse(String text) {
        List<String> lines = text.lines().toList();
        GridHead.Reader headLines = new GridHead.Reader();
        int next = 0;
        while (next < lines.size() && !lines.get(next).isBlank() && Character.isLetter(first(lines.get(next)))) {
            headLines.line(lines.get(next));
            next++;
        }
        GridHead head = headLines.head();
        List<Double> depths = new ArrayList<>();
        for (; next < lines.size(); next++) {
            String line = lines.get(next).strip();
            for (String word : line.isEmpty() ? new String[0] : line.split("\\s+", -1)) {
                depths.add(depth(word, head.noData(), next + 1));
            }
        }
        if (depths.size() != head.columns() * head.rows()) {
            throw new IllegalArgumentException(
                    "line " + Math.max(1, lines.size()) + ": " + head.columns() + " x " + head.rows() + " cells need "
                            + head.columns() * head.rows() + " depths; there are " + depths.size());
        }
        if (depths.stream().noneMatch(depth -> depth > 0)) {
            throw new IllegalArgumentException(
                    "no depth is above 0: depths are positive downwards, in metres below the surface");
        }
        return new DepthGrid(
                text.strip(),
                head,
                depths.stream().mapToDouble(Double::doubleValue).toArray());
    }

    private static char first(String line) {
        return line.strip().charAt(0);
    }

    private static double depth(String word, double noData, int number) {
        double depthM = TextNumbers.real(word)
                .orElseThrow(() ->
                        new IllegalArgumentException("line " + number + ": '" + word + "' is no depth in metres"));
        if (depthM == noData) {
            return Double.NaN;
        }
        if (!(Math.abs(depthM) <= DEEPEST_M)) {
            throw new IllegalArgumentException(
                    "line " + number + ": a depth is at most " + DEEPEST_M + " m, not " + word);
        }
        return depthM;
    }

    @Override
    public boolean equals(Object other) {
        return other instanceof DepthGrid grid && grid.text.equals(text);
    }

    @Override
    public int hashCode() {
        return text.hashCode();
    }

    /** What {@link #parse} reads. */
    @Override
    public String toString() {
        return text;
    }
}
