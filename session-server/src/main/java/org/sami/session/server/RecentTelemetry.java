package org.sami.session.server;

import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.sami.session.record.OperatorLogRows;
import org.sami.session.record.PictureRows;
import org.sami.spn.journal.TelemetryRow;

/**
 * The latest rows of telemetry, as many of each kind as a front needs that begins to follow a session: states and commands of boats, the log of operators, readings of
 * sensors. Not safe for threads.
 */
final class RecentTelemetry {
    private static final int COMMANDS = 60; // of a boat: those in its queue, and what became of the last
    private static final int ENDS = 20; // of a boat
    private static final int READINGS = 200; // rows of a boat
    private static final int LOG = 2000;
    private static final int PANORAMAS = 100; // of a boat
    private static final int PICTURES = 1000; // of a boat

    private final Map<Group, Deque<Numbered>> groups = new HashMap<>();

    private record Group(String boat, String kind) {}

    /** A row with its number in the feed. */
    private record Numbered(long number, TelemetryRow row) {}

    /** Takes a row up; numbers increase, or are 0 for rows from before the feed. */
    void take(long number, TelemetryRow row) {
        switch (row.kind()) {
            case "pose", "state", "queue", "progress" -> keep(row.kind(), 1, number, row);
            case "linked", "lost" -> keep("link", 1, number, row);
            case "upload" -> keep(row.json().contains("\"way\"") ? "upload-way" : "upload", 1, number, row);
            case "command" -> keep(row.kind(), COMMANDS, number, row);
            case "concluded" -> keep(row.kind(), ENDS, number, row);
            case "reading", "readings" -> keep("readings", READINGS, number, row);
            case PictureRows.TAKEN -> keep(row.kind(), PANORAMAS, number, row);
            case PictureRows.PICTURE -> keep(row.kind(), PICTURES, number, row);
            case OperatorLogRows.KIND -> keep(row.kind(), LOG, number, row);
            case "removed" ->
                groups.keySet().removeIf(group -> group.boat().equals(row.proxy()) && !isOfPictures(group.kind()));
            case "begun" -> groups.keySet().removeIf(group -> isOfLink(group.kind()));
            default -> {
                // nobody needs it later
            }
        }
    }

    private static boolean isOfLink(String kind) {
        return !kind.equals(OperatorLogRows.KIND) && !kind.equals("readings") && !isOfPictures(kind);
    }

    private static boolean isOfPictures(String kind) {
        return kind.equals(PictureRows.TAKEN) || kind.equals(PictureRows.PICTURE);
    }

    private void keep(String kind, int most, long number, TelemetryRow row) {
        Deque<Numbered> group = groups.computeIfAbsent(new Group(row.proxy(), kind), name -> new ArrayDeque<>());
        group.add(new Numbered(number, row));
        if (group.size() > most) {
            group.poll();
        }
    }

    /** The rows up to a number, in order. */
    List<TelemetryRow> upTo(long number) {
        return groups.values().stream()
                .flatMap(Deque::stream)
                .filter(one -> one.number() <= number)
                .sorted(Comparator.comparingLong(Numbered::number)
                        .thenComparing(one -> !one.row().kind().equals("command"))
                        .thenComparingLong(one -> one.row().atMillis()))
                .map(Numbered::row)
                .collect(Collectors.toList());
    }
}
