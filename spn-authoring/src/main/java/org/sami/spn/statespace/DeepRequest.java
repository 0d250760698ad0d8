package org.sami.spn.statespace;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a deep check is to run.
 *
 * @param plan its id
 * @param robots names of the robots that are known at the start
 * @param locations how many locations the operator gives where some are asked for; each is tried
 * @param mostStates how many states are looked at before the search gives up
 * @param mostBytes how much memory the states may need, in bytes, estimated
 */
public record DeepRequest(
        Project project,
        Vocabulary vocabulary,
        String plan,
        List<String> robots,
        List<Integer> locations,
        int mostStates,
        long mostBytes) {
    /** As few as there can be, some, and more than most teams have robots. */
    public static final List<Integer> LOCATIONS = List.of(1, 3, 5);

    /** How many states a search looks at unless somebody says otherwise. */
    public static final int STANDARD_STATES = 5000;

    private static final int PART_OF_MEMORY = 4;

    public DeepRequest {
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(plan, "plan");
        robots = List.copyOf(robots);
        locations = List.copyOf(locations);
        if (mostStates < 1) {
            throw new IllegalArgumentException("A search looks at 1 state at least, not " + mostStates);
        }
        if (locations.isEmpty() || locations.stream().anyMatch(count -> count < 1)) {
            throw new IllegalArgumentException("The operator gives 1 location at least, not " + locations);
        }
        if (mostBytes < 1) {
            throw new IllegalArgumentException("A search needs memory, not " + mostBytes + " bytes");
        }
    }

    /** A search with 1, 3 and 5 locations and a quarter of the program's memory. */
    public DeepRequest(Project project, Vocabulary vocabulary, String plan, List<String> robots, int mostStates) {
        this(
                project,
                vocabulary,
                plan,
                robots,
                LOCATIONS,
                mostStates,
                Runtime.getRuntime().maxMemory() / PART_OF_MEMORY);
    }
}
