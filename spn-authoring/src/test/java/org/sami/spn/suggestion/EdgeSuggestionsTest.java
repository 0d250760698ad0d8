package org.sami.spn.suggestion;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sami.spn.analysis.PlanChecks;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.finding.Severity;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.statespace.DeepChecks;
import org.sami.spn.statespace.DeepRequest;
import org.sami.spn.statespace.SearchWatch;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** Suggestions at edges of small plans whose faults can be seen. */
class EdgeSuggestionsTest {
    /** The operator says yes or no; who says no waits, and goes on to the end where the requirements allow it. */
    private static Plan waiting(String... requirements) {
        return new NetBuilder("asks")
                .start("ask")
                .output("ask", "Approve")
                .end("end")
                .transition("yes", "Yes")
                .in("ask", "yes", "any >= 1")
                .out("yes", "end", "take all any")
                .transition("no", "No")
                .in("ask", "no", "any >= 1")
                .out("no", "waiting", "take all any")
                .in("waiting", "again", requirements)
                .out("again", "end", "take all any")
                .build();
    }

    private static String into(Plan plan, String place, String transition) {
        return plan.inEdges().stream()
                .filter(edge -> edge.place().equals(place) && edge.transition().equals(transition))
                .map(InEdge::id)
                .findFirst()
                .orElseThrow();
    }

    private static String outOf(Plan plan, String transition) {
        return plan.outEdgesOf(transition).stream().map(OutEdge::id).findFirst().orElseThrow();
    }

    private static SuggestionRequest request(Plan plan, String edge) {
        return new SuggestionRequest(NetBuilder.project(plan), TestVocabulary.TEST, plan.id(), edge);
    }

    private static SuggestionResult at(Plan plan, String edge) {
        return EdgeSuggestions.find(request(plan, edge), SuggestionWatch.NONE);
    }

    @Test
    void requirementsThatNobodyFulfilsAreReplacedByThoseThatLetTheMissionEnd() {
        Plan plan = waiting("any >= 9");

        SuggestionResult result = at(plan, into(plan, "waiting", "again"));

        assertThat(result.findings()).isPositive();
        assertThat(result.tried()).isEqualTo(result.candidates());
        Suggestion best = result.suggestions().get(0);
        assertThat(best.words()).isEqualTo("≥ 1 Proxy");
        assertThat(best.left()).isZero();
        assertThat(best.complete()).isTrue();
        assertThat(best.mended())
                .containsExactly("The mission no longer stands still with tokens in \"waiting\"", "\"again\" can fire");
        assertThat(best.caused()).isEmpty();
        assertThat(result.suggestions()).noneMatch(one -> one.words().equals("No Token"));
    }

    @Test
    void suggestionLeavesAsManyFindingsAsTheChecksFindOnceItIsApplied() {
        Plan plan = waiting("any >= 9");

        List<Suggestion> suggestions = at(plan, into(plan, "waiting", "again")).suggestions();

        assertThat(suggestions).isNotEmpty().allSatisfy(suggestion -> {
            Project changed = suggestion
                    .edit()
                    .apply(NetBuilder.project(plan), TestVocabulary.TEST)
                    .project()
                    .orElseThrow();
            List<String> found = new ArrayList<>();
            PlanChecks.check(changed, TestVocabulary.TEST, plan.id()).stream()
                    .filter(finding -> finding.severity() != Severity.NOTE)
                    .forEach(finding -> found.add(finding.code() + finding.elements()));
            for (int robots = 1; robots <= 3; robots++) {
                List<String> names = IntStream.rangeClosed(1, robots)
                        .mapToObj(i -> "robot-" + i)
                        .toList();
                DeepChecks.ALL
                        .get(0)
                        .run(new DeepRequest(changed, TestVocabulary.TEST, plan.id(), names, 1000), SearchWatch.NONE)
                        .findings()
                        .stream()
                        .map(deep -> deep.finding())
                        .filter(finding -> finding.severity() != Severity.NOTE)
                        .forEach(finding -> found.add(finding.code() + finding.elements()));
            }
            assertThat(found.stream().distinct()).hasSize(suggestion.left());
        });
    }

    @Test
    void edgeWithoutRequirementsGetsSomeWithWhichThePlanStarts() {
        Plan plan = waiting();

        SuggestionResult result = at(plan, into(plan, "waiting", "again"));

        assertThat(result.suggestions().get(0).words()).isEqualTo("≥ 1 Proxy");
        assertThat(result.suggestions().get(0).left()).isZero();
        assertThat(result.suggestions().get(0).mended())
                .singleElement()
                .satisfies(line -> assertThat(line).startsWith("Mended: ").contains("has no requirement"));
    }

