package org.sami.crw.sim.experiment.table;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.crw.report.picture.BoxPlotPicture;
import org.sami.crw.sim.experiment.statistics.Sample;

/** The box plots of a table: a panel for each gain, a box for each configuration. */
public final class BoxPlots {
    private static final Pattern NUMBER = Pattern.compile("-?\\d+(\\.\\d+)?");

    private BoxPlots() {}

    /** The content of a PNG file. */
    public static byte[] png(ResultTable table) throws IOException {
        List<BoxPlotPicture.Panel> panels = new ArrayList<>();
        for (int i = 0; i < table.file().columns().size(); i++) {
            TableColumn column = table.file().columns().get(i);
            if (column.kind() != TableColumn.Kind.MEAN) {
                int index = i;
                panels.add(new BoxPlotPicture.Panel(
                        column.title() + ", % gain of " + column.of() + " against " + column.against()
                                + "; ring: thesis",
                        table.lines().stream()
                                .map(line -> box(line, line.cells().get(index)))
                                .toList()));
            }
        }
        return BoxPlotPicture.png(table.file().title(), panels);
    }

    private static BoxPlotPicture.Box box(ResultTable.Line line, TableCell cell) {
        List<Double> quartiles = new ArrayList<>();
        Sample values = cell.values();
        for (double part : new double[] {0, 0.25, 0.5, 0.75, 1}) {
            values.quantile(part).ifPresent(quartiles::add);
        }
        List<Double> published = new ArrayList<>();
        Matcher first =
                NUMBER.matcher(line.published().getOrDefault(cell.column().published(), ""));
        if (first.find()) {
            published.add(Double.valueOf(first.group()));
        }
        return new BoxPlotPicture.Box(line.configuration().text(), quartiles, published);
    }
}
