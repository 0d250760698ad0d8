package org.sami.spn.planspace;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.sami.petri.graph.GraphWatch;
import org.sami.petri.graph.SearchBudget;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Project;
import org.sami.spn.plannet.PlanNetRequest;
import org.sami.spn.plannet.PlanNetTooLargeException;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.testing.TestVocabulary;

/** Bounds of places, on plans in which they can be counted by hand. */
class PlanBoundsTest {
    private static final SearchBudget ENOUGH = new SearchBudget(10_000, 64L << 20, Duration.ofMinutes(5));

    private static PlanBounds bounds(NetBuilder plan, String... robots) throws PlanNetTooLargeException {
        Project project = NetBuilder.project(plan.build());
        return PlanBounds.of(
                new PlanNetRequest(project, TestVocabulary.TEST, "p", List.of(robots)), ENOUGH, GraphWatch.NONE);
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
    void boundOfAPlaceIsThatOfTheTeamWhereAllCanBeThere() throws PlanNetTooLargeException {
        PlanBounds bounds = bounds(asked(), "A", "B", "C");

        PlaceBound place = bounds.of("c").orElseThrow();
        assertThat(place.most()).isEqualTo(OptionalInt.of(3));
        assertThat(place.sign()).isEqualTo("≤ 3");
        assertThat(place.words()).startsWith("at most 3 of 3 robots: ");
        assertThat(bounds.of("a").orElseThrow().words()).contains("at most 1 generic token");
        assertThat(bounds.summary()).startsWith("bounds of all ");
    }

    @Test
    void placeThatLetsInOneAtATimeIsANoteWithItsBound() throws PlanNetTooLargeException {
        NetBuilder gate = asked().places("gate")
                .transition("enter")
                .in("c", "enter", "proxy >= 1")
                .in("gate", "enter", "proxy = 0")
                .out("enter", "gate", "take 1 proxy");

        PlanBounds bounds = bounds(gate, "A", "B");

        List<Finding> notes = BoundNotes.of(bounds, gate.build(), TestVocabulary.TEST);
        assertThat(notes).singleElement().satisfies(note -> {
            assertThat(note.code()).isEqualTo("N-BOUND");
            assertThat(note.elements()).contains("gate");
            assertThat(note.message()).startsWith("At most 1 of 2 robots can be in ");
        });
    }

    @Test
    void invariantNamesThePlacesThatLimitAnother() throws PlanNetTooLargeException {
        TokenBound robots = bounds(asked(), "A", "B").of("c").orElseThrow().kinds().stream()
                .filter(bound -> bound.kind() == TokenBound.Kind.ROBOT)
                .findFirst()
                .orElseThrow();

        assertThat(robots.reason()).isEqualTo("a (robots) + c (robots) is always 2");
        assertThat(robots.limitedBy()).containsExactly("a");
    }
}
