package org.sami.crw.log;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Optional;

/**
 * Makes a report of a boat's log: {@code summary.json}, {@code tracks.csv}, {@code track.geojson}, {@code readings.csv},
 * {@code commands.csv}, {@code problems.csv} and, where a position was logged, {@code map.png}.
 */
public final class LogConversion {
    private LogConversion() {}

    /**
     * Sums a log up; writes nothing.
     *
     * @throws NotALogException if the file is none
     */
    public static LogSummary summary(Path log) throws IOException {
        return new LogReader(Optional.empty()).read(log);
    }

    /**
     * Sums a log up and writes its report into a folder, which is made. Files of the report's names are replaced, each as a
     * whole, when all of the log was read.
     *
     * @throws NotALogException if the file is none; then nothing is written
     */
    public static LogSummary report(Path log, Path folder) throws IOException {
        LogSummary summary;
        try (LogTables tables = new LogTables(folder)) {
            summary = new LogReader(Optional.of(tables)).read(log);
            tables.keep();
        }
        write(folder, "summary.json", LogSummaryJson.text(summary).getBytes(StandardCharsets.UTF_8));
        write(folder, "track.geojson", TrackGeoJson.text(summary).getBytes(StandardCharsets.UTF_8));
        Optional<byte[]> picture = LogPicture.png(summary);
        if (picture.isPresent()) {
            write(folder, "map.png", picture.get());
        } else {
            Files.deleteIfExists(folder.resolve("map.png")); // that of another log
        }
        return summary;
    }

    private static void write(Path folder, String name, byte[] content) throws IOException {
        Path whole = folder.resolve(name + ".new");
        Files.write(whole, content);
        Files.move(whole, folder.resolve(name), StandardCopyOption.REPLACE_EXISTING);
    }
}
