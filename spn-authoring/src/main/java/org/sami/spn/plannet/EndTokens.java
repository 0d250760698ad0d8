package org.sami.spn.plannet;

import java.util.List;
import java.util.Set;

/**
 * What a firing brings to end places.
 *
 * @param tokens the robots and tasks
 * @param edges the numbers of the out edges by which robots come there
 */
record EndTokens(List<PlanToken> tokens, Set<Integer> edges) {
    EndTokens {
        tokens = List.copyOf(tokens);
        edges = Set.copyOf(edges);
    }
}
