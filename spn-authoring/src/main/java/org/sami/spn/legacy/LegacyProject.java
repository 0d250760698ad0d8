package org.sami.spn.legacy;

import java.util.List;
import java.util.Optional;

/**
 * A project of the earlier system as its export states it, before any of it is interpreted.
 *
 * @param source name of the file that was exported; may be empty
 * @param plans in the order of the mission tree
 */
record LegacyProject(
        String source, List<Global> globals, Optional<TreeNode> tree, List<LegacyPlan> plans, List<String> notes) {
    LegacyProject {
        globals = List.copyOf(globals);
        plans = List.copyOf(plans);
        notes = List.copyOf(notes);
    }

    Optional<LegacyPlan> plan(String id) {
        return plans.stream().filter(p -> p.id().equals(id)).findFirst();
    }

    /** A global variable; its value may be missing. */
    record Global(String pointer, String name, String className, Optional<LegacyValue> value) {}

    /** A node of the mission tree: a folder, or a plan by its id. */
    record TreeNode(String label, Optional<String> plan, List<TreeNode> children) {
        TreeNode {
            children = List.copyOf(children);
        }
    }
}
