package org.sami.spn.model;

import java.util.List;
import java.util.Objects;

/**
 * A place.
 *
 * @param name for people; may be empty
 * @param endsSharedInstance on an end place of a static sub-mission: entering it ends the shared instance; otherwise it
 *     returns
 * @param transitionOrder ids of out-transitions in the order in which they are looked at; those not listed follow in the
 *     order of the plan's in edges
 */
public record Place(
        String id,
        String name,
        boolean start,
        boolean end,
        boolean endsSharedInstance,
        Mode mode,
        List<OutputEventSpec> outputs,
        List<SubMissionSpec> subMissions,
        List<String> transitionOrder) {
    public Place {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(mode, "mode");
        outputs = List.copyOf(outputs);
        subMissions = List.copyOf(subMissions);
        transitionOrder = List.copyOf(transitionOrder);
    }
}
