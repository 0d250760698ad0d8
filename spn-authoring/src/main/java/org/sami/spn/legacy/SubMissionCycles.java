package org.sami.spn.legacy;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.finding.Finding;

/**
 * Finds plans that run themselves by way of their sub-missions. In the earlier system each place had a copy of the plan that it
 * ran, so that no project of it can have such a ring; the engine would start missions in one without end.
 */
final class SubMissionCycles {
    private final Map<String, LegacyPlan> plans = new HashMap<>();
    private final List<LegacyPlan> order;

    SubMissionCycles(List<LegacyPlan> order) {
        this.order = order;
        order.forEach(plan -> plans.putIfAbsent(plan.id(), plan));
    }

    /** One error for each plan that runs itself, at the sub-mission that begins the way. */
    List<Finding> findings() {
        List<Finding> found = new ArrayList<>();
        for (LegacyPlan plan : order) {
            for (LegacyPlan.SubMission child : children(plan)) {
                if (reaches(child.plan(), plan.id())) {
                    found.add(Finding.error(
                            LegacyCodes.CYCLE,
                            child.pointer(),
                            "The plan " + plan.id() + " (" + plan.name() + ") runs itself without end, by way of "
                                    + child.plan(),
                            plan.id(),
                            child.plan()));
                    break;
                }
            }
        }
        return found;
    }

    private boolean reaches(String from, String wanted) {
        Set<String> seen = new LinkedHashSet<>();
        Deque<String> next = new ArrayDeque<>(List.of(from));
        while (!next.isEmpty()) {
            String id = next.pop();
            if (id.equals(wanted)) {
                return true;
            }
            if (seen.add(id) && plans.containsKey(id)) {
                children(plans.get(id)).forEach(child -> next.push(child.plan()));
            }
        }
        return false;
    }

    private static List<LegacyPlan.SubMission> children(LegacyPlan plan) {
        return plan.vertices().stream().flatMap(v -> v.subMissions().stream()).toList();
    }
}
