package org.sami.dreamm.tree;

import java.util.List;
import java.util.Objects;

/**
 * A line of the mission tree.
 *
 * @param plan id of the plan that it is, or belongs to; empty text where it belongs to the project
 * @param id of the sub-mission, or name of the task or variable; empty text where it is none
 * @param title what it is called
 * @param detail the lighter text next to it; may be empty
 * @param path the indices that lead to it in the project's mission tree; empty where it is no node of that
 */
record TreeItem(
        Kind kind, String plan, String id, String title, String detail, List<Integer> path, List<TreeItem> children) {
    /** What a line stands for. */
    enum Kind {
        PROJECT("file"),
        FOLDER("folder"),
        PLAN("net"),
        SUB_MISSION("layers"),
        TASK("edge"),
        VARIABLE("variables"),
        VARIABLES("variables");

        private final String icon;

        Kind(String icon) {
            this.icon = icon;
        }

        String icon() {
            return icon;
        }
    }

    TreeItem {
        Objects.requireNonNull(kind, "kind");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(title, "title");
        Objects.requireNonNull(detail, "detail");
        path = List.copyOf(path);
        children = List.copyOf(children);
    }

    /** Names the line through edits of the project, so that it stays open and selected. */
    String key() {
        return kind + "/" + plan + "/" + (kind == Kind.FOLDER ? title : id);
    }
}
