package org.sami.crw.sim.experiment.table;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.crw.sim.experiment.table.ExperimentFile.Configuration;

/**
 * The table of an experiment.
 *
 * @param file the experiment
 * @param lines a line for each configuration
 * @param faults what became of repetitions that do not count, in words
 */
public record ResultTable(ExperimentFile file, List<Line> lines, List<String> faults) {
    public ResultTable {
        Objects.requireNonNull(file, "file");
        lines = List.copyOf(lines);
        faults = List.copyOf(faults);
    }

    /**
     * A configuration's line.
     *
     * @param counted repetitions of which every version ended and visited all locations
     * @param failed repetitions that did not, and are in no mean
     * @param redrawn attempts whose incidents could not be placed
     */
    public record Line(
            Configuration configuration,
            List<TableCell> cells,
            Map<String, String> published,
            int counted,
            int failed,
            int redrawn) {
        public Line {
            Objects.requireNonNull(configuration, "configuration");
            cells = List.copyOf(cells);
            published = Map.copyOf(published);
        }
    }

    /** The table of an experiment's runs. */
    public static ResultTable of(ExperimentFile file, List<RunRow> rows) {
        List<Line> lines = new ArrayList<>();
        List<String> faults = new ArrayList<>();
        for (Configuration one : file.configurations()) {
            List<RunRow> its = rows.stream()
                    .filter(row -> row.at().configuration().equals(one.key()))
                    .toList();
            lines.add(line(file, one, its));
            its.stream()
                    .filter(row -> row.at().isCounted() && !row.isWhole())
                    .forEach(row -> faults.add(fault(one, row)));
        }
        return new ResultTable(file, lines, faults);
    }

    private static Line line(ExperimentFile file, Configuration one, List<RunRow> rows) {
        Map<Integer, Map<String, RunRow>> repetitions = new LinkedHashMap<>();
        rows.stream()
                .filter(row -> row.at().isCounted())
                .forEach(row -> repetitions
                        .computeIfAbsent(row.at().repetition(), number -> new LinkedHashMap<>())
                        .put(row.at().version(), row));
        List<Map<String, RunRow>> whole = repetitions.values().stream()
                .filter(versions -> versions.values().stream().allMatch(RunRow::isWhole))
                .filter(versions -> versions.values().stream().allMatch(row -> row.notPlaced() == 0))
                .toList();
        int redrawn = (int) rows.stream()
                .filter(row -> !row.at().isCounted())
                .map(row -> List.of(row.at().repetition(), row.at().attempt()))
                .distinct()
                .count();
        return new Line(
                one,
                file.columns().stream()
                        .map(column -> TableCell.of(column, whole))
                        .toList(),
                file.publishedFor(one),
                whole.size(),
                repetitions.size() - whole.size(),
                redrawn);
    }

    private static String fault(Configuration one, RunRow row) {
        String reason = row.reason().isEmpty() ? row.unvisited() + " locations were not visited" : row.reason();
        return one.text() + ", repetition " + row.at().repetition() + ", "
                + row.at().version() + ": " + row.outcome() + ", " + reason;
    }

    /** The titles of the columns. */
    public List<String> header() {
        List<String> header = new ArrayList<>();
        header.add(String.join(", ", file.configuration()));
        for (TableColumn column : file.columns()) {
            header.add(column.title());
            if (isPublished(column)) {
                header.add("thesis");
            }
        }
        header.addAll(List.of("n", "failed", "redrawn"));
        return header;
    }

    private boolean isPublished(TableColumn column) {
        return file.published().stream().anyMatch(row -> row.containsKey(column.published()));
    }

    /** The texts of a line's cells, as many as the header has. */
    public List<String> texts(Line line) {
        List<String> texts = new ArrayList<>();
        texts.add(line.configuration().text());
        for (TableCell cell : line.cells()) {
            texts.add(cell.text());
            if (isPublished(cell.column())) {
                texts.add(line.published().getOrDefault(cell.column().published(), "-"));
            }
        }
        texts.add(String.valueOf(line.counted()));
        texts.add(String.valueOf(line.failed()));
        texts.add(String.valueOf(line.redrawn()));
        return texts;
    }

    /** What stands below it: how to read it, what holds for all versions, the experiment's own notes, and faults. */
    public List<String> notes() {
        List<String> notes = new ArrayList<>();
        notes.add("Mean [± standard error] of n repetitions. (…): the two-sample t-test finds no difference at 0.05; "
                + "(…)*: the paired test does.");
        if (file.design() == ExperimentFile.Design.ONE_FACTOR_AT_A_TIME) {
            notes.add("The first line is the base; every other one differs from it in one variable.");
        }
        notes.add("failed: repetitions in which a version did not end, or missed a location; they are in no mean. "
                + "redrawn: attempts whose incidents could not be placed.");
        notes.add("All versions divide locations by "
                + file.configurations().get(0).variables().get("allocation") + " (--allocation).");
        notes.addAll(file.notes());
        notes.addAll(faults);
        return notes;
    }
}
