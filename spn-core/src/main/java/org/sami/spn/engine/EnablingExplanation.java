package org.sami.spn.engine;

import java.util.List;
import org.sami.spn.model.InputEventSpec;

/**
 * A yes or no with its reasons.
 *
 * @param reasons one sentence each, for people; empty where the answer is yes
 * @param awaited input events that have not been received and can still come, in order; empty where none is missing, or where one
 *     that is missing can come no longer
 * @param awaitedSubMissions ids of in places whose sub-missions must end or return somebody first, and still can
 */
public record EnablingExplanation(
        boolean yes, List<String> reasons, List<InputEventSpec> awaited, List<String> awaitedSubMissions) {
    public EnablingExplanation {
        reasons = List.copyOf(reasons);
        awaited = List.copyOf(awaited);
        awaitedSubMissions = List.copyOf(awaitedSubMissions);
    }

    /** An answer that no sub-mission changes. */
    public EnablingExplanation(boolean yes, List<String> reasons, List<InputEventSpec> awaited) {
        this(yes, reasons, awaited, List.of());
    }

    /** An answer that no event changes. */
    public EnablingExplanation(boolean yes, List<String> reasons) {
        this(yes, reasons, List.of());
    }
}
