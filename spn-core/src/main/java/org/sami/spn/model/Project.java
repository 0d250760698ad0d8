package org.sami.spn.model;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * A project: plans of one domain, with the variables they share.
 *
 * @param domain id of the vocabulary
 * @param missionTree roots of the tree in which the plans are shown
 */
public record Project(
        String id,
        String name,
        String domain,
        List<VariableSpec> globals,
        List<MissionTreeNode> missionTree,
        List<Plan> plans) {
    public Project {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(name, "name");
        Objects.requireNonNull(domain, "domain");
        globals = List.copyOf(globals);
        missionTree = List.copyOf(missionTree);
        plans = List.copyOf(plans);
    }

    /** The plan of that id. */
    public Optional<Plan> plan(String planId) {
        return plans.stream().filter(p -> p.id().equals(planId)).findFirst();
    }
}
