package org.sami.spn.engine.codec;

import java.util.Map;
import java.util.Set;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/** Numbers robots and tasks as objects of facts; those of which plans speak by name keep their names. */
final class AlikeNames {
    private final Map<Long, MissionState> missions;
    private final Set<String> robots;
    private final LabelledStructure facts;

    /**
     * Names of robots and tasks.
     *
     * @param robots names of robots that are like one another
     */
    AlikeNames(Map<Long, MissionState> missions, Set<String> robots, LabelledStructure facts) {
        this.missions = missions;
        this.robots = robots;
        this.facts = facts;
    }

    int robot(String name) {
        return facts.object("robot " + name, robots.contains(name) ? "robot" : "robot " + name);
    }

    int task(TaskId id) {
        MissionState m = missions.get(id.mission());
        boolean made = m != null && !m.plan.namedTasks.contains(id.name());
        return facts.object(id, made ? "task" : "task " + id.name() + (m == null ? " of another" : ""));
    }

    int token(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return robot(proxy.proxy());
        }
        return token instanceof Token.Task task ? task(task.task()) : facts.object(Token.GENERIC, "generic");
    }
}
