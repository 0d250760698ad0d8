package org.sami.lessons.job;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;

/** How large a plan may be that is graded: far larger than any answer to a job, and small enough to run in a moment. */
final class PlanLimits {
    /** Bytes of a file. */
    static final long MOST_BYTES = 1L << 20;

    private static final int MOST_PARTS = 2000;
    private static final int MOST_TOKENS_MADE = 100;
    private static final long MOST_INSTANCES = 100;

    private PlanLimits() {}

    /** What of a project is too large to be graded, in a sentence; empty where nothing is. */
    static Optional<String> excess(Project project, String plan) {
        int parts = 0;
        for (Plan one : project.plans()) {
            parts += one.places().size()
                    + one.transitions().size()
                    + one.inEdges().size()
                    + one.outEdges().size()
                    + one.tasks().size()
                    + one.places().stream()
                            .mapToInt(place -> place.outputs().size())
                            .sum();
            for (OutEdge edge : one.outEdges()) {
                boolean makesMany = edge.requirements().stream().anyMatch(r -> r.n() > MOST_TOKENS_MADE);
                if (makesMany) {
                    return Optional.of("An edge of the plan speaks of more than " + MOST_TOKENS_MADE
                            + " tokens: such a plan is not graded.");
                }
            }
        }
        if (parts > MOST_PARTS) {
            return Optional.of(
                    "The file has " + parts + " places, transitions, edges and events; a plan with more than "
                            + MOST_PARTS + " of them is not graded.");
        }
        return instances(project, plan, new HashMap<>(), new HashSet<>()) > MOST_INSTANCES
                ? Optional.of("The plan runs more than " + MOST_INSTANCES
                        + " sub-missions, or runs itself: such a plan is not graded.")
                : Optional.empty();
    }

    /** How many missions a plan may lead to where each place is entered once; very many where it runs itself. */
    private static long instances(Project project, String plan, Map<String, Long> known, Set<String> open) {
        if (!open.add(plan)) {
            return MOST_INSTANCES + 1;
        }
        Long found = known.get(plan);
        if (found == null) {
            found = 1L;
            for (Place place : project.plan(plan).map(Plan::places).orElse(List.of())) {
                for (SubMissionSpec sub : place.subMissions()) {
                    found = Math.min(MOST_INSTANCES + 1, found + instances(project, sub.plan(), known, open));
                }
            }
            known.put(plan, found);
        }
        open.remove(plan);
        return found;
    }
}
