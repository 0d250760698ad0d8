package org.sami.spn.engine.rule;

import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.protocol.Token;

/**
 * Tokens between a mission and its child: a task of the parent's has a name of its own there.
 *
 * <p>Implements R-TASK-5, R-SUB-7.
 */
final class ChildTokens {
    private ChildTokens() {}

    /** A parent's token as its child names it. */
    static Token toChild(MissionState child, Token token) {
        if (token instanceof Token.Task task) {
            for (TaskState own : child.tasks.values()) {
                if (own.original != null && own.original.id.equals(task.task())) {
                    return new Token.Task(own.id);
                }
            }
        }
        return token;
    }

    /** A child's token as its parent names it; null for a task of the child's own. */
    static @Nullable Token toParent(MissionState child, Token token) {
        if (token instanceof Token.Task task && task.task().mission() == child.id) {
            TaskState own = child.tasks.get(task.task().name());
            return own == null || own.original == null ? null : new Token.Task(own.original.id);
        }
        return token;
    }
}
