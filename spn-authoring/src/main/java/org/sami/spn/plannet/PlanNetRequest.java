package org.sami.spn.plannet;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What is to become a net.
 *
 * @param plan its id
 * @param robots names of the robots that are known at the start; the team stays as it is
 * @param madeTasks how many tasks that a mission makes while it runs are followed
 * @param mostTransitions how many transitions the net may have
 */
public record PlanNetRequest(
        Project project, Vocabulary vocabulary, String plan, List<String> robots, int madeTasks, int mostTransitions) {
    /** How many tasks that are made at run time are followed unless somebody says otherwise. */
    public static final int STANDARD_TASKS = 2;

    /** How many transitions a net may have unless somebody says otherwise. */
    public static final int STANDARD_TRANSITIONS = 50_000;

    public PlanNetRequest {
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(plan, "plan");
        robots = List.copyOf(robots);
        if (madeTasks < 0 || mostTransitions < 1) {
            throw new IllegalArgumentException(
                    "A net follows 0 tasks and 1 transition at least, not " + madeTasks + " and " + mostTransitions);
        }
    }

    /** A net of the standard size. */
    public PlanNetRequest(Project project, Vocabulary vocabulary, String plan, List<String> robots) {
        this(project, vocabulary, plan, robots, STANDARD_TASKS, STANDARD_TRANSITIONS);
    }
}
