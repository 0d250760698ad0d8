package org.sami.petri.query;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.model.ExampleNets;
import org.sami.petri.net.PetriNet;
import org.sami.petri.net.PetriNetBuilder;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.symmetry.NetSymmetry;

class QueryRunnerTest {
    private static QueryAnswer ask(PetriNet net, int states, boolean reduces, String query) throws QueryFaultException {
        return ask(net, states, new QueryMeans(reduces, Optional.empty()), query);
    }

    private static QueryAnswer ask(PetriNet net, int states, QueryMeans means, String query)
            throws QueryFaultException {
        QueryRunner runner =
                new QueryRunner(net, SearchBudget.ofStates(states), means, GraphWatch.NONE, System::nanoTime);
        return runner.answer(QueryParser.query(net, query));
    }

    private static QueryAnswer ask(PetriNet net, String query) throws QueryFaultException {
        return ask(net, 100_000, true, query);
    }

    @Test
    void whatIsReachableHasAShortestRunThatCanBeReplayed() throws QueryFaultException {
        PetriNet net = ExampleNets.philosophers(5);

        QueryAnswer answer = ask(net, "reachable m(eats0) = 1 and m(eats2) = 1");

        assertThat(answer.verdict()).isEqualTo(NetVerdict.YES);
        assertThat(answer.words()).isEqualTo("such a marking is reached by 4 firings");
        int[] reached = answer.witness().orElseThrow().replay(net);
        assertThat(QueryParser.condition(net, "m(eats0) = 1 and m(eats2) = 1").test(reached))
                .isTrue();
    }

    @Test
    void neighboursNeverEatTogether() throws QueryFaultException {
        PetriNet net = ExampleNets.philosophers(5);

        assertThat(ask(net, "invariant m(eats0) + m(eats1) <= 1").verdict()).isEqualTo(NetVerdict.YES);
        assertThat(ask(net, "reachable m(eats0) + m(eats1) = 2").verdict()).isEqualTo(NetVerdict.NO);
        assertThat(ask(net, "invariant m(eats0) + m(eats2) <= 1").verdict()).isEqualTo(NetVerdict.NO);
    }

    @Test
    void whatABoundedSearchDidNotFindIsUnknown() throws QueryFaultException {
        QueryAnswer answer =
                ask(ExampleNets.producerConsumer(0), 1000, true, "reachable m(buffer) = 1 and m(buffer) = 2");

        assertThat(answer.verdict()).isEqualTo(NetVerdict.UNKNOWN);
        assertThat(answer.words())
                .isEqualTo(
                        "such a marking was not found among 1000 states: bounded search only, as the budget of states"
                                + " was used up");
        assertThat(answer.witness()).isEmpty();
    }

    @Test
    void deadlocksAreTheSameWithAndWithoutReduction() throws QueryFaultException {
        PetriNet net = ExampleNets.philosophers(7);

        QueryAnswer reduced = ask(net, "deadlock");
        QueryAnswer plain = ask(net, 100_000, false, "deadlock");

        assertThat(reduced.verdict()).isEqualTo(NetVerdict.YES);
        assertThat(plain.verdict()).isEqualTo(NetVerdict.YES);
        assertThat(reduced.witness().orElseThrow().transitions()).hasSize(7);
        assertThat(plain.witness().orElseThrow().transitions()).hasSize(7);
        assertThat(ask(ExampleNets.kanban(2), "deadlock").verdict()).isEqualTo(NetVerdict.NO);
    }

    @Test
    void deadlockThatIsAnEndIsNone() throws QueryFaultException {
        PetriNet net = ExampleNets.agents(2);

        assertThat(ask(net, "deadlock").verdict()).isEqualTo(NetVerdict.YES);
        assertThat(ask(net, "deadlock unless m(step0.10) + m(step1.10) = 2").verdict())
                .isEqualTo(NetVerdict.NO);
        assertThat(ask(net, "deadlock unless m(step0.10) = 0")
                        .witness()
                        .orElseThrow()
                        .transitions())
                .hasSize(20);
    }

    @Test
    void homeSaysWhetherEveryRunCanStillEnd() throws QueryFaultException {
        PetriNetBuilder builder = new PetriNetBuilder("trap");
        builder.place("start", 1);
        builder.place("lost", 0);
        builder.place("end", 0);
        builder.move("finish", List.of("start"), List.of("end"));
        builder.move("lose", List.of("start"), List.of("lost"));
        builder.move("stay", List.of("lost"), List.of("lost"));
        PetriNet net = builder.build();

        QueryAnswer answer = ask(net, "home m(end) = 1");

        assertThat(answer.verdict()).isEqualTo(NetVerdict.NO);
        assertThat(answer.witness().orElseThrow().ids(net)).containsExactly("lose");
        assertThat(ask(ExampleNets.kanban(1), "home m(kanban1) = 1 and m(kanban4) = 1")
                        .verdict())
                .isEqualTo(NetVerdict.YES);
    }

