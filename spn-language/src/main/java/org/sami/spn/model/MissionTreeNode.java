package org.sami.spn.model;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/** A node of the mission tree (thesis 5.1): a folder with a label, or a plan. */
public record MissionTreeNode(String label, Optional<String> plan, List<MissionTreeNode> children) {
    public MissionTreeNode {
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(plan, "plan");
        children = List.copyOf(children);
    }

    /** The same node with another plan. */
    public MissionTreeNode withPlan(Optional<String> plan) {
        return new MissionTreeNode(label, plan, children);
    }

    /** The same node with other children. */
    public MissionTreeNode withChildren(List<MissionTreeNode> children) {
        return new MissionTreeNode(label, plan, children);
    }
}
