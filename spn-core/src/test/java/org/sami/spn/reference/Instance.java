package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.Place;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/** A sub-mission that was started: of one visit (dynamic) or of the parent mission (static) (R-SUB-1, R-SHR-1). */
final class Instance {
    enum State {
        RUNNING,
        COMPLETE,
        ABORTED
    }

    final SubMissionSpec spec;
    final Mission parent;
    final Place place;
    /** Empty for a static one. */
    final Optional<Visit> visit;

    Mission child;
    State state = State.RUNNING;
    /** Dynamic: the tokens of the end places that can still be taken. */
    final List<Token> back = new ArrayList<>();
    /** Static: what joined it and has not returned. */
    final List<Token> joined = new ArrayList<>();
    /** Static: completions not yet used by an out-transition, oldest first. */
    final List<Returned> returns = new ArrayList<>();

    Instance(SubMissionSpec spec, Mission parent, Place place, Optional<Visit> visit) {
        this.spec = spec;
        this.parent = parent;
        this.place = place;
        this.visit = visit;
    }

    /** A token of the parent as the child names it (R-TASK-5). */
    Token toChild(Token token) {
        if (token instanceof Token.Task task) {
            for (Map.Entry<String, TaskId> own : child.standsFor.entrySet()) {
                if (own.getValue().equals(task.task())) {
                    return new Token.Task(new TaskId(child.id, own.getKey()));
                }
            }
        }
        return token;
    }

    /** A token of the child as the parent names it; none of the child's own tasks (R-SUB-7). */
    Optional<Token> toParent(Token token) {
        if (token instanceof Token.Task task && task.task().mission() == child.id) {
            return Optional.ofNullable(child.standsFor.get(task.task().name())).map(Token.Task::new);
        }
        return Optional.of(token);
    }
}
