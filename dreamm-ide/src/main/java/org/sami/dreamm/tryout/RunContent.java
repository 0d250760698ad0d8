package org.sami.dreamm.tryout;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.VariableSpec;

/**
 * What the runs of one plan hang on: the variables of the project, the plan and all plans that it runs as sub-missions. Layout, notes, descriptions, names of plans, test
 * cases and queries are no part of it. Equal contents run equally and are told in the same words. Immutable.
 *
 * @param plan its id
 * @param globals variables of the project
 * @param parts what runs of each of these plans, by its id; a plan that is not there has nothing
 */
public record RunContent(String plan, List<VariableSpec> globals, Map<String, List<Object>> parts) {
    public RunContent {
        Objects.requireNonNull(plan, "plan");
        globals = List.copyOf(globals);
        parts = Map.copyOf(parts);
    }

    /** The content of a plan of a project, which need not be there. */
    public static RunContent of(Project project, String plan) {
        Map<String, List<Object>> parts = new LinkedHashMap<>();
        Deque<String> open = new ArrayDeque<>(List.of(plan));
        while (!open.isEmpty()) {
            String id = open.pop();
            if (!parts.containsKey(id)) {
                Optional<Plan> found = project.plan(id);
                parts.put(id, runs(found));
                found.ifPresent(some -> open.addAll(children(some)));
            }
        }
        return new RunContent(plan, project.globals(), parts);
    }

    private static List<String> children(Plan plan) {
        List<String> children = new ArrayList<>();
        for (Place place : plan.places()) {
            place.subMissions().stream().map(SubMissionSpec::plan).forEach(children::add);
        }
        return children;
    }

    /** What of a plan makes a difference to its runs; nothing of a plan that is not there. */
    static List<Object> runs(Optional<Plan> plan) {
        return plan.map(p -> List.<Object>of(
                        p.places(), p.transitions(), p.inEdges(), p.outEdges(), p.variables(), p.reads(), p.tasks()))
                .orElse(List.of());
    }
}
