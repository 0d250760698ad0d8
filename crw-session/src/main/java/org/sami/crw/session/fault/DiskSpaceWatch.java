package org.sami.crw.session.fault;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Locale;
import java.util.Optional;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.spn.protocol.Priority;

/**
 * Says for how long the room on the journal's disk lasts, by what the session has written in the last ten minutes and by how fast the room becomes less.
 * For one thread.
 */
final class DiskSpaceWatch {
    private static final long WINDOW_MS = 600_000;
    private static final long SHORTEST_MS = 30_000;
    private static final double LITTLE_MIN = HealthDefaults.ROOM_LOW_MIN;
    private static final double NONE_MIN = HealthDefaults.ROOM_GONE_MIN;
    private static final long LITTLE_BYTES = HealthDefaults.ROOM_LOW_BYTES;
    private static final long NONE_BYTES = HealthDefaults.ROOM_GONE_BYTES;
    /** A warning that came stays until there is clearly more room. */
    private static final double MARGIN = 1.25;

    private final Deque<Seen> seen = new ArrayDeque<>();
    private boolean warned;

    private record Seen(long atMillis, long journalBytes, long freeBytes) {}

    /**
     * Looks at the disk.
     *
     * @param journalBytes how large the journal is
     * @param freeBytes what the process may still write to its disk
     * @return what is to be said; empty while there is room
     */
    Optional<HealthFault> look(long atMillis, long journalBytes, long freeBytes) {
        seen.add(new Seen(atMillis, journalBytes, freeBytes));
        while (seen.size() > 2 && atMillis - seen.getFirst().atMillis() > WINDOW_MS) {
            seen.removeFirst();
        }
        double minutes = minutes();
        double margin = warned ? MARGIN : 1;
        boolean little = minutes < LITTLE_MIN * margin || freeBytes < LITTLE_BYTES * margin;
        warned = little;
        if (!little) {
            return Optional.empty();
        }
        boolean almostNone = minutes < NONE_MIN || freeBytes < NONE_BYTES;
        return Optional.of(HealthFault.ofSession(
                HealthKind.DISK,
                almostNone ? Priority.HIGH : Priority.MEDIUM,
                words(freeBytes, minutes),
                "Delete files there or move them away: when the disk is full, missions stand still"));
    }

    private double minutes() {
        Seen first = seen.getFirst();
        Seen last = seen.getLast();
        long millis = last.atMillis() - first.atMillis();
        if (millis < SHORTEST_MS) {
            return Double.POSITIVE_INFINITY;
        }
        double written = Math.max(last.journalBytes() - first.journalBytes(), first.freeBytes() - last.freeBytes());
        return written <= 0 ? Double.POSITIVE_INFINITY : last.freeBytes() / (written / millis) / 60_000;
    }

    private static String words(long freeBytes, double minutes) {
        String free = "The journal's disk has " + size(freeBytes) + " left";
        return minutes > 24 * 60 ? free : free + ": room for " + time(minutes);
    }

    private static String size(long bytes) {
        double mb = bytes / (double) (1 << 20);
        return String.format(Locale.ROOT, mb < 10 ? "%.1f MB" : "%.0f MB", mb);
    }

    /** Rounded, as it is an estimate: what it says changes seldom. */
    private static String time(double minutes) {
        if (minutes < 2) {
            return "a minute or less";
        }
        if (minutes < 20) {
            return "about " + Math.round(minutes) + " minutes";
        }
        if (minutes < 120) {
            return "about " + Math.round(minutes / 10) * 10 + " minutes";
        }
        return "about " + Math.round(minutes / 60) + " hours";
    }
}
