package org.sami.ui.value;

import java.util.List;
import org.sami.spn.value.Value;

/**
 * What may be chosen from, and how many of it.
 *
 * @param rows in the order in which they are offered
 * @param min least number to choose
 * @param max greatest number; {@link Integer#MAX_VALUE} for any
 */
public record Offer(List<ChoiceRow> rows, int min, int max) {
    public Offer {
        rows = List.copyOf(rows);
        if (min < 0 || max < min) {
            throw new IllegalArgumentException("Not a range of choices: " + min + " to " + max);
        }
    }

    /** Exactly one of some rows. */
    public static Offer one(List<ChoiceRow> rows) {
        return new Offer(rows, 1, 1);
    }

    /** Any number of some rows. */
    public static Offer any(List<ChoiceRow> rows) {
        return new Offer(rows, 0, Integer.MAX_VALUE);
    }

    /** The values that are offered. */
    public List<Value> values() {
        return rows.stream().map(ChoiceRow::value).toList();
    }

    /** Whether at most one is chosen. */
    public boolean single() {
        return max == 1;
    }

    /** Why a number of chosen ones is not enough or too much; empty text where it is right. */
    String wrong(int chosen) {
        if (chosen >= min && chosen <= max) {
            return "";
        }
        if (rows.size() < min) {
            return min + " must be chosen, and only " + rows.size() + (rows.size() == 1 ? " is" : " are") + " offered";
        }
        if (single()) {
            return "Choose one of " + rows.size();
        }
        return "Choose " + range() + (chosen == 0 ? "" : "; " + chosen + (chosen == 1 ? " is" : " are") + " chosen");
    }

    private String range() {
        if (max == Integer.MAX_VALUE) {
            return "at least " + min;
        }
        if (min == max) {
            return String.valueOf(min);
        }
        return min == 0 ? "at most " + max : min + " to " + max;
    }
}