    @Test
    void boundOfAPlaceHasARunThatReachesIt() throws QueryFaultException {
        PetriNet net = ExampleNets.producerConsumer(3);

        QueryAnswer answer = ask(net, "bound buffer");

        assertThat(answer.words()).isEqualTo("place buffer has at most 3 tokens");
        assertThat(answer.witness().orElseThrow().transitions()).hasSize(6);
        assertThat(ask(ExampleNets.producerConsumer(0), 1000, true, "bound buffer")
                        .verdict())
                .isEqualTo(NetVerdict.UNKNOWN);
    }

    @Test
    void symmetryIsUsedWhereAQueryDoesNotTellExchangedPartsApart() throws QueryFaultException {
        PetriNet net = ExampleNets.agents(3);
        QueryMeans means = new QueryMeans(true, Optional.of(NetSymmetry.of(net)));
        String home = "home m(step0.10) + m(step1.10) + m(step2.10) = 3";

        assertThat(ask(net, 100_000, means, home).verdict()).isEqualTo(NetVerdict.YES);
        assertThat(ask(net, 100_000, means, home).graph().states())
                .isLessThan(ask(net, home).graph().states() / 4);
        for (String query : List.of(
                "reachable m(step0.10) = 1 and m(step1.0) = 1",
                "reachable enabled(go2.5)",
                "bound step1.10",
                "deadlock unless m(step0.10) = 1",
                "invariant m(step0.5) + m(step1.5) + m(step2.5) <= 1",
                "home m(step1.0) = 1")) {
            QueryAnswer small = ask(net, 100_000, means, query);
            QueryAnswer large = ask(net, query);
            assertThat(small.verdict()).as(query).isEqualTo(large.verdict());
            assertThat(small.witness().map(run -> run.transitions().size()))
                    .as(query)
                    .isEqualTo(large.witness().map(run -> run.transitions().size()));
        }
    }

    @Test
    void mostOfASumIsFoundOnTheGraphWithARunToIt() throws QueryFaultException {
        PetriNet net = ExampleNets.philosophers(4);
        QueryRunner runner = new QueryRunner(
                net,
                SearchBudget.ofStates(10_000),
                new QueryMeans(true, Optional.empty()),
                GraphWatch.NONE,
                System::nanoTime);
        NetQuery query = QueryParser.query(net, "bound m(eats0) + m(eats1) + m(eats2) + 2*m(eats3) + 1");

        QueryAnswer answer = runner.answer(query);

        assertThat(answer.verdict()).isEqualTo(QueryAnswer.NetVerdict.YES);
        assertThat(answer.words()).isEqualTo("m(eats0) + m(eats1) + m(eats2) + 2*m(eats3) + 1 is at most 4");
        assertThat(((NetQuery.BoundOfSum) query)
                        .of(answer.witness().orElseThrow().replay(net)))
                .isEqualTo(4);
    }

    @Test
    void namesOfWhoeverMadeTheNetCountPlacesTogetherAndKnowItsEnd() throws QueryFaultException {
        PetriNet net = ExampleNets.philosophers(2);
        MarkingCondition left = QueryParser.condition(net, "m(left0) = 1 and m(left1) = 1");
        NetNames names = new NetNames() {
            @Override
            public Optional<List<Integer>> places(String name) {
                return name.equals("eat-ing.all")
                        ? Optional.of(List.of(
                                net.place("eats0").getAsInt(),
                                net.place("eats1").getAsInt()))
                        : Optional.empty();
            }

            @Override
            public Optional<List<Integer>> transitions(String name) {
                return NetNames.of(net).transitions(name);
            }

            @Override
            public Optional<MarkingCondition> end() {
                return Optional.of(left);
            }
        };
        QueryRunner runner = new QueryRunner(
                net,
                SearchBudget.ofStates(10_000),
                new QueryMeans(true, Optional.empty()),
                GraphWatch.NONE,
                System::nanoTime);

        assertThat(runner.answer(QueryParser.query(net, names, "bound eat-ing.all"))
                        .words())
                .isEqualTo("eat-ing.all is at most 1");
        assertThat(runner.answer(QueryParser.query(net, names, "invariant m(\"eat-ing\".all) <= 1"))
                        .verdict())
                .isEqualTo(QueryAnswer.NetVerdict.YES);
        assertThat(runner.answer(QueryParser.query(net, names, "reachable ended"))
                        .verdict())
                .isEqualTo(QueryAnswer.NetVerdict.YES);
        assertThat(runner.answer(QueryParser.query(net, names, "deadlock"))
                        .witness()
                        .orElseThrow()
                        .ids(net))
                .containsExactly("takeRight0", "takeRight1");
    }
}
