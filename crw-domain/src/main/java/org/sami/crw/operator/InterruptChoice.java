package org.sami.crw.operator;

import java.util.Objects;

/**
 * A button for an interrupt of a running mission.
 *
 * @param name what stands on it
 * @param asksForBoats whether pressing it needs boats: named by the press or chosen afterwards
 * @param whyNot why pressing it now would be refused, in words; empty where it would be taken
 */
public record InterruptChoice(long mission, String name, boolean asksForBoats, String whyNot) {
    public InterruptChoice {
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(whyNot, "whyNot");
    }

    /** Whether it can be pressed now. */
    public boolean isEnabled() {
        return whyNot.isEmpty();
    }
}
