package org.sami.crw.gui.boat;

import org.sami.crw.operator.alarm.LaunchCheck;
import org.sami.crw.operator.alarm.LaunchCheck.State;
import org.sami.palette.SemanticColor;

/** Text and colour of the checks of boats: a mark, then the words. */
public final class LaunchWords {
    private LaunchWords() {}

    /** A check in one line, such as {@code ✓ ready} or {@code ▲ battery 3 %: put a full one in}. */
    public static String line(LaunchCheck check) {
        return mark(check.overall()) + check.words();
    }

    /** The mark of a state, with a space behind it. */
    static String mark(State state) {
        return switch (state) {
            case GOOD -> "✓ ";
            case DOUBTFUL -> "△ ";
            case BAD -> "▲ ";
            case UNKNOWN -> "? ";
        };
    }

    /** The colour of a state. */
    public static SemanticColor color(State state) {
        return switch (state) {
            case GOOD -> SemanticColor.TEXT;
            case DOUBTFUL, UNKNOWN -> SemanticColor.WARNING;
            case BAD -> SemanticColor.CRITICAL;
        };
    }
}
