package org.sami.spn.suggestion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;

/**
 * Suggests requirements at an edge. Each candidate is written on the edge; the changed plan is judged by the quick checks, then by all deep
 * checks with each team. A candidate that leaves fewer findings than the edge as it stands is a suggestion. As deep checks try samples of
 * values, a suggestion is no proof that the plan is sound.
 */
public final class EdgeSuggestions {
    private final SuggestionRequest request;
    private final SuggestionWatch watch;
    private final PlanJudge judge;
    private final Plan plan;
    private final FindingWords words;

    private record Ranked(Suggestion suggestion, int changes) {}

    private EdgeSuggestions(SuggestionRequest request, SuggestionWatch watch) {
        this.request = request;
        this.watch = watch;
        judge = new PlanJudge(request, watch);
        plan = request.project().plan(request.plan()).orElseThrow();
        words = new FindingWords(plan, request.vocabulary());
    }

    /**
     * Runs on the caller's thread.
     *
     * @throws IllegalArgumentException with the reason, if the plan has no such edge, the edge is locked, or the plan cannot start
     */
    public static SuggestionResult find(SuggestionRequest request, SuggestionWatch watch) {
        return new EdgeSuggestions(request, watch).run();
    }

    private SuggestionResult run() {
        List<Candidate> candidates = new EdgeCandidates(plan, request.vocabulary()).of(request.edge());
        VersionFindings first = start(request.project());
        VersionFindings before = rest(request.project(), first);
        if (before.size() == 0) {
            return result(List.of(), before, 0, candidates.size());
        }
        List<Ranked> better = new ArrayList<>();
        int tried = 0;
        while (tried < candidates.size() && judge.hasBudget() && !watch.isCancelled()) {
            watch.tried(tried, candidates.size());
            Candidate candidate = candidates.get(tried);
            Optional<VersionFindings> after = candidate
                    .edit()
                    .apply(request.project(), request.vocabulary())
                    .project()
                    .flatMap(changed -> judged(changed, first, before));
            if (watch.isCancelled()) { // a stopped search has not seen all
                break;
            }
            after.ifPresent(found -> better.add(new Ranked(suggestion(candidate, before, found), candidate.changes())));
            tried++;
        }
        better.sort(Comparator.comparingInt((Ranked one) -> one.suggestion().left())
                .thenComparing(one -> !one.suggestion().complete())
                .thenComparingInt(one -> one.suggestion().fresh())
                .thenComparingInt(Ranked::changes));
        return result(better.stream().map(Ranked::suggestion).toList(), before, tried, candidates.size());
    }

    /** The quick checks and, where these find no error, the search with the first team. */
    private VersionFindings start(Project project) {
        VersionFindings quick = judge.quick(project);
        return quick.errors() > 0
                ? quick
                : quick.and(judge.searched(project, request.teams().get(0)));
    }

    /** The searches with the other teams. */
    private VersionFindings rest(Project project, VersionFindings start) {
        VersionFindings all = start;
        if (start.errors() == 0) {
            for (int robots : request.teams().subList(1, request.teams().size())) {
                all = all.and(judge.searched(project, robots));
            }
        }
        return all;
    }

    /** The findings about a changed plan, if they are fewer. */
    private Optional<VersionFindings> judged(Project changed, VersionFindings first, VersionFindings before) {
        VersionFindings quick = judge.quick(changed);
        if (quick.errors() > 0) {
            return Optional.empty();
        }
        VersionFindings start =
                quick.and(judge.searched(changed, request.teams().get(0)));
        boolean ran = first.errors() == 0;
        if (ran && (start.size() > first.size() || (start.size() == first.size() && first.size() > 0))) {
            return Optional.empty(); // the first team shows no gain: the others are not tried
        }
        VersionFindings after = rest(changed, start);
        return ran && after.size() >= before.size() ? Optional.empty() : Optional.of(after);
    }

    private Suggestion suggestion(Candidate candidate, VersionFindings before, VersionFindings after) {
        return new Suggestion(
                candidate.words(),
                candidate.edit(),
                words.mended(before.without(after)),
                words.caused(after.without(before)),
                before.without(after).size(),
                after.without(before).size(),
                after.size(),
                after.complete());
    }

    private SuggestionResult result(List<Suggestion> found, VersionFindings before, int tried, int all) {
        String summary;
        if (before.size() == 0) {
            summary = "Nothing is found in this plan" + (before.complete() ? "" : ", as far as it was searched")
                    + ": the requirements can stay as they are";
        } else {
            summary = tried + " of " + all + " sets of requirements were tried" + (tried == all ? "" : why()) + ": "
                    + (found.isEmpty()
                            ? none(before)
                            : found.size() + " leave fewer than " + before.size()
                                    + (before.size() == 1 ? " finding" : " findings"));
        }
        return new SuggestionResult(found, before.size(), tried, all, judge.states(), summary);
    }

    private String why() {
        return watch.isCancelled() ? " before it was stopped" : " within " + request.allStates() + " states";
    }

    private static String none(VersionFindings before) {
        return before.errors() > 0
                ? "with each of them the plan still has errors, which are to be mended elsewhere first"
                : "none leaves fewer findings; look at the edges around it";
    }
}
