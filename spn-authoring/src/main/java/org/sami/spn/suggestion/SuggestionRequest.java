package org.sami.spn.suggestion;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.Project;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The edge at which requirements are sought, and how far to search.
 *
 * @param plan id of the edge's plan
 * @param edge id of an in edge or an out edge of the plan
 * @param teams numbers of robots with which each candidate is searched; the first one also decides which candidates the others are tried for
 * @param statesPerSearch how many states one search of one candidate looks at
 * @param allStates how many states all searches together look at
 */
public record SuggestionRequest(
        Project project,
        Vocabulary vocabulary,
        String plan,
        String edge,
        List<Integer> teams,
        int statesPerSearch,
        int allStates) {
    /** Two robots first, as most faults show with two; then one and three. */
    public static final List<Integer> TEAMS = List.of(2, 1, 3);

    /** How many states one search looks at unless somebody says otherwise. */
    public static final int STATES_PER_SEARCH = 1000;

    /** How many states all searches look at together unless somebody says otherwise. */
    public static final int ALL_STATES = 100_000;

    public SuggestionRequest {
        Objects.requireNonNull(project, "project");
        Objects.requireNonNull(vocabulary, "vocabulary");
        Objects.requireNonNull(plan, "plan");
        Objects.requireNonNull(edge, "edge");
        teams = List.copyOf(teams);
        if (teams.isEmpty() || teams.stream().anyMatch(robots -> robots < 1)) {
            throw new IllegalArgumentException("A team has 1 robot at least, not " + teams);
        }
        if (statesPerSearch < 1 || allStates < 1) {
            throw new IllegalArgumentException(
                    "A search looks at 1 state at least, not " + statesPerSearch + " and " + allStates);
        }
        if (project.plan(plan).isEmpty()) {
            throw new IllegalArgumentException("The project has no plan \"" + plan + "\"");
        }
    }

    /** A request with teams of one to three robots and the usual budget of states. */
    public SuggestionRequest(Project project, Vocabulary vocabulary, String plan, String edge) {
        this(project, vocabulary, plan, edge, TEAMS, STATES_PER_SEARCH, ALL_STATES);
    }
}
