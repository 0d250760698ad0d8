package org.sami.crw.log;

import java.util.Objects;

/**
 * A line that was understood.
 *
 * @param number of the line in its file, from 1
 * @param atMillis the boat's own count of milliseconds; it begins anywhere
 * @param clock the phone's time of day as it was written, such as {@code 18:36:22,325}
 */
record LoggedLine(long number, long atMillis, String clock, String topic, LogEntry entry) {
    LoggedLine {
        Objects.requireNonNull(clock, "clock");
        Objects.requireNonNull(topic, "topic");
        Objects.requireNonNull(entry, "entry");
    }
}
