package org.sami.boat.server.log;

import java.io.BufferedInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.SortedMap;

/** The files of one log, read as one. */
public final class LogHistory {
    private static final int MOST_BYTES = 8 << 20;

    private LogHistory() {}

    /** Whether a file is one of a boat's log: its first line has the right checksum. */
    public static boolean isOne(Path file) throws IOException {
        try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
            ByteArrayOutputStream line = new ByteArrayOutputStream();
            for (int next = in.read(); next >= 0 && next != '\n' && line.size() < MOST_BYTES; next = in.read()) {
                line.write(next);
            }
            return LogLines.isUndamaged(new String(line.toByteArray(), StandardCharsets.UTF_8));
        }
    }

    /**
     * Reads the files that are there, in their order. What a file carries of those before it is handed on only where these are missing.
     *
     * @return how many lines say nothing, because they are damaged
     * @throws IOException if a file cannot be read, or is something else than a boat's log
     */
    public static int read(LogFiles files, LogEntries entries) throws IOException {
        SortedMap<Integer, Path> all = files.byNumber();
        int unread = 0;
        for (Map.Entry<Integer, Path> file : all.entrySet()) {
            boolean follows = all.containsKey(file.getKey() - 1);
            LogExtent extent =
                    follows ? LogLines.readOn(file.getValue(), entries) : LogLines.read(file.getValue(), entries);
            unread += extent.unreadLines();
        }
        return unread;
    }
}
