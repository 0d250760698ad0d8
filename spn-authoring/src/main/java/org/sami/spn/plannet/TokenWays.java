package org.sami.spn.plannet;

import java.util.List;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Transition;

/** Where tokens can stand, and what requirements can do with them. */
interface TokenWays {
    /** Whether a token can stand in a place. */
    boolean comes(String place, PlanToken token);

    /** Whether a sub-mission runs in a place. */
    boolean hasSub(String place);

    /** The in places of a transition in which a token can stand when it fires, each once, in the order of its edges. */
    List<String> spots(Transition t, PlanToken token);

    /** Whether a requirement can select a token of the pool. */
    boolean covers(OutRequirement r, Transition t, PlanToken token);

    /** Whether a requirement can add a token that stands in no in place. */
    boolean makes(OutRequirement r, Transition t, PlanToken token);
}
