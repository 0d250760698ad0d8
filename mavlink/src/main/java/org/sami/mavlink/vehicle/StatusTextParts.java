package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.common.Statustext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;

/**
 * Joins the texts of one vehicle that come in parts of 50 characters. A text that lost a part is given without it, with a mark in its place: once another text
 * comes, or nothing more of it for {@value #WAIT_MS} ms. Used by one thread.
 */
final class StatusTextParts {
    /** What is left of a text has come by then, also on a slow link. */
    static final long WAIT_MS = 2_000;

    private static final int PART = 50;
    private static final String MISSING = " …";

    private final TreeMap<Integer, String> parts = new TreeMap<>();
    private int id;
    private TextSeverity severity = TextSeverity.INFO;
    private long partMs; // when the last part came

    /** Takes a message; gives the texts that are whole now, oldest first. */
    List<StatusText> take(Statustext message, long nowMs) {
        List<StatusText> whole = new ArrayList<>();
        if (message.id() == 0) {
            incomplete().ifPresent(whole::add);
            whole.add(new StatusText(severity(message), message.text(), nowMs));
            return whole;
        }
        if (message.id() != id) {
            incomplete().ifPresent(whole::add);
            id = message.id();
        }
        severity = severity(message);
        parts.put(message.chunkSeq(), message.text());
        partMs = nowMs;
        if (message.text().length() < PART) {
            whole.add(joined(""));
        }
        return whole;
    }

    /** Gives a text whose other parts have not come in time. */
    Optional<StatusText> overdue(long nowMs) {
        return nowMs - partMs >= WAIT_MS ? incomplete() : Optional.empty();
    }

    /** What has come of a text whose end has not. */
    static String withoutMark(String text) {
        return text.endsWith(MISSING) ? text.substring(0, text.length() - MISSING.length()) : text;
    }

    private Optional<StatusText> incomplete() {
        return parts.isEmpty() ? Optional.empty() : Optional.of(joined(MISSING));
    }

    private StatusText joined(String end) {
        StringBuilder text = new StringBuilder();
        int expected = 0;
        for (var part : parts.entrySet()) {
            if (part.getKey() != expected) {
                text.append(MISSING).append(' ');
            }
            text.append(part.getValue());
            expected = part.getKey() + 1;
        }
        parts.clear();
        id = 0;
        return new StatusText(severity, text.append(end).toString(), partMs);
    }

    private static TextSeverity severity(Statustext message) {
        int degree = message.severity().value();
        TextSeverity[] all = TextSeverity.values();
        return all[Math.max(0, Math.min(all.length - 1, degree))];
    }
}
