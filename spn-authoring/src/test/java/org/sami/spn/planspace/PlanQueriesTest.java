package org.sami.spn.planspace;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.spn.engine.Engine;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.spn.plannet.PlanNet;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.planspace.PlanQueryAnswer.Result;
import org.sami.spn.stepping.Stepper;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** What answers are worth, on plans whose runs can be counted by hand. */
class PlanQueriesTest {
    private static final SearchBudget ENOUGH = new SearchBudget(10_000, 64L << 20, Duration.ofMinutes(5));

    private static PlanNet net(NetBuilder plan, String... robots) throws PlanNetTooLargeException {
        Project project = NetBuilder.project(plan.build());
        return PlanNet.of(new PlanNetRequest(project, TestVocabulary.TEST, "p", List.of(robots)));
    }

    private static PlanQueryAnswer answer(PlanNet net, String text, PlanQuery.Expected expected) {
        return new PlanQueries(net, ENOUGH, GraphWatch.NONE).answer(new PlanQuery("q", text, expected));
    }

    private static NetBuilder asked() {
        return new NetBuilder("p")
                .start("a")
                .output("a", "ChooseSome")
                .places("c")
                .transition("t", "Chosen")
                .in("a", "t", "relevant all")
                .out("t", "c", "take all relevant");
    }

    @Test
    void runIsTakenOnTheEngineAndCanBePlayed() throws PlanNetTooLargeException {
        PlanNet net = net(asked(), "A", "B");

        PlanQueryAnswer answer = answer(net, "reachable m(c.B) = 1 and m(a.A) = 1", PlanQuery.Expected.YES);

        assertThat(answer.result()).isEqualTo(Result.EXPECTED);
        assertThat(answer.words()).contains("and the engine comes there by 1 step");
        TestCase steps = answer.witness().orElseThrow().steps().orElseThrow();
        Stepper played =
                Stepper.startAs(new Engine(TestVocabulary.TEST, net.request().project()), "p", steps);
        steps.steps().forEach(step -> assertThat(played.take(step).refusal()).isEmpty());
        assertThat(played.view()
                        .mission(played.mission())
                        .orElseThrow()
                        .marking()
                        .get("c"))
                .hasToString("[Proxy[proxy=B]]");
    }

    @Test
    void runThatOnlyTheNetHasIsSaidToBeOne() throws PlanNetTooLargeException {
        PlanNet net = net(
                new NetBuilder("p")
                        .start("a")
                        .places("c")
                        .transition("t")
                        .in("a", "t", "generic >= 1", "proxy >= 1")
                        .out("t", "c", "take 1 generic", "take 1 proxy"),
                "A",
                "B");

        PlanQueryAnswer youngest = answer(net, "reachable m(c.B) = 1", PlanQuery.Expected.YES);
        PlanQueryAnswer oldest = answer(net, "reachable m(c.A) = 1", PlanQuery.Expected.YES);

        assertThat(youngest.verdict()).isEqualTo(NetVerdict.YES);
        assertThat(youngest.witness().orElseThrow().steps()).isEmpty();
        assertThat(youngest.words()).contains("it may be so: the engine was not seen to do it");
        assertThat(youngest.result()).isEqualTo(Result.OPEN);
        assertThat(youngest.mayBe()).isTrue();
        assertThat(oldest.mayBe()).isFalse();
        assertThat(oldest.words()).contains("and the engine comes there by its start");
    }

    @Test
    void ruleThatOnlyTheNetBreaksIsNoFault() throws PlanNetTooLargeException {
        PlanNet net = net(
                new NetBuilder("p")
                        .start("a")
                        .places("c")
                        .transition("t")
                        .in("a", "t", "generic >= 1", "proxy >= 1")
                        .out("t", "c", "take 1 generic", "take 1 proxy"),
                "A",
                "B");

        PlanQueryAnswer onlyTheNet = answer(net, "invariant m(c.B) = 0", PlanQuery.Expected.YES);
        PlanQueryAnswer thePlanToo = answer(net, "invariant m(c.A) = 0", PlanQuery.Expected.YES);

        assertThat(onlyTheNet.isFault()).isFalse();
        assertThat(onlyTheNet.mayBe()).isTrue();
        assertThat(thePlanToo.isFault()).isTrue();
        assertThat(thePlanToo.result()).isEqualTo(Result.UNEXPECTED);
    }

    @Test
    void noDeadlockHoldsWhereWhatIsWaitedForComes() throws PlanNetTooLargeException {
        NetBuilder ends =
                asked().end("b").transition("u").in("c", "u", "proxy >= 1").out("u", "b", "take all proxy");

        PlanQueryAnswer deadlock = answer(net(ends, "A"), "deadlock", PlanQuery.Expected.NO);
        PlanQueryAnswer stuck = answer(net(asked(), "A"), "deadlock", PlanQuery.Expected.NO);

        assertThat(deadlock.result()).isEqualTo(Result.EXPECTED);
        assertThat(deadlock.words()).isEqualTo("no: proved by state equation, if what is waited for comes");
        assertThat(stuck.result()).isEqualTo(Result.UNEXPECTED);
        assertThat(stuck.isFault()).isTrue();
        assertThat(stuck.words()).contains("and the engine comes there by 1 step");
    }

