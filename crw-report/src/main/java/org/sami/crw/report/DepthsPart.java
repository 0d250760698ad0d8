package org.sami.crw.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/**
 * The map of a water's depth, made of what boats' sonars measured and nothing else.
 *
 * @param cellM side of a cell, in metres
 * @param readings how many are in it
 * @param cells of which a depth is known, from the southwest on; at least one
 * @param error of the map; empty where nobody knows the true depth
 */
public record DepthsPart(double cellM, long readings, List<DepthCell> cells, Optional<MapError> error)
        implements ReportPart {
    public DepthsPart {
        cells = List.copyOf(cells);
    }

    /**
     * A square of the map.
     *
     * @param middle of the square
     * @param depthM mean of its readings, or of those around it, in metres
     * @param readings in it; 0 where the depth is that between measured squares
     */
    public record DepthCell(MapPoint middle, double depthM, int readings) {}

    /**
     * How far the map's squares are from the true depths at their middles.
     *
     * @param cells of which the true depth is known
     * @param meanM mean of the amounts, in metres
     * @param p95M what 95 of 100 squares do not exceed, in metres
     */
    public record MapError(int cells, double meanM, double p95M) {}

    private record Summary(
            double cellM,
            long readings,
            int cells,
            double leastM,
            double mostM,
            @Nullable Double errorMeanM,
            @Nullable Double errorP95M) {}

    /** The least depth on the map, in metres. */
    public double leastM() {
        return cells.stream().mapToDouble(DepthCell::depthM).min().orElseThrow();
    }

    /** The greatest depth on the map, in metres. */
    public double mostM() {
        return cells.stream().mapToDouble(DepthCell::depthM).max().orElseThrow();
    }

    @Override
    public String name() {
        return "depths";
    }

    @Override
    public List<?> json() {
        return List.of(new Summary(
                cellM,
                readings,
                cells.size(),
                leastM(),
                mostM(),
                error.map(MapError::meanM).orElse(null),
                error.map(MapError::p95M).orElse(null)));
    }

    @Override
    public List<String> lines() {
        List<String> lines = new ArrayList<>();
        lines.add(String.format(
                Locale.ROOT,
                "depths      %.1f to %.1f m in %d squares of %.0f m, from %d readings",
                leastM(),
                mostM(),
                cells.size(),
                cellM,
                readings));
        error.ifPresent(off -> lines.add(String.format(
                Locale.ROOT,
                "  error     mean %.2f m, 95 of 100 squares within %.2f m of the true depth at their middle",
                off.meanM(),
                off.p95M())));
        return lines;
    }

    @Override
    public List<String> columns() {
        return List.of("lat_deg", "lon_deg", "east_m", "north_m", "depth_m", "readings");
    }

    @Override
    public List<List<Object>> rows() {
        return cells.stream()
                .map(cell -> List.<Object>of(
                        cell.middle().latDeg(),
                        cell.middle().lonDeg(),
                        cell.middle().eastM(),
                        cell.middle().northM(),
                        cell.depthM(),
                        cell.readings()))
                .toList();
    }
}
