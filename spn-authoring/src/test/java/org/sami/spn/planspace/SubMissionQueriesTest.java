package org.sami.spn.planspace;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.Abstraction;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** What following sub-missions changes in answers. */
class SubMissionQueriesTest {
    private static final SearchBudget ENOUGH = new SearchBudget(10_000, 64L << 20, Duration.ofMinutes(5));

    private static Project project(String whatTheChildWaitsFor) {
        return project(whatTheChildWaitsFor, false);
    }

    private static Project project(String whatTheChildWaitsFor, boolean isShared) {
        return project(
                new NetBuilder("child")
                        .start("c")
                        .output("c", "Do")
                        .end("e")
                        .transition("u", "Done")
                        .in("c", "u", whatTheChildWaitsFor)
                        .out("u", "e", "take all proxy"),
                isShared);
    }

    private static Project project(NetBuilder child, boolean isShared) {
        return NetBuilder.project(
                new NetBuilder("p")
                        .start("a")
                        .output("a", "Choose")
                        .places("run")
                        .sub("run", "child", isShared, Map.of(), Map.of())
                        .end("z")
                        .transition("t", "Chosen")
                        .in("a", "t", "relevant all")
                        .out("t", "run", "take all relevant")
                        .transition("back")
                        .in("run", "back", "proxy >= 1")
                        .out("back", "z", "take all sub")
                        .build(),
                child.build());
    }

    private static PlanQueryAnswer answer(Project project, int depth, String query) throws PlanNetTooLargeException {
        return answer(project, depth, query, ENOUGH);
    }

    private static PlanQueryAnswer answer(Project project, int depth, String query, SearchBudget budget)
            throws PlanNetTooLargeException {
        PlanNetRequest request = new PlanNetRequest(project, TestVocabulary.TEST, "p", List.of("A")).toDepth(depth);
        return new PlanQueries(PlanNet.smallest(request), budget, GraphWatch.NONE)
                .answer(new PlanQuery("q", query, PlanQuery.Expected.YES));
    }

    @Test
    void aChildThatNeverEndsKeepsItsParentOnlyWhereItIsFollowed() throws PlanNetTooLargeException {
        Project project = project("proxy >= 2");

        assertThat(answer(project, 0, "home ended").verdict()).isEqualTo(NetVerdict.YES);
        assertThat(answer(project, 1, "home ended").verdict()).isEqualTo(NetVerdict.NO);
        assertThat(answer(project, 1, "reachable ended").verdict()).isEqualTo(NetVerdict.NO);
    }

    @Test
    void aSharedChildThatNeverReturnsKeepsItsParentOnlyWhereItIsFollowed() throws PlanNetTooLargeException {
        Project project = project("proxy >= 2", true);

        assertThat(answer(project, 0, "home ended").verdict()).isEqualTo(NetVerdict.YES);
        assertThat(answer(project, 1, "home ended").verdict()).isEqualTo(NetVerdict.NO);
        assertThat(answer(project, 1, "reachable ended").verdict()).isEqualTo(NetVerdict.NO);
    }

    /** The child goes through six places, the plan alone through two. */
    @Test
    void whatTheSearchWithSubMissionsDoesNotTellThePlanAloneIsAsked() throws PlanNetTooLargeException {
        SearchBudget few = new SearchBudget(5, 64L << 20, Duration.ofMinutes(5));
        NetBuilder child = new NetBuilder("child").start("c0").end("e");
        for (int i = 0; i < 5; i++) {
            child.places("c" + (i + 1)).transition("u" + i, "Done").in("c" + i, "u" + i, "proxy >= 1");
            child.out("u" + i, "c" + (i + 1), "take all proxy");
        }
        child.transition("u", "Done").in("c5", "u", "proxy >= 1").out("u", "e", "take all proxy");

        PlanQueryAnswer answer = answer(project(child, false), 1, "home ended", few);

        assertThat(answer.verdict()).isEqualTo(NetVerdict.YES);
        assertThat(answer.words()).contains("what sub-missions do was left open");
    }

    @Test
    void aRunThroughASharedChildIsTakenOnTheEngine() throws PlanNetTooLargeException {
        PlanQueryAnswer answer = answer(project("proxy >= 1", true), 1, "reachable m(z.A) = 1");

        assertThat(answer.words()).contains("reached by 3 firings, and the engine comes there by 2 steps");
        assertThat(answer.witness().orElseThrow().words()).anyMatch(words -> words.startsWith("run / u"));
        assertThat(answer.witness().orElseThrow().steps()).isPresent();
    }

    @Test
    void aRunThroughAChildIsTakenOnTheEngine() throws PlanNetTooLargeException {
        PlanQueryAnswer answer = answer(project("proxy >= 1"), 1, "reachable m(z.A) = 1");

        assertThat(answer.words()).contains("reached by 3 firings, and the engine comes there by 2 steps");
        assertThat(answer.witness().orElseThrow().words()).anyMatch(words -> words.startsWith("run / u"));
        assertThat(answer.witness().orElseThrow().steps()).isPresent();
    }

    @Test
    void plansThatRunThemselvesAndSharedOnesThatCopyBoatsAreLeftOpenWithTheReason() throws PlanNetTooLargeException {
        Project project = NetBuilder.project(
                new NetBuilder("p")
                        .start("a")
                        .sub("a", "p")
                        .places("b")
                        .shared("b", "child")
                        .transition("t")
                        .in("a", "t", "proxy >= 1")
                        .out("t", "b", "take all proxy")
                        .build(),
                new NetBuilder("child")
                        .start("c")
                        .end("e")
                        .transition("u")
                        .in("c", "u", "proxy >= 1")
                        .out("u", "e", "add 1 proxy")
                        .build());

        PlanNet net = PlanNet.of(new PlanNetRequest(project, TestVocabulary.TEST, "p", List.of("A")).toDepth(2));

        assertThat(net.followsSubMissions()).isFalse();
        assertThat(net.abstractions().stream().map(Abstraction::text))
                .anyMatch(text -> text.endsWith("its plan runs itself"))
                .anyMatch(text -> text.endsWith("it is shared by all visits, and its plan makes copies of boats"));
    }
}
