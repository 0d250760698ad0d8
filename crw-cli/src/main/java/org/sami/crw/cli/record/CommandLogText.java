package org.sami.crw.cli.record;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.sami.boat.link.Nack;
import org.sami.boat.server.log.LogEntries;
import org.sami.boat.server.log.LogFiles;
import org.sami.boat.server.log.LogHistory;
import org.sami.boat.server.log.LoggedCommand;

/** What a boat's log of commands holds, all of its files read as one; for people, and as a table. */
final class CommandLogText implements LogEntries {
    private static final String HEADER = "start,boat time ms,client,command,id,answer,reason";

    private final Map<String, Integer> executed = new TreeMap<>();
    private final Map<String, Integer> refused = new TreeMap<>();
    private final Map<String, Integer> clients = new TreeMap<>();
    private final List<String> rows = new ArrayList<>();
    private final SortedMap<Integer, Path> files;
    private final int unread;
    private int starts;

    /**
     * Reads the log to which a file belongs.
     *
     * @throws IOException if a file of it cannot be read, or is no such log
     */
    CommandLogText(Path file) throws IOException {
        LogFiles log = LogFiles.of(file);
        files = log.byNumber();
        unread = LogHistory.read(log, this);
    }

    @Override
    public void started(String bootId) {
        starts++;
    }

    @Override
    public void answered(LoggedCommand entry) {
        String type = entry.command().type();
        String reason = entry.answer() instanceof Nack nack ? nack.reason().name() : "";
        clients.merge(entry.clientId(), 1, Integer::sum);
        if (reason.isEmpty()) {
            executed.merge(type, 1, Integer::sum);
        } else {
            refused.merge(type + " " + reason, 1, Integer::sum);
        }
        rows.add(String.join(
                ",",
                entry.bootId(),
                Long.toString(entry.timeMs()),
                quoted(entry.clientId()),
                type,
                quoted(entry.command().commandId()),
                entry.answer().type(),
                reason));
    }

    private static String quoted(String text) {
        return "\"" + text.replace("\"", "\"\"") + "\"";
    }

    /** Writes {@code commands.csv} into a folder that is there. */
    void write(Path folder) throws IOException {
        Files.writeString(
                folder.resolve("commands.csv"),
                HEADER + "\n" + rows.stream().map(row -> row + "\n").collect(Collectors.joining()),
                StandardCharsets.UTF_8);
    }

    /** Prints what there is. */
    void print(PrintWriter out) {
        out.printf("a boat's log of commands%n");
        out.printf(
                "  files      %s%s%n",
                files.values().stream()
                        .map(Path::getFileName)
                        .map(Path::toString)
                        .collect(Collectors.joining(", ")),
                files.isEmpty() || files.firstKey() == 0 ? "" : "; earlier ones are gone");
        out.printf("  starts     %d of the boat's server%n", starts);
        out.printf("  commands   %d: %s%n", rows.size(), words(executed));
        if (!refused.isEmpty()) {
            out.printf("  refused    %s%n", words(refused));
        }
        out.printf("  clients    %s%n", words(clients));
        if (unread > 0) {
            out.printf("  damaged    %d lines, not read%n", unread);
        }
        out.flush();
    }

    private static String words(Map<String, Integer> counts) {
        return counts.isEmpty()
                ? "none"
                : counts.entrySet().stream()
                        .map(count -> count.getValue() + " " + count.getKey())
                        .collect(Collectors.joining(", "));
    }
}
