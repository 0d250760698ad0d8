package org.sami.spn.analysis.space;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * What a deep check is to run.
 *
 * @param plan its id
 * @param robots names of the robots that are known at the start
 * @param mostStates how many states are looked at before the search gives up
 */
public record DeepRequest(Project project, Vocabulary vocabulary, String plan, List<String> robots, int mostStates) {
    public DeepRequest {
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(plan, "plan");
        robots = List.copyOf(robots);
        if (mostStates < 1) {
            throw new IllegalArgumentException("A search looks at 1 state at least, not " + mostStates);
        }
    }
}