    @Test
    void requirementsOfAnEdgeOutLeadOnWhoWasToStay() {
        Plan plan = withOut(waiting("any >= 1"), "no", OutRequirement.of(Action.CONSUME, 1, TokenKind.GENERIC));

        SuggestionResult result = at(plan, outOf(plan, "no"));

        assertThat(result.suggestions()).isNotEmpty();
        assertThat(result.suggestions().get(0).words()).isEqualTo("Consume 1 Generic, Take All Proxy");
        assertThat(result.suggestions()).noneMatch(one -> one.words().contains("Consume All Proxy"));
    }

    private static Plan withOut(Plan plan, String transition, OutRequirement... requirements) {
        return plan.withOutEdges(plan.outEdges().stream()
                .map(edge -> edge.transition().equals(transition) ? edge.withRequirements(List.of(requirements)) : edge)
                .toList());
    }

    @Test
    void planWithoutFindingsCanStayAsItIs() {
        Plan plan = waiting("any >= 1");

        SuggestionResult result = at(plan, into(plan, "waiting", "again"));

        assertThat(result.findings()).isZero();
        assertThat(result.suggestions()).isEmpty();
        assertThat(result.summary()).contains("can stay as they are");
    }

    @Test
    void errorElsewhereIsToBeMendedFirst() {
        Plan plan = waiting("any >= 9");
        Plan broken = withOut(plan, "no");

        SuggestionResult result = at(broken, into(broken, "waiting", "again"));

        assertThat(result.suggestions()).isEmpty();
        assertThat(result.summary()).contains("mended elsewhere first");
    }

    @Test
    void searchEndsWithinItsBudgetOfStatesAndSaysSo() {
        Plan plan = waiting("any >= 9");
        SuggestionRequest small = new SuggestionRequest(
                NetBuilder.project(plan),
                TestVocabulary.TEST,
                plan.id(),
                into(plan, "waiting", "again"),
                List.of(2, 1),
                1000,
                20);

        SuggestionResult result = EdgeSuggestions.find(small, SuggestionWatch.NONE);

        assertThat(result.tried()).isLessThan(result.candidates());
        assertThat(result.summary()).contains("within 20 states");
    }

    @Test
    void stoppedSearchKeepsWhatItHasFound() {
        Plan plan = waiting("any >= 9");
        List<Integer> progress = new ArrayList<>();
        SuggestionWatch stopsAfterFive = new SuggestionWatch() {
            @Override
            public void tried(int candidates, int all) {
                progress.add(candidates);
            }

            @Override
            public boolean isCancelled() {
                return progress.size() > 5;
            }
        };

        SuggestionResult result = EdgeSuggestions.find(request(plan, into(plan, "waiting", "again")), stopsAfterFive);

        assertThat(progress).containsExactly(0, 1, 2, 3, 4, 5);
        assertThat(result.tried()).isEqualTo(5);
        assertThat(result.summary()).contains("before it was stopped");
    }

    @Test
    void lockedEdgeAndUnknownEdgeAreRefused() {
        Plan plan = waiting("any >= 9");
        String edge = into(plan, "waiting", "again");
        Project locked = new EdgeEdit.SetLocked(plan.id(), Set.of(edge), true)
                .apply(NetBuilder.project(plan), TestVocabulary.TEST)
                .project()
                .orElseThrow();

        assertThatThrownBy(() -> EdgeSuggestions.find(
                        new SuggestionRequest(locked, TestVocabulary.TEST, plan.id(), edge), SuggestionWatch.NONE))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("locked");
        assertThatThrownBy(() -> at(plan, "nowhere"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no edge \"nowhere\"");
    }

    @Test
    void noCandidateTakesWhatAnotherEdgeOfTheTransitionTakes() {
        Plan plan = new NetBuilder("forks")
                .start("s")
                .end("end")
                .transition("t")
                .in("s", "t", "any >= 1")
                .out("t", "a", "take all proxy")
                .out("t", "end", "take all generic")
                .build();

        List<String> words = new EdgeCandidates(plan, TestVocabulary.TEST)
                .of(plan.outEdges().get(1).id()).stream().map(Candidate::words).toList();

        assertThat(words).isNotEmpty().noneMatch(text -> text.matches(".*Take \\w+ (Proxy|Token|Relevant).*"));
    }
}
