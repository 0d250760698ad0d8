package org.sami.crw.operator;

import java.util.Locale;

/** What the operator clicked for (docs/clicks.md). */
public enum ClickKind {
    /** Starting a mission. */
    START,
    /** Ending one: aborted or completed. */
    ABORT,
    /** An interrupt, with the boats that were named. */
    PRESS,
    /** Answers to decisions, and holding them. */
    ANSWER;

    /** The word in tables, such as {@code start}. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
