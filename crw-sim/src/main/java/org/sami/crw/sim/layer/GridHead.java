package org.sami.crw.sim.layer;

import java.util.HashMap;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import org.sami.spn.value.TextNumbers;

/**
 * The head of an ESRI ASCII grid in degrees.
 *
 * @param columns from west to east
 * @param rows from north to south
 * @param westDeg longitude of the middles of the cells farthest west
 * @param southDeg latitude of the middles of the cells farthest south
 * @param widthDeg of a cell
 * @param heightDeg of a cell
 * @param noData stands where no depth is known
 */
record GridHead(
        int columns, int rows, double westDeg, double southDeg, double widthDeg, double heightDeg, double noData) {
    private static final double USUAL_NO_DATA = -9999;
    private static final double WIDEST_DEG = 10;
    private static final int SHOWN = 60; // characters of a wrong line
    private static final Set<String> NAMES = Set.of(
            "ncols",
            "nrows",
            "xllcorner",
            "xllcenter",
            "yllcorner",
            "yllcenter",
            "cellsize",
            "dx",
            "dy",
            "nodata_value");

    /** Reads the lines of a head, one after the other. */
    static final class Reader {
        private final Map<String, Double> values = new HashMap<>();
        private int lines;

        void line(String line) {
            lines++;
            String[] words = line.strip().split("\\s+", -1);
            String name = words[0].toLowerCase(Locale.ROOT);
            OptionalDouble value = words.length == 2 ? TextNumbers.real(words[1]) : OptionalDouble.empty();
            if (!NAMES.contains(name) || value.isEmpty()) {
                throw new IllegalArgumentException("line " + lines
                        + ": expected is one of ncols, nrows, xllcorner, yllcorner, cellsize, NODATA_value and a"
                        + " number, not '" + shortened(line.strip()) + "'");
            }
            values.put(name, value.getAsDouble());
        }

        private static String shortened(String line) {
            return line.length() <= SHOWN ? line : line.substring(0, SHOWN) + " ...";
        }

        GridHead head() {
            double columns = value("ncols");
            double rows = value("nrows");
            require(
                    columns == Math.rint(columns)
                            && rows == Math.rint(rows)
                            && columns >= 2
                            && rows >= 2
                            && columns * rows <= DepthGrid.MOST_CELLS,
                    "a grid has 2 or more columns and rows and up to " + DepthGrid.MOST_CELLS + " cells");
            double width = values.containsKey("dx") ? value("dx") : value("cellsize");
            double height = values.containsKey("dy") ? value("dy") : value("cellsize");
            double west = values.containsKey("xllcenter") ? value("xllcenter") : value("xllcorner") + width / 2;
            double south = values.containsKey("yllcenter") ? value("yllcenter") : value("yllcorner") + height / 2;
            require(
                    Math.abs(west) <= 180 && Math.abs(south) <= 90,
                    "the first cell lies at " + west + ", " + south
                            + ": x and y are longitude and latitude in degrees (WGS 84)");
            require(
                    width > 0 && height > 0 && width * columns <= WIDEST_DEG && height * rows <= WIDEST_DEG,
                    "cellsize is in degrees, and a grid is at most 10 degrees wide");
            return new GridHead(
                    (int) columns,
                    (int) rows,
                    west,
                    south,
                    width,
                    height,
                    values.getOrDefault("nodata_value", USUAL_NO_DATA));
        }

        private double value(String name) {
            Double value = values.get(name);
            if (value == null) {
                throw new IllegalArgumentException("line " + Math.max(1, lines) + ": the head ends without " + name);
            }
            return value;
        }

        private void require(boolean holds, String message) {
            if (!holds) {
                throw new IllegalArgumentException("line " + Math.max(1, lines) + ": " + message);
            }
        }
    }
}
