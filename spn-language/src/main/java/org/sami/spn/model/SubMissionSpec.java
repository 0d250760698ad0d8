package org.sami.spn.model;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;

/**
 * A sub-mission on a place (thesis 3.1, 4.1.5).
 *
 * @param id unique in the plan
 * @param plan id of the plan that is run
 * @param shared true = static: one instance per parent mission; false = dynamic: one per visit
 * @param tasks the child's task name for a parent's task name: their tokens start as that task
 * @param variables the parent's variable for a child's variable, both with {@code @}: reads and writes of the child's
 *     name go to the parent's
 */
public record SubMissionSpec(
        String id, String plan, boolean shared, Map<String, String> tasks, Map<String, String> variables) {
    public SubMissionSpec {
        Objects.requireNonNull(id, "id");
        Objects.requireNonNull(plan, "plan");
        tasks = Collections.unmodifiableMap(new LinkedHashMap<>(tasks));
        variables = Collections.unmodifiableMap(new LinkedHashMap<>(variables));
    }

    /** The same sub-mission with another id. */
    public SubMissionSpec withId(String id) {
        return new SubMissionSpec(id, plan, shared, tasks, variables);
    }

    /** The same sub-mission with another plan. */
    public SubMissionSpec withPlan(String plan) {
        return new SubMissionSpec(id, plan, shared, tasks, variables);
    }

    /** The same sub-mission with other tasks. */
    public SubMissionSpec withTasks(Map<String, String> tasks) {
        return new SubMissionSpec(id, plan, shared, tasks, variables);
    }

    /** The same sub-mission with other variables. */
    public SubMissionSpec withVariables(Map<String, String> variables) {
        return new SubMissionSpec(id, plan, shared, tasks, variables);
    }
}
