package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.message.OperatorMessage;
import org.sami.crw.service.Geodesy;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;

/** Pictures all round, on a real boat server with a hull that turns. */
class PanoramaTest {
    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);
    private final TestHull hull = world.addBoat("a", 0, 0, TestHull::photographs);

    @Test
    void theBoatTurnsAllRoundWhereItIsAndThenAnswersOnce() {
        world.run(1);
        happens(new TestActivations("TakePanorama").of("a"));
        world.run(60);

        assertThat(hull.pictures()).hasSize(8);
        assertThat(hull.pictures().stream().map(rad -> Math.floorMod(Math.round(rad / (Math.PI / 4)), 8L)))
                .containsExactlyInAnyOrder(0L, 1L, 2L, 3L, 4L, 5L, 6L, 7L);
        assertThat(hull.isAtRest()).isTrue();
        assertThat(taken()).singleElement().satisfies(answer -> {
            assertThat(answer.proxies()).containsExactly("a");
            assertThat(answer.values()).containsEntry("pictures", new IntegerValue(8));
            assertThat(Geodesy.distanceM((GeoPoint) answer.values().get("location"), TestWorld.HOME))
                    .isLessThan(1);
        });
    }

    @Test
    void aTaskIsNamedInTheAnswer() {
        world.run(1);
        happens(new TestActivations("TakePanorama").task("t1", "a", "note", new TextValue("")));
        world.run(60);

        assertThat(taken()).extracting(Occurrence::tasks).containsExactly(List.of(new TaskId(1, "t1")));
    }

    @Test
    void aBoatWithoutACameraIsNamedToTheOperator() {
        world.addBoat("b", 5, 0);
        world.run(1);
        happens(new TestActivations("TakePanorama").of("b"));
        world.run(5);

        assertThat(taken()).isEmpty();
        assertThat(world.operator.messages().messages())
                .extracting(OperatorMessage::text)
                .anyMatch(text -> text.startsWith("b could not do what \"here\" asked") && text.contains("no camera"));
    }

    @Test
    void whatIsTakenBackStopsTheTurn() {
        world.run(1);
        happens(new TestActivations("TakePanorama").of("a"));
        world.run(2);
        world.happens(engine, new Effect.CommandsWithdrawn(1, List.of()));
        world.run(60);

        assertThat(hull.isAtRest()).isTrue();
        assertThat(hull.pictures().size()).isLessThan(8);
        assertThat(taken()).isEmpty();
    }

    @Test
    void afterALostLinkThePicturesAreTakenAnewAndAnsweredOnce() {
        world.run(1);
        happens(new TestActivations("TakePanorama").of("a"));
        world.run(2);
        world.cutLinks(true);
        world.run(60);
        assertThat(taken()).isEmpty();
        world.cutLinks(false);
        world.run(60);

        assertThat(taken()).hasSize(1);
    }

    private void happens(TestActivations asking) {
        world.happens(engine, asking.effect());
    }

    private List<Occurrence> taken() {
        return engine.received("PanoramaTaken");
    }
}
