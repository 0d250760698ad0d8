package org.sami.spn.plannet;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.spn.model.PlanQuery;
import org.sami.spn.planspace.PlanQueries;
import org.sami.spn.planspace.PlanQueryAnswer;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** Which nets plans get that add robots to further places. */
class CopiedRobotsTest {
    private static final SearchBudget ENOUGH = new SearchBudget(10_000, 64L << 20, Duration.ofMinutes(15));

    /** All go to work, and are on the list of those under way as long as they work. */
    private static NetBuilder listed() {
        return new NetBuilder("p")
                .start("a")
                .places("work", "list", "done", "twice")
                .transition("go", "News")
                .in("a", "go", "relevant all")
                .out("go", "work", "take all relevant")
                .out("go", "list", "add all relevant");
    }

    private static NetBuilder arriving(String... moves) {
        NetBuilder net = listed().transition("arrive", "Done").in("work", "arrive", "relevant all");
        return net.in("list", "arrive", "always").out("arrive", "done", moves);
    }

    private static PlanNet smallest(NetBuilder plan) throws PlanNetTooLargeException {
        return PlanNet.smallest(
                new PlanNetRequest(NetBuilder.project(plan.build()), TestVocabulary.TEST, "p", List.of("A", "B", "C")));
    }

    private static PlanQueryAnswer answer(PlanNet net, String query) {
        return new PlanQueries(net, ENOUGH, GraphWatch.NONE)
                .answer(new PlanQuery(query, query, PlanQuery.Expected.YES));
    }

    @Test
    void whoIsInSeveralPlacesOnceIsCounted() throws PlanNetTooLargeException {
        PlanNet net = smallest(arriving("take 1 relevant", "consume all relevant"));

        PlanQueryAnswer both = answer(net, "reachable m(done.robots) = 1 and m(list.robots) = 2");
        PlanQueryAnswer moreOnTheList = answer(net, "invariant m(work.robots) = m(list.robots)");

        assertThat(net.isCounted()).isTrue();
        assertThat(both.verdict()).isEqualTo(NetVerdict.YES);
        assertThat(moreOnTheList.verdict()).isEqualTo(NetVerdict.YES);
    }

    @Test
    void whoMayComeToAPlaceTwiceIsNotCounted() throws PlanNetTooLargeException {
        PlanNet bothOfOne = smallest(arriving("take 2 relevant", "consume all relevant"));
        PlanNet oneOfBoth = smallest(arriving("take 1 relevant"));
        PlanNet fromBoth = smallest(arriving("take all relevant"));

        assertThat(bothOfOne.isPresent()).isTrue();
        assertThat(oneOfBoth.isPresent()).isTrue();
        assertThat(fromBoth.isPresent()).isTrue();
    }

    @Test
    void netThatFollowsWhetherRobotsAreThereAsksTheNetWithNamesForTheRest() throws PlanNetTooLargeException {
        PlanNet net = smallest(arriving("take all relevant"));

        PlanQueryAnswer never = answer(net, "invariant m(twice.robots) = 0");
        PlanQueryAnswer apart = answer(net, "reachable m(work.robots) >= 1 and m(list.robots) = 0");
        PlanQueryAnswer happens = answer(net, "reachable m(done.robots) >= 1");
        PlanQueryAnswer two = answer(net, "reachable m(done.robots) >= 2");
        PlanQueryAnswer byName = answer(net, "reachable m(done.B) = 1 and m(done.A) = 0");

        assertThat(net.presence().cardinality()).isEqualTo(4);
        assertThat(net.hasNames()).isFalse();
        assertThat(never.verdict()).isEqualTo(NetVerdict.YES);
        assertThat(apart.verdict()).isEqualTo(NetVerdict.NO);
        assertThat(happens.witness()).isPresent();
        assertThat(two.verdict()).isEqualTo(NetVerdict.YES);
        assertThat(byName.verdict()).isEqualTo(NetVerdict.YES);
    }

    @Test
    void tooManyRobotsToShareTheInPlacesAreRefusedAtOnce() {
        NetBuilder net = listed().transition("gather", "Done");
        for (String place : List.of("work", "list", "done", "twice")) {
            net.in(place, "gather", "always");
        }
        net.out("gather", "work", "take all relevant").out("gather", "twice", "add all proxy");
        net.out("gather", "done", "add all relevant");
        List<String> many = IntStream.rangeClosed(1, 12).mapToObj(i -> "R" + i).toList();
        PlanNetRequest request = new PlanNetRequest(NetBuilder.project(net.build()), TestVocabulary.TEST, "p", many);

        assertThatThrownBy(() -> PlanNet.present(request))
                .isInstanceOf(PlanNetTooLargeException.class)
                .hasMessageContaining("12 robots can share 8 sets of in places");
    }
}
