package org.sami.crw.operator.mission;

import java.util.Objects;
import java.util.OptionalLong;
import org.sami.spn.protocol.Priority;

/**
 * A button for an interrupt of a running mission.
 *
 * @param plan what people call the mission's plan
 * @param name what stands on it
 * @param asksForBoats whether pressing it needs boats: named by the press or chosen afterwards
 * @param priority how urgent it is (markup Priority); medium without one
 * @param description what the author says of it (markup Description); empty text for nothing
 * @param noWayBack why what it does cannot be undone in the mission ({@link InterruptReturn}); empty text where the plan leads back
 * @param asking the decision that asks whom it is for, as it was pressed without boats; empty = none is open
 * @param whyNot why pressing it now would be refused, in words; empty where it would be taken
 */
public record InterruptChoice(
        long mission,
        String plan,
        String name,
        boolean asksForBoats,
        Priority priority,
        String description,
        String noWayBack,
        OptionalLong asking,
        String whyNot) {
    public InterruptChoice {
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(priority, "priority");
        Objects.requireNonNull(description, "description");
        Objects.requireNonNull(noWayBack, "noWayBack");
        Objects.requireNonNull(asking, "asking");
        Objects.requireNonNull(whyNot, "whyNot");
    }

    /** Whether what it does cannot be undone in the mission. */
    public boolean isFinal() {
        return !noWayBack.isEmpty();
    }

    /** The same, which the plan does not offer now. */
    public InterruptChoice notOffered() {
        return new InterruptChoice(
                mission,
                plan,
                name,
                asksForBoats,
                priority,
                description,
                noWayBack,
                OptionalLong.empty(),
                "The plan does not offer it now");
    }

    /** Whether it can be pressed now. */
    public boolean isEnabled() {
        return whyNot.isEmpty();
    }
}
