package org.sami.crw.log;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;
import org.sami.crw.report.file.CsvRow;
import org.sami.spn.value.GeoPoint;

/** The tables of a log, written while it is read; they take their names when {@link #keep} says that all went well. */
final class LogTables implements Closeable {
    private static final String TRACKS = "tracks.csv";
    private static final String READINGS = "readings.csv";
    private static final String COMMANDS = "commands.csv";
    private static final String PROBLEMS = "problems.csv";

    private final Path folder;
    private final Map<String, BufferedWriter> open = new LinkedHashMap<>();
    private @Nullable GeoPoint latest;

    LogTables(Path folder) throws IOException {
        this.folder = folder;
        Files.createDirectories(folder);
        begin(TRACKS, "line", "at_s", "clock", "source", "stretch", "lat_deg", "lon_deg", "yaw_rad");
        begin(READINGS, "line", "at_s", "sensor", "channel", "value", "lat_deg", "lon_deg");
        begin(COMMANDS, "line", "at_s", "clock", "topic", "command");
        begin(PROBLEMS, "line", "problem", "message", "text");
    }

    private void begin(String table, Object... columns) throws IOException {
        open.put(table, Files.newBufferedWriter(unfinished(table), StandardCharsets.UTF_8));
        row(table, columns);
    }

    private void row(String table, Object... cells) throws IOException {
        Objects.requireNonNull(open.get(table), table).write(CsvRow.of(cells));
    }

    /**
     * Writes down an entry.
     *
     * @param atMillis since the log's first entry
     * @param stretch in which a position is
     */
    void entry(LoggedLine line, long atMillis, OptionalInt stretch) throws IOException {
        String at = CsvRow.fixed(atMillis / 1000.0, 3);
        LogEntry entry = line.entry();
        if (entry instanceof LogEntry.Pose pose) {
            latest = pose.at();
            position(line, at, "pose", stretch, pose.at(), CsvRow.fixed(pose.yawRad(), 4));
        } else if (entry instanceof LogEntry.Fix fix) {
            position(line, at, "gps", stretch, fix.at(), "");
        } else if (entry instanceof LogEntry.Reading reading) {
            for (Map.Entry<String, Double> value : reading.values().entrySet()) {
                row(
                        READINGS,
                        line.number(),
                        at,
                        reading.sensor(),
                        value.getKey(),
                        value.getValue(),
                        latest == null ? "" : CsvRow.fixed(latest.latDeg(), 7),
                        latest == null ? "" : CsvRow.fixed(latest.lonDeg(), 7));
            }
        } else if (entry instanceof LogEntry.Command command) {
            row(COMMANDS, line.number(), at, line.clock(), line.topic(), command.text());
        }
    }

    private void position(LoggedLine line, String at, String source, OptionalInt stretch, GeoPoint point, String yaw)
            throws IOException {
        row(
                TRACKS,
                line.number(),
                at,
                line.clock(),
                source,
                stretch.orElseThrow(),
                CsvRow.fixed(point.latDeg(), 7),
                CsvRow.fixed(point.lonDeg(), 7),
                yaw);
    }

    /** Writes down what is wrong with a line, and the line. */
    void problem(LineProblem problem) throws IOException {
        row(PROBLEMS, problem.line(), problem.fault().word(), problem.message(), problem.text());
    }

    /** Ends the tables and gives them their names; those of an earlier time are replaced. */
    void keep() throws IOException {
        for (BufferedWriter table : open.values()) {
            table.close();
        }
        for (String table : open.keySet()) {
            Files.move(unfinished(table), folder.resolve(table), StandardCopyOption.REPLACE_EXISTING);
        }
        open.clear();
    }

    private Path unfinished(String table) {
        return folder.resolve(table + ".new");
    }

    /** Removes tables that were not kept. */
    @Override
    public void close() throws IOException {
        for (Map.Entry<String, BufferedWriter> table : open.entrySet()) {
            table.getValue().close();
            Files.deleteIfExists(unfinished(table.getKey()));
        }
        open.clear();
    }
}
