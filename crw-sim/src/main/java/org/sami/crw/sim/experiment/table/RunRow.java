package org.sami.crw.sim.experiment.table;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.sami.crw.operator.ClickKind;
import org.sami.crw.report.RunOutcome;
import org.sami.crw.report.file.CsvRow;
import org.sami.crw.sim.run.incident.IncidentKind.PlannedIncident;
import org.sami.crw.sim.run.incident.IncidentRunResult;

/**
 * A run of an experiment, as a row of its file {@code runs.csv}.
 *
 * @param at where it belongs
 * @param outcome word of its {@link RunOutcome}
 * @param clicksByKind start, abort, press, answer, in the order of {@link ClickKind}
 * @param incidents as they were placed, such as {@code 31.2 boat1; 80.0}
 */
public record RunRow(
        Place at,
        String outcome,
        String reason,
        double seconds,
        List<Long> clicksByKind,
        int recharges,
        OptionalDouble resolution,
        int measurements,
        int unvisited,
        int notPlaced,
        String incidents,
        String hash) {
    /** The names of the columns. */
    public static final List<String> COLUMNS = List.of(
            "configuration",
            "repetition",
            "attempt",
            "counted",
            "version",
            "seed",
            "outcome",
            "reason",
            "time_s",
            "clicks",
            "clicks_start",
            "clicks_abort",
            "clicks_press",
            "clicks_answer",
            "recharges",
            "resolution_s",
            "measurements",
            "unvisited",
            "not_placed",
            "incidents",
            "run_hash");

    /**
     * Where a row belongs.
     *
     * @param configuration key of it
     * @param repetition from 1
     * @param attempt from 1; the repetition is drawn again where incidents were not placed
     * @param isCounted whether it is the repetition's last attempt
     */
    public record Place(
            String configuration, int repetition, int attempt, boolean isCounted, String version, long seed) {
        public Place {
            Objects.requireNonNull(configuration, "configuration");
            Objects.requireNonNull(version, "version");
        }

        Place counted(boolean counts) {
            return new Place(configuration, repetition, attempt, counts, version, seed);
        }
    }

    public RunRow {
        Objects.requireNonNull(at, "at");
        Objects.requireNonNull(outcome, "outcome");
        Objects.requireNonNull(reason, "reason");
        clicksByKind = List.copyOf(clicksByKind);
        Objects.requireNonNull(resolution, "resolution");
        Objects.requireNonNull(incidents, "incidents");
        Objects.requireNonNull(hash, "hash");
    }

    static RunRow of(Place at, IncidentRunResult result) {
        List<Long> clicks = new ArrayList<>();
        for (ClickKind kind : ClickKind.values()) {
            clicks.add(result.clicks().getOrDefault(kind, 0L));
        }
        return new RunRow(
                at,
                result.outcome().word(),
                result.reason(),
                result.millis() / 1000.0,
                clicks,
                result.recharges(),
                result.resolution(),
                result.measurements(),
                result.unvisited(),
                result.notPlaced(),
                result.incidents().stream().map(RunRow::text).collect(Collectors.joining("; ")),
                result.hash());
    }

    /** A run that the program itself broke. */
    static RunRow broken(Place at, RuntimeException fault) {
        return failed(at, "the program broke: " + fault);
    }

    /** A run of which nothing is known but why it failed. */
    static RunRow failed(Place at, String reason) {
        return new RunRow(
                at,
                RunOutcome.FAILED.word(),
                reason,
                0,
                List.of(0L, 0L, 0L, 0L),
                0,
                OptionalDouble.empty(),
                0,
                0,
                0,
                "",
                "");
    }

    private static String text(PlannedIncident incident) {
        String at = String.format(Locale.ROOT, "%.1f", incident.afterMillis() / 1000.0);
        return incident.boats().isEmpty() ? at : at + " " + String.join(" ", incident.boats());
    }

    long clicks() {
        return clicksByKind.stream().mapToLong(Long::longValue).sum();
    }

    /** Whether it ended and no location is missing. */
    boolean isWhole() {
        return outcome.equals(RunOutcome.ENDED.word()) && unvisited == 0;
    }

    RunRow counted(boolean counts) {
        return new RunRow(
                at.counted(counts),
                outcome,
                reason,
                seconds,
                clicksByKind,
                recharges,
                resolution,
                measurements,
                unvisited,
                notPlaced,
                incidents,
                hash);
    }

    /** The row's text, with a line feed. */
    String csv() {
        return text(
                reason.replace('\n', ' '),
                CsvRow.fixed(seconds, 3),
                resolution.isEmpty() ? "" : CsvRow.fixed(resolution.getAsDouble(), 3));
    }

    /** The same with every digit of its numbers, for {@link #read}: tables are made of these. */
    String exact() {
        return text(
                reason,
                Double.toString(seconds),
                resolution.isEmpty() ? "" : Double.toString(resolution.getAsDouble()));
    }

    private String text(String reasonCell, String secondsCell, String resolutionCell) {
        return CsvRow.of(
                at.configuration(),
                at.repetition(),
                at.attempt(),
                at.isCounted() ? "yes" : "no",
                at.version(),
                at.seed(),
                outcome,
                reasonCell,
                secondsCell,
                clicks(),
                clicksByKind.get(0),
                clicksByKind.get(1),
                clicksByKind.get(2),
                clicksByKind.get(3),
                recharges,
                resolutionCell,
                measurements,
                unvisited,
                notPlaced,
                incidents,
                hash);
    }

    /** Reads what {@link #csv} writes; empty where a line is no whole row, as after a crash. */
    static Optional<RunRow> read(List<String> cells) {
        if (cells.size() != COLUMNS.size()) {
            return Optional.empty();
        }
        try {
            return Optional.of(new RunRow(
                    new Place(
                            cells.get(0),
                            Integer.parseInt(cells.get(1)),
                            Integer.parseInt(cells.get(2)),
                            cells.get(3).equals("yes"),
                            cells.get(4),
                            Long.parseLong(cells.get(5))),
                    cells.get(6),
                    cells.get(7),
                    Double.parseDouble(cells.get(8)),
                    cells.subList(10, 14).stream().map(Long::valueOf).toList(),
                    Integer.parseInt(cells.get(14)),
                    cells.get(15).isEmpty()
                            ? OptionalDouble.empty()
                            : OptionalDouble.of(Double.parseDouble(cells.get(15))),
                    Integer.parseInt(cells.get(16)),
                    Integer.parseInt(cells.get(17)),
                    Integer.parseInt(cells.get(18)),
                    cells.get(19),
                    cells.get(20)));
        } catch (NumberFormatException noRow) {
            return Optional.empty();
        }
    }
}
