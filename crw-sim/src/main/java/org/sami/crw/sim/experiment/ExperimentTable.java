package org.sami.crw.sim.experiment;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.function.ToIntFunction;
import java.util.stream.Stream;
import org.sami.crw.report.ReportWords;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.file.CsvRow;

/** What came of an experiment: for people a line for each case and conditions, for programs one for each run. */
public final class ExperimentTable {
    private static final List<String> HEADER = List.of(
            "case",
            "conditions",
            "runs",
            "ended",
            "median",
            "longest",
            "reported",
            "visited",
            "farthest",
            "planned",
            "explored",
            "inside",
            "announced",
            "closest",
            "under way",
            "near",
            "empty");

    /** Only of experiments in which a detector reported a target. */
    private static final String TARGETS = "targets";

    private static final String NONE = "-";

    private ExperimentTable() {}

    /** The table as text with line feeds; below it a line for each run that is not green. */
    public static String text(List<ExperimentRow> rows) {
        Map<List<String>, List<ExperimentRow>> groups = new LinkedHashMap<>();
        rows.forEach(row -> groups.computeIfAbsent(
                        List.of(row.run().label(), row.run().conditions()), key -> new ArrayList<>())
                .add(row));
        List<List<String>> lines = new ArrayList<>();
        boolean haveTargets = rows.stream().anyMatch(row -> row.targets() > 0);
        lines.add(with(HEADER, TARGETS, haveTargets));
        groups.values()
                .forEach(group ->
                        lines.add(with(line(group), String.valueOf(sum(group, ExperimentRow::targets)), haveTargets)));
        StringBuilder text = new StringBuilder(aligned(lines));
        rows.stream().filter(row -> !row.isGreen()).forEach(row -> text.append(trouble(row)));
        return text.toString();
    }

    private static List<String> with(List<String> cells, String last, boolean isThere) {
        return isThere ? Stream.concat(cells.stream(), Stream.of(last)).toList() : cells;
    }

    private static List<String> line(List<ExperimentRow> group) {
        ExperimentRow first = group.get(0);
        long[] millis = group.stream()
                .filter(row -> row.ending().outcome() == RunOutcome.ENDED)
                .mapToLong(row -> row.ending().simulatedMillis())
                .sorted()
                .toArray();
        int locations = sum(group, row -> row.visits().locations());
        return List.of(
                first.run().label(),
                first.run().conditions(),
                String.valueOf(group.size()),
                String.valueOf(millis.length),
                millis.length == 0 ? NONE : ReportWords.duration(median(millis)),
                millis.length == 0 ? NONE : ReportWords.duration(millis[millis.length - 1]),
                locations == 0 ? NONE : sum(group, row -> row.visits().reported()) + "/" + locations,
                locations == 0 ? NONE : sum(group, row -> row.visits().visited()) + "/" + locations,
                metres(most(group, row -> row.visits().farthestM())),
                percent(group, row -> row.coverage().plannedUncoveredM2()),
                percent(group, row -> OptionalDouble.of(row.coverage().uncoveredM2())),
                metres(most(group, row -> row.distances().insideM())),
                metres(most(group, row -> row.distances().announcedM())),
                metres(least(group, row -> row.distances().closestM())),
                metres(least(group, row -> row.distances().underWayM())),
                near(group),
                String.valueOf(sum(group, ExperimentRow::emptyBoats)));
    }

    private static long median(long[] sorted) {
        return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
    }

    private static int sum(List<ExperimentRow> group, ToIntFunction<ExperimentRow> of) {
        return group.stream().mapToInt(of).sum();
    }

    private static OptionalDouble most(List<ExperimentRow> group, Function<ExperimentRow, OptionalDouble> of) {
        return group.stream().map(of).flatMapToDouble(OptionalDouble::stream).max();
    }

    private static OptionalDouble least(List<ExperimentRow> group, Function<ExperimentRow, OptionalDouble> of) {
        return group.stream().map(of).flatMapToDouble(OptionalDouble::stream).min();
    }

    /** How much of the areas is covered, of the runs that say how much is not. */
    private static String percent(List<ExperimentRow> group, Function<ExperimentRow, OptionalDouble> uncoveredM2) {
        List<ExperimentRow> told = group.stream()
                .filter(row ->
                        row.coverage().areaM2() > 0 && uncoveredM2.apply(row).isPresent())
                .toList();
        double areaM2 =
                told.stream().mapToDouble(row -> row.coverage().areaM2()).sum();
        double leftM2 = told.stream()
                .mapToDouble(row -> uncoveredM2.apply(row).getAsDouble())
                .sum();
        return told.isEmpty() ? NONE : String.format(Locale.ROOT, "%.2f %%", 100 * (1 - leftM2 / areaM2));
    }