    @Test
    void faultOfAQueryIsNamedBeforeItIsAsked() throws PlanNetTooLargeException {
        PlanQueries queries = new PlanQueries(net(asked(), "A"), ENOUGH, GraphWatch.NONE);

        assertThat(queries.fault("reachable m(c) >= 1")).isEmpty();
        assertThat(queries.fault("reachable m(d) >= 1").orElseThrow()).contains("column 13", "'d'");
    }

    @Test
    void netThatCountsRobotsAnswersWithTheirNames() throws PlanNetTooLargeException {
        PlanNet counted = PlanNet.smallest(net(asked(), "A", "B", "C").request());

        PlanQueryAnswer one = answer(counted, "reachable m(c.robots) = 1 and m(a.robots) = 2", PlanQuery.Expected.YES);
        PlanQueryAnswer byName = answer(counted, "reachable m(c.B) = 1 and m(a.A) = 1", PlanQuery.Expected.YES);

        assertThat(counted.isCounted()).isTrue();
        assertThat(one.words()).contains("and the engine comes there by 1 step");
        assertThat(one.run().get(0).named()).containsExactly("A");
        assertThat(one.witness().orElseThrow().end().words()).isEqualTo("a: B C generic; c: A");
        assertThat(byName.words()).contains("and the engine comes there by 1 step");
        assertThat(byName.run().get(0).named()).contains("B").doesNotContain("A");
    }

    @Test
    void robotThatIsAddedToASecondPlaceIsDuplicatedAndOneThatIsTakenIsNot() throws PlanNetTooLargeException {
        NetBuilder added = new NetBuilder("p")
                .start("a")
                .output("a", "ChooseSome")
                .places("c")
                .transition("t", "Chosen")
                .in("a", "t", "relevant all")
                .out("t", "c", "add all relevant");

        PlanQueryAnswer moved = answer(
                PlanNet.smallest(net(asked(), "A", "B").request()), "reachable duplicated", PlanQuery.Expected.NO);
        PlanQueryAnswer copied =
                answer(PlanNet.smallest(net(added, "A", "B").request()), "reachable duplicated", PlanQuery.Expected.NO);

        assertThat(moved.result()).isEqualTo(Result.EXPECTED);
        assertThat(copied.result()).isEqualTo(Result.UNEXPECTED);
        assertThat(copied.words()).contains("and the engine comes there by 1 step");
    }

    @Test
    void tokensThatGatherAreNotCounted() throws PlanNetTooLargeException {
        NetBuilder gathers = asked().places("kept")
                .end("b")
                .transition("again", "Chosen")
                .in("a", "again", "relevant all")
                .out("again", "a", "take all relevant")
                .out("again", "kept", "add 1 generic")
                .transition("u")
                .in("a", "u", "proxy = 0")
                .out("u", "b", "take all proxy");
        PlanNet net = net(gathers, "A");

        PlanQueryAnswer home = answer(net, "home ended", PlanQuery.Expected.YES);
        PlanQueries queries = new PlanQueries(net, ENOUGH, GraphWatch.NONE);

        assertThat(home.result()).isEqualTo(Result.EXPECTED);
        assertThat(home.words()).contains("however many tokens are in kept.generic");
        assertThat(queries.whole().gathering()).containsExactly("kept");
        assertThat(queries.whole().graph().isComplete()).isTrue();
    }

    @Test
    void wayHomeThatOnlyTheEngineHasIsNotDeniedForCertain() throws PlanNetTooLargeException {
        NetBuilder plan = new NetBuilder("p")
                .start("s")
                .places("a", "d")
                .end("e")
                .transition("t1")
                .in("s", "t1", "generic >= 1")
                .out("t1", "a", "take 1 generic", "add 5 generic")
                .transition("t2")
                .in("a", "t2", "generic >= 5")
                .out("t2", "d", "take all generic")
                .transition("t3")
                .in("d", "t3", "generic >= 1")
                .in("a", "t3", "generic = 0")
                .out("t3", "e", "take all generic");

        PlanQueryAnswer home = answer(net(plan, "A"), "home ended", PlanQuery.Expected.YES);

        assertThat(home.verdict()).isEqualTo(NetVerdict.NO);
        assertThat(home.result()).isEqualTo(Result.OPEN);
        assertThat(home.isFault()).isFalse();
        assertThat(home.words()).contains("no proof, as more tokens gather in a place than the search follows");
    }
}
