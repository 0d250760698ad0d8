package org.sami.spn.plannet;

import java.util.HashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What is to become a net.
 *
 * @param plan its id
 * @param robots names of the robots that are known at the start, each once; the team stays as it is
 * @param madeTasks how many tasks that a mission makes while it runs are followed
 * @param mostTransitions how many transitions the net may have
 * @param depth how many levels of sub-missions are followed where robots are named; 0 for the plan alone
 */
public record PlanNetRequest(
        Project project,
        Vocabulary vocabulary,
        String plan,
        List<String> robots,
        int madeTasks,
        int mostTransitions,
        int depth) {
    /** How many tasks that are made at run time are followed unless somebody says otherwise. */
    public static final int STANDARD_TASKS = 2;

    /** How many transitions a net may have unless somebody says otherwise. */
    public static final int STANDARD_TRANSITIONS = 50_000;

    public PlanNetRequest {
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(plan, "plan");
        robots = List.copyOf(robots);
        requireOnce(robots);
        if (madeTasks < 0 || mostTransitions < 1 || depth < 0) {
            throw new IllegalArgumentException("A net follows 0 tasks, 1 transition and 0 levels at least, not "
                    + madeTasks + ", " + mostTransitions + " and " + depth);
        }
    }

    /** A robot that is named twice would be two robots of the net, of which the engine knows one. */
    private static void requireOnce(List<String> robots) {
        Set<String> named = new HashSet<>();
        for (String robot : robots) {
            if (!named.add(robot)) {
                throw new IllegalArgumentException("A net has each robot once, not \"" + robot + "\" again");
            }
        }
    }

    /** A net of the standard size. */
    public PlanNetRequest(Project project, Vocabulary vocabulary, String plan, List<String> robots) {
        this(project, vocabulary, plan, robots, STANDARD_TASKS, STANDARD_TRANSITIONS);
    }

    /** A net of the plan alone. */
    public PlanNetRequest(
            Project project,
            Vocabulary vocabulary,
            String plan,
            List<String> robots,
            int madeTasks,
            int mostTransitions) {
        this(project, vocabulary, plan, robots, madeTasks, mostTransitions, 0);
    }

    /** The same to another depth of sub-missions. */
    public PlanNetRequest toDepth(int levels) {
        return new PlanNetRequest(project, vocabulary, plan, robots, madeTasks, mostTransitions, levels);
    }
}
