package org.sami.spn.plannet;

import java.util.List;
import java.util.Set;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;

/**
 * What is known of robots that a net counts, so that a run of it can name them. Immutable.
 *
 * @param options for each transition of the net what it supposes of each robot and does with it
 */
record CountedParts(List<List<TokenOption>> options, PossibleTokens possible, Plan plan) {
    CountedParts {
        options = List.copyOf(options);
    }

    /** Where all robots stand at first; none where they stand nowhere. */
    Set<String> start() {
        return plan.startPlace()
                .map(Place::id)
                .filter(place -> possible.comes(place, PlanToken.ROBOTS))
                .map(Set::of)
                .orElse(Set.of());
    }
}
