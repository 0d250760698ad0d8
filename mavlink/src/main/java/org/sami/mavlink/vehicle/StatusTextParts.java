package org.sami.mavlink.vehicle;

import io.dronefleet.mavlink.common.Statustext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.TreeMap;

/** Joins the texts of one vehicle that come in parts of 50 characters. A text that lost a part is given without it once another text comes. */
final class StatusTextParts {
    private static final int PART = 50;

    private final TreeMap<Integer, String> parts = new TreeMap<>();
    private int id;
    private TextSeverity severity = TextSeverity.INFO;

    /** Takes a message; gives the texts that are whole now, oldest first. */
    List<StatusText> take(Statustext message, long nowMs) {
        List<StatusText> whole = new ArrayList<>();
        if (message.id() == 0) {
            pending(nowMs).ifPresent(whole::add);
            whole.add(new StatusText(severity(message), message.text(), nowMs));
            return whole;
        }
        if (message.id() != id) {
            pending(nowMs).ifPresent(whole::add);
            id = message.id();
        }
        severity = severity(message);
        parts.put(message.chunkSeq(), message.text());
        if (message.text().length() < PART) {
            pending(nowMs).ifPresent(whole::add);
        }
        return whole;
    }

    private Optional<StatusText> pending(long nowMs) {
        if (parts.isEmpty()) {
            return Optional.empty();
        }
        StringBuilder text = new StringBuilder();
        int expected = 0;
        for (var part : parts.entrySet()) {
            if (part.getKey() != expected) {
                text.append(" … ");
            }
            text.append(part.getValue());
            expected = part.getKey() + 1;
        }
        parts.clear();
        id = 0;
        return Optional.of(new StatusText(severity, text.toString(), nowMs));
    }

    private static TextSeverity severity(Statustext message) {
        int degree = message.severity().value();
        TextSeverity[] all = TextSeverity.values();
        return all[Math.max(0, Math.min(all.length - 1, degree))];
    }
}
