package org.sami.crw.log;

import java.util.Locale;

/** What can be wrong with a line of a log. */
public enum LineFault {
    /** No milliseconds, time of day and topic at its beginning. */
    NO_ENTRY("is no entry of a log"),
    UNKNOWN_TOPIC("has an unknown topic"),
    /** The topic is known, what follows it is not in its form. */
    BAD_CONTENT("has a content that does not fit its topic"),
    /** The file's last line, which does not end: the log was cut off while it was written. */
    CUT_OFF("is cut off"),
    TOO_LONG("is too long"),
    /** The boat's clock is before that of an earlier line. The line is used nevertheless. */
    TIME_WENT_BACK("goes back in time");

    private final String words;

    LineFault(String words) {
        this.words = words;
    }

    /** What follows "line 7". */
    String words() {
        return words;
    }

    /** The word in tables and JSON, such as {@code unknown-topic}. */
    String word() {
        return name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    /** Whether the line's content is lost to tracks and tables. */
    boolean unread() {
        return this != TIME_WENT_BACK;
    }
}
