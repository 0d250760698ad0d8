package org.sami.boat.server.log;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.SortedMap;

/** The files of one log, read as one. */
public final class LogHistory {
    private LogHistory() {}

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
