package org.sami.crw.operator;

import java.util.Objects;
import java.util.OptionalLong;
import org.sami.spn.protocol.Decision;

/**
 * A decision that waits for the operator.
 *
 * @param openedAtMillis when it was asked, on the session's clock
 * @param plan id of the plan whose mission asks; empty text where the domain asks
 * @param mission name of the mission that asks; empty text where the domain asks
 * @param place id of the place whose output event asks; empty text where none does
 */
public record PendingDecision(Decision decision, long openedAtMillis, String plan, String mission, String place) {
    public PendingDecision {
        Objects.requireNonNull(decision, "decision");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(mission, "mission");
        Objects.requireNonNull(place, "place");
    }

    /** A decision of which it is not known what asks it. */
    public PendingDecision(Decision decision, long openedAtMillis) {
        this(decision, openedAtMillis, "", "", "");
    }

    /** For how many milliseconds it has waited. */
    public long ageMillis(long nowMillis) {
        return Math.max(0, nowMillis - openedAtMillis);
    }

    /** After how many milliseconds autonomy answers; empty where it never does. */
    public OptionalLong autonomyInMillis(long nowMillis) {
        OptionalLong deadline = decision.deadlineMillis();
        return deadline.isEmpty() ? deadline : OptionalLong.of(Math.max(0, deadline.getAsLong() - nowMillis));
    }
}
