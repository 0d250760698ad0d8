package org.sami.crw.sim.experiment.table;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.sami.crw.report.file.CsvRow;

/** The file {@code runs.csv} of an experiment: a row for each run, added while they are made, in order once all are made. */
public final class RunRowsFile {
    private final Path file;

    /** A file that is there, or will be. */
    public RunRowsFile(Path file) {
        this.file = file;
    }

    private record Run(String configuration, int repetition, int attempt, String version) {
        static Run of(RunRow row) {
            RunRow.Place at = row.at();
            return new Run(at.configuration(), at.repetition(), at.attempt(), at.version());
        }
    }

    /** By configuration, as they come first, and repetition. */
    private static List<RunRow> together(List<RunRow> rows, List<RunRow> earlier) {
        Set<Run> made = rows.stream().map(Run::of).collect(Collectors.toSet());
        List<RunRow> all = new ArrayList<>(rows);
        earlier.stream().filter(row -> !made.contains(Run.of(row))).forEach(all::add);
        List<String> configurations =
                all.stream().map(row -> row.at().configuration()).distinct().toList();
        all.sort(Comparator.<RunRow>comparingInt(
                        row -> configurations.indexOf(row.at().configuration()))
                .thenComparingInt(row -> row.at().repetition()));
        return all;
    }

    private static String header() {
        return CsvRow.of(RunRow.COLUMNS.toArray());
    }

    /** The rows that it has; lines that are no rows are left out. */
    public List<RunRow> read() throws IOException {
        List<RunRow> rows = new ArrayList<>();
        if (Files.exists(file)) {
            for (String line : Files.readAllLines(file)) {
                RunRow.read(CsvRow.cells(line)).ifPresent(rows::add);
            }
        }
        return rows;
    }

    /** Adds rows at its end. */
    public void add(List<RunRow> rows) throws IOException {
        StringBuilder text = new StringBuilder(Files.exists(file) ? "" : header());
        rows.forEach(row -> text.append(row.csv()));
        Files.writeString(file, text, StandardCharsets.UTF_8, StandardOpenOption.CREATE, StandardOpenOption.APPEND);
    }

    /**
     * Puts the rows of a call in order. Those of earlier calls that this one did not ask for stay, such as further repetitions: a later call goes on from
     * them.
     *
     * @param earlier what the file had before the call
     */
    public void replace(List<RunRow> rows, List<RunRow> earlier) throws IOException {
        StringBuilder text = new StringBuilder(header());
        together(rows, earlier).forEach(row -> text.append(row.csv()));
        Path next = file.resolveSibling(file.getFileName() + ".part");
        Files.writeString(next, text);
        Files.move(next, file, StandardCopyOption.REPLACE_EXISTING, StandardCopyOption.ATOMIC_MOVE);
    }
}
