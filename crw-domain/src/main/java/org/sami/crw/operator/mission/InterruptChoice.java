package org.sami.crw.operator.mission;

import java.util.Objects;
import org.sami.spn.protocol.Priority;

/**
 * A button for an interrupt of a running mission.
 *
 * @param plan what people call the mission's plan
 * @param name what stands on it
 * @param asksForBoats whether pressing it needs boats: named by the press or chosen afterwards
 * @param priority how urgent it is (markup Priority); medium without one
 * @param description what the author says of it (markup Description); empty text for nothing
 * @param whyNot why pressing it now would be refused, in words; empty where it would be taken
 */
public record InterruptChoice(
        long mission,
        String plan,
        String name,
        boolean asksForBoats,
        Priority priority,
        String description,
        String whyNot) {
    public InterruptChoice {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(priority, "priority");
        Objects.requireNonNull(description, "description");
        Objects.requireNonNull(whyNot, "whyNot");
    }

    /** Whether it can be pressed now. */
    public boolean isEnabled() {
        return whyNot.isEmpty();
    }
}
