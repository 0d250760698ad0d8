package org.sami.crw.operator.map;

import java.util.List;
import java.util.Objects;
import org.sami.crw.markup.MapRelevance.Visualization;
import org.sami.crw.service.field.ContourLine;
import org.sami.crw.service.field.FieldGrid;
import org.sami.crw.service.field.Legend;

/**
 * What a sensor measured, ready to be drawn.
 *
 * @param contours lines at the legend's marks; empty for other visualizations
 * @param threshold from which value on cells are drawn, with {@link Visualization#THRESHOLD}
 * @param why who asked for it, in words
 */
public record SensorLayer(
        SensorChannel channel,
        Visualization visualization,
        FieldGrid grid,
        List<ContourLine> contours,
        double threshold,
        Legend legend,
        String why) {
    public SensorLayer {
        Objects.requireNonNull(channel, "channel");
        Objects.requireNonNull(visualization, "visualization");
        Objects.requireNonNull(grid, "grid");
        contours = List.copyOf(contours);
        Objects.requireNonNull(legend, "legend");
        Objects.requireNonNull(why, "why");
    }

    /** Whether a cell is drawn: it has a value, which reaches the threshold where there is one. */
    public boolean isDrawn(int column, int row) {
        double least = visualization == Visualization.THRESHOLD ? threshold : Double.NEGATIVE_INFINITY;
        return grid.value(column, row).orElse(Double.NaN) >= least;
    }
}