    /** Seconds of a run, on the average. */
    private static String near(List<ExperimentRow> group) {
        boolean isKnown =
                group.stream().anyMatch(row -> row.distances().closestM().isPresent());
        double seconds = group.stream()
                        .mapToLong(row -> row.distances().nearMillis())
                        .average()
                        .orElse(0)
                / 1000;
        return isKnown ? String.format(Locale.ROOT, "%.1f s", seconds) : NONE;
    }

    private static String metres(OptionalDouble value) {
        return value.isEmpty() ? NONE : String.format(Locale.ROOT, "%.1f m", value.getAsDouble());
    }

    /** Columns of words to the left, of numbers to the right, two spaces apart. */
    private static String aligned(List<List<String>> lines) {
        StringBuilder text = new StringBuilder();
        for (List<String> line : lines) {
            StringBuilder padded = new StringBuilder();
            for (int column = 0; column < line.size(); column++) {
                int index = column;
                int width = lines.stream()
                        .mapToInt(other -> other.get(index).length())
                        .max()
                        .orElse(0);
                String gap = " ".repeat(width - line.get(column).length());
                boolean words = column < 2;
                padded.append(column == 0 ? "" : "  ").append(words ? line.get(column) + gap : gap + line.get(column));
            }
            text.append(padded.toString().stripTrailing()).append('\n');
        }
        return text.toString();
    }

    private static String trouble(ExperimentRow row) {
        String problems = row.ending().problems() == 0
                ? ""
                : ", " + row.ending().problems() + (row.ending().problems() == 1 ? " problem" : " problems");
        String reason =
                row.ending().reason().isEmpty() ? "" : ": " + row.ending().reason();
        String depth = row.distances().areDeeperThanAnnounced()
                ? "; a boat came deeper into avoided areas than announced: "
                        + metres(row.distances().insideM()) + ", not "
                        + metres(row.distances().announcedM()) + " at most"
                : "";
        return String.format(
                Locale.ROOT,
                "%s, %s, seed %d: %s after %s%s%s%s\n",
                row.run().label(),
                row.run().conditions(),
                row.run().seed(),
                row.ending().outcome().word(),
                ReportWords.duration(row.ending().simulatedMillis()),
                problems,
                reason,
                depth);
    }

    /** A table in the form of RFC 4180 with a row for each run; times are simulated seconds, lengths metres. */
    public static String csv(List<ExperimentRow> rows) {
        StringBuilder text = new StringBuilder(CsvRow.of(
                "case",
                "conditions",
                "seed",
                "outcome",
                "reason",
                "problems",
                "simulated_s",
                "locations",
                "locations_reported",
                "locations_visited",
                "farthest_m",
                "area_m2",
                "planned_uncovered_m2",
                "uncovered_m2",
                "inside_m",
                "announced_m",
                "closest_m",
                "under_way_m",
                "near_s",
                "empty_boats",
                "targets",
                "run_hash"));
        for (ExperimentRow row : rows) {
            text.append(CsvRow.of(
                    row.run().label(),
                    row.run().conditions(),
                    row.run().seed(),
                    row.ending().outcome().word(),
                    row.ending().reason(),
                    row.ending().problems(),
                    CsvRow.fixed(row.ending().simulatedMillis() / 1000.0, 3),
                    row.visits().locations(),
                    row.visits().reported(),
                    row.visits().visited(),
                    cell(row.visits().farthestM()),
                    CsvRow.fixed(row.coverage().areaM2(), 1),
                    cell(row.coverage().plannedUncoveredM2()),
                    CsvRow.fixed(row.coverage().uncoveredM2(), 1),
                    cell(row.distances().insideM()),
                    cell(row.distances().announcedM()),
                    cell(row.distances().closestM()),
                    cell(row.distances().underWayM()),
                    CsvRow.fixed(row.distances().nearMillis() / 1000.0, 3),
                    row.emptyBoats(),
                    row.targets(),
                    row.ending().hash()));
        }
        return text.toString();
    }

    private static String cell(OptionalDouble value) {
        return value.isEmpty() ? "" : CsvRow.fixed(value.getAsDouble(), 2);
    }
}
