package org.sami.spn.suggestion;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Project;
import org.sami.spn.statespace.DeepCheck;
import org.sami.spn.statespace.DeepChecks;
import org.sami.spn.statespace.DeepFinding;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.statespace.DeepResult;
import org.sami.spn.statespace.SearchWatch;

/** Judges versions of a plan by all checks and deep checks, and counts the states that it looks at. */
final class PlanJudge {
    private static final DeepCheck EVERYTHING = DeepChecks.ALL.get(0);

    private final SuggestionRequest request;
    private final SearchWatch watch;
    private int states;

    PlanJudge(SuggestionRequest request, SuggestionWatch suggestions) {
        this.request = request;
        watch = new SearchWatch() {
            @Override
            public void looked(int states, int waiting) {
                // the number of candidates is the progress
            }

            @Override
            public boolean isCancelled() {
                return suggestions.isCancelled();
            }
        };
    }

    /** The quick checks; where they find an error, the plan does not start and nothing more is known of it. */
    VersionFindings quick(Project project) {
        return VersionFindings.of(PlanChecks.check(project, request.vocabulary(), request.plan()), true);
    }

    /** The searches with one team. */
    VersionFindings searched(Project project, int robots) {
        List<String> names =
                IntStream.rangeClosed(1, robots).mapToObj(i -> "robot-" + i).toList();
        int most = Math.min(request.statesPerSearch(), Math.max(1, request.allStates() - states));
        DeepResult result =
                EVERYTHING.run(new DeepRequest(project, request.vocabulary(), request.plan(), names, most), watch);
        states += result.states();
        List<Finding> found = new ArrayList<>(
                result.findings().stream().map(DeepFinding::finding).toList());
        return VersionFindings.of(found, result.complete());
    }

    int states() {
        return states;
    }

    boolean hasBudget() {
        return states < request.allStates();
    }
}
