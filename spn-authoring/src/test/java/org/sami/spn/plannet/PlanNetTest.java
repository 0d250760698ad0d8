package org.sami.spn.plannet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.ReachabilityGraph;
import org.sami.petri.graph.ReachabilitySearch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.graph.SearchSettings;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** The reductions of thesis 4.1, each on a plan whose markings can be counted by hand. */
class PlanNetTest {
    private static PlanNet net(NetBuilder plan, String... robots) throws PlanNetTooLargeException {
        return PlanNet.of(new PlanNetRequest(
                NetBuilder.project(plan.build()), TestVocabulary.TEST, "p", List.of(robots), 2, 5000));
    }

    private static Set<String> markings(PlanNet plan) {
        ReachabilityGraph graph = ReachabilitySearch.explore(
                plan.net(), SearchSettings.within(new SearchBudget(10_000, 64L << 20, Duration.ofMinutes(5))));
        assertThat(graph.isComplete()).isTrue();
        Set<String> words = new TreeSet<>();
        for (int state = 0; state < graph.states(); state++) {
            words.add(plan.marking(graph.marking(state)).words());
        }
        return words;
    }

    /** Figure 4.8. */
    @Test
    void takeMovesATokenFromItsPlace() throws PlanNetTooLargeException {
        PlanNet plan = net(
                new NetBuilder("p")
                        .start("a")
                        .places("b")
                        .transition("t")
                        .in("a", "t", "generic >= 1")
                        .out("t", "b", "take 1 generic"),
                "A");

        assertThat(markings(plan)).containsExactly("a: A generic", "a: A; b: generic");
        assertThat(plan.abstractions()).isEmpty();
    }

    /** Figure 4.4. */
    @Test
    void consumeRemovesAToken() throws PlanNetTooLargeException {
        PlanNet plan = net(new NetBuilder("p")
                .start("a")
                .places("b")
                .transition("t")
                .in("a", "t", "generic >= 1")
                .out("t", "b", "consume 1 generic", "always"));

        assertThat(markings(plan)).containsExactly("a: generic", "no token anywhere");
    }

    /** Figure 4.6. */
    @Test
    void addLeavesTheTokenWhereItIs() throws PlanNetTooLargeException {
        PlanNet plan = net(new NetBuilder("p")
                .start("a")
                .places("b")
                .transition("t")
                .in("a", "t", "generic >= 1")
                .out("t", "b", "add 1 generic"));

        assertThat(markings(plan)).containsExactly("a: generic", "a: generic; b: generic");
    }

    /** Figure 4.5: what no in edge asks for is taken where it is there, and the transition fires without it where it is not. */
    @Test
    void whatIsNotAskedForIsTakenWhereItIsThere() throws PlanNetTooLargeException {
        NetBuilder drawn = new NetBuilder("p")
                .start("a")
                .places("b")
                .transition("t")
                .in("a", "t", "generic >= 1")
                .out("t", "b", "consume all generic", "take all proxy");

        assertThat(markings(net(drawn, "A", "B"))).containsExactly("a: A B generic", "b: A B");
        assertThat(markings(net(drawn))).containsExactly("a: generic", "no token anywhere");
    }

    /** Section 4.1.4: relevant tokens are any of those that an answer may name. */
    @Test
    void anAnswerNamesAnyOfTheRobots() throws PlanNetTooLargeException {
        PlanNet plan = net(
                new NetBuilder("p")
                        .start("a")
                        .output("a", "Do")
                        .end("b")
                        .places("c")
                        .transition("t", "Done")
                        .in("a", "t", "relevant all")
                        .out("t", "c", "take all relevant")
                        .transition("u")
                        .in("c", "u", "proxy == 2")
                        .out("u", "b", "take all proxy"),
                "A",
                "B");

        assertThat(markings(plan))
                .containsExactly(
                        "a: A B generic",
                        "a: A generic; c: B",
                        "a: B generic; c: A",
                        "a: generic; b: A B",
                        "a: generic; c: A B");
        assertThat(plan.abstractions()).isNotEmpty();
    }

    /** The engine looks at transitions in one order, the net lets them fire in any. */
    @Test
    void orderOfTransitionsThatFireAtOnceIsLeftOpen() throws PlanNetTooLargeException {
        PlanNet plan = net(new NetBuilder("p")
                .start("a")
                .places("b", "c")
                .transition("t")
                .in("a", "t", "generic >= 1")
                .out("t", "b", "take 1 generic")
                .transition("u")
                .in("a", "u", "generic >= 1")
                .out("u", "c", "take 1 generic"));

        assertThat(markings(plan)).containsExactly("a: generic", "b: generic", "c: generic");
        assertThat(plan.abstractions()).extracting(Abstraction::where).containsExactly("t", "u");
    }

    @Test
    void aRunReadsAsFiringsOfThePlan() throws PlanNetTooLargeException {
        PlanNet plan = net(
                new NetBuilder("p")
                        .start("a")
                        .places("c")
                        .transition("t", "Done")
                        .in("a", "t", "relevant all")
                        .out("t", "c", "take all relevant"),
                "A",
                "B");

        ReachabilityGraph graph = ReachabilitySearch.explore(
                plan.net(),
                SearchSettings.within(new SearchBudget(100, 1 << 20, Duration.ofMinutes(5)))
                        .withGoal(marking -> marking[plan.net().place("c.B").getAsInt()] > 0
                                && marking[plan.net().place("a.A").getAsInt()] > 0));

        assertThat(plan.run(graph.runTo(graph.found().getAsInt())).firings())
                .extracting(PlanNetFiring::words)
                .containsExactly("t(B): B a → c");
    }

    @Test
    void aNetThatIsTooLargeNamesWhatMakesItSo() {
        NetBuilder drawn = new NetBuilder("p")
                .start("a")
                .places("c")
                .transition("t", "Done")
                .in("a", "t", "relevant all")
                .out("t", "c", "take all relevant");

        String[] robots = new String[13];
        for (int i = 0; i < robots.length; i++) {
            robots[i] = "r" + i;
        }
        assertThatThrownBy(() -> net(drawn, robots))
                .isInstanceOf(PlanNetTooLargeException.class)
                .hasMessageContaining("with 13 robots")
                .hasMessageContaining("\"t\" alone has");
    }

    @Test
    void aRobotThatIsNamedTwiceIsRefusedByName() {
        NetBuilder plan = new NetBuilder("p").start("a");

        assertThatThrownBy(() -> net(plan, "A", "B", "A"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("\"A\"");
    }
}
