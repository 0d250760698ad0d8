package org.sami.crw.operator.mission;

import java.util.Objects;
import java.util.OptionalLong;
import org.sami.spn.protocol.Priority;

/**
 * A button for an interrupt of a running mission.
 *
 * @param plan title of the mission's plan
 * @param name the button's text
 * @param asksForBoats whether a press needs boats: named by it or chosen afterwards
 * @param priority its priority (markup Priority); medium without one
 * @param description the author's description (markup Description); empty text for none
 * @param noWayBack why the mission cannot undo it ({@link InterruptReversibility}); empty text where the plan leads back
 * @param asking the open decision that asks for its boats after a press without boats; empty = none
 * @param whyNot why a press would be refused now, in words; empty where it would be taken
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
