package org.sami.spn.naming;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TestStep;
import org.sami.spn.stepping.StepText;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** What elements are called in sentences, and the steps of runs that speak of them. */
class ElementNamesTest {
    private static final Vocabulary WORDS = new Vocabulary(
            "test",
            List.of(),
            List.of(
                    event("GoThere", Direction.OUTPUT, "Go There", "WasThere"),
                    event("WasThere", Direction.INPUT, "Was There")),
            List.of(),
            List.of());

    private static EventType event(String name, Direction direction, String label, String... answers) {
        return new EventType(
                name,
                List.of(),
                direction,
                List.of(),
                TokenNeed.PROXY,
                List.of(answers),
                EventRole.NONE,
                Set.of(),
                Optional.empty(),
                label,
                "");
    }

    private static Plan plan() {
        Plan plan = new NetBuilder("trip")
                .start("p0")
                .places("p1")
                .output("p1", "GoThere")
                .end("p2")
                .transition("t0")
                .in("p0", "t0", "any >= 1")
                .out("t0", "p1", "take all any")
                .transition("t1", "WasThere")
                .in("p1", "t1", "any >= 1")
                .out("t1", "p2", "take all any")
                .build();
        return plan.withPlaces(plan.places().stream().map(p -> p.withName("")).toList())
                .withTransitions(
                        plan.transitions().stream().map(t -> t.withName("")).toList());
    }

    private static Plan named() {
        Plan plan = plan();
        return plan.withPlaces(
                plan.places().stream().map(p -> p.withName("Way " + p.id())).toList());
    }

    @Test
    void vertexIsCalledAsItsAuthorDoes() {
        ElementNames names = new ElementNames(named(), WORDS);

        assertThat(names.of("p1")).contains("Way p1");
        assertThat(names.withKind(named().place("p1").orElseThrow())).isEqualTo("place \"Way p1\"");
    }

    @Test
    void vertexWithoutNameIsCalledByWhatItDoesInTheWordsOfTheVocabulary() {
        ElementNames names = new ElementNames(plan(), WORDS);

        assertThat(names.of("p1")).contains("Go There");
        assertThat(names.of("t1")).contains("Was There");
        assertThat(names.withKind(plan().place("p1").orElseThrow())).isEqualTo("place of Go There");
        assertThat(names.withKind(plan().transition("t1").orElseThrow())).isEqualTo("transition of Was There");
    }

    @Test
    void vertexThatDoesNothingIsCalledByItsKindAndNumber() {
        ElementNames names = new ElementNames(plan(), WORDS);

        assertThat(names.of("p2")).contains("place 3");
        assertThat(names.of("t0")).contains("transition 1");
        assertThat(names.withKind(plan().place("p2").orElseThrow())).isEqualTo("place 3");
        assertThat(names.of(plan().inEdges().get(0).id())).contains("place 1 → transition 1");
    }

    @Test
    void eventIsCalledByItsTitleAndItsVertexWhereThatHasAName() {
        String event = plan().place("p1").orElseThrow().outputs().get(0).id();

        assertThat(new ElementNames(plan(), WORDS).of(event)).contains("Go There");
        assertThat(new ElementNames(named(), WORDS).of(event)).contains("Go There at Way p1");
        assertThat(new ElementNames(plan(), WORDS).of("nowhere")).isEmpty();
    }

    @Test
    void stepOfARunSpeaksOfEventsByTitleAndOfVerticesByName() {
        String event = plan().place("p1").orElseThrow().outputs().get(0).id();
        TestStep answer = new TestStep.Occur("WasThere", event, List.of("robot-1"), List.of(), Map.of());

        assertThat(StepText.of(NetBuilder.project(plan()), "trip", WORDS).of(answer))
                .isEqualTo("Was There of robot-1, answering Go There");
        assertThat(StepText.of(NetBuilder.project(named()), "trip", WORDS).of(answer))
                .isEqualTo("Was There of robot-1, answering Go There at Way p1");
        assertThat(StepText.of(NetBuilder.project(plan()), "trip", WORDS)
                        .of(new TestStep.ExpectTokens("p2", 1, List.of(), List.of())))
                .isEqualTo("expect tokens in place 3");
    }

    @Test
    void stepInASubMissionIsCalledByWhatThatPlanHas() {
        String event = plan().place("p1").orElseThrow().outputs().get(0).id();
        Plan parent = new NetBuilder("parent")
                .start("p1")
                .sub("p1", "trip")
                .end("over")
                .build();
        TestStep answer = new TestStep.Occur("WasThere", event, List.of(), List.of("look"), Map.of());

        assertThat(StepText.of(NetBuilder.project(parent, named()), "parent", WORDS)
                        .of(answer))
                .isEqualTo("Was There of look, answering Go There at Way p1");
    }
}
