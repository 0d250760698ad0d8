package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.sami.crw.handler.EventCatalogue.Seen;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.TextValue;

/** Timers, tokens, interrupts, returns, and how missions end. */
final class MissionEventCases {
    private static final GeoPoint FAR = PlanScene.at(300, 0);
    private static final TextValue STOP = new TextValue("Stop");
    private static final long CHILD = 2;

    private MissionEventCases() {}

    static void add(EventCatalogue catalogue) {
        timers(catalogue);
        tokens(catalogue);
        interrupts(catalogue);
        returns(catalogue);
        ends(catalogue);
    }

    private static void timers(EventCatalogue catalogue) {
        catalogue.shows(
                "StartSystemTimer",
                Seen.IN_THE_MARKING,
                "nothing moves before the time is up, and what waits for it moves then",
                MissionEventCases::systemTimer);
        catalogue.shows(
                "TimerExpired",
                Seen.IN_THE_MARKING,
                "one timer for all: it expires once",
                MissionEventCases::systemTimer);
        catalogue.shows(
                "StartProxyTimer", Seen.IN_THE_MARKING, "the timer of a boat that left before has stopped", () -> {
                    PlanScene scene = new PlanScene(
                            new PlanSketch()
                                    .asks("wait", "StartProxyTimer", "duration", seconds(10))
                                    .on("wait", "ProxyTimerExpired", "late")
                                    .on("wait", "OperatorInterruptReceived", "left", "relevant", "interruptName", STOP),
                            2);
                    scene.press("Stop", "boat-1");
                    scene.untilBoat("boat-2", "late");
                    assertThat(scene.marking(PlanScene.MISSION, "left")).containsExactly(PlanScene.boat("boat-1"));
                    scene.run(15);
                    assertThat(scene.used("ProxyTimerExpired")).hasSize(1);
                });
        catalogue.shows(
                "ProxyTimerExpired",
                Seen.IN_THE_MARKING,
                "each boat moves on when its own time is up, counted from its own entry",
                () -> {
                    PlanScene scene = new PlanScene(
                            new PlanSketch()
                                    .asks("ask", "OperatorSelectBoat")
                                    .on("ask", "OperatorSelectsBoat", "wait")
                                    .asks("wait", "StartProxyTimer", "duration", seconds(10))
                                    .asks("wait", "GetAllProxyTokens")
                                    .on("wait", "ProxyTimerExpired", "late"),
                            2);
                    scene.answer(new Answer.Proxies(List.of("boat-2")));
                    scene.run(9);
                    assertThat(scene.stands(PlanScene.boat("boat-2"), "wait")).isTrue();
                    scene.run(1.5);
                    assertThat(scene.stands(PlanScene.boat("boat-2"), "late")).isTrue();
                    assertThat(scene.used("ProxyTimerExpired").get(0).proxies()).containsExactly("boat-2");
                });
    }

    private static void systemTimer() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("wait", "StartSystemTimer", "duration", seconds(10))
                        .on("wait", "TimerExpired", "over"),
                2);
        scene.run(9);
        assertThat(scene.marking(PlanScene.MISSION, "over")).isEmpty();
        scene.run(1.5);
        scene.untilGeneric("over");
        assertThat(scene.used("TimerExpired")).hasSize(1);
    }

    private static void tokens(EventCatalogue catalogue) {
        catalogue.shows(
                "GetAllProxyTokens",
                Seen.IN_THE_MARKING,
                "a boat that joined after the mission had started is in the mission",
                MissionEventCases::allTokens);
        catalogue.shows(
                "TokensReturned",
                Seen.IN_THE_MARKING,
                "the answer names every boat that is known now",
                MissionEventCases::allTokens);
    }

    private static void allTokens() {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("wait", "StartSystemTimer", "duration", seconds(20))
                        .on("wait", "TimerExpired", "ask")
                        .asks("ask", "GetAllProxyTokens")
                        .joining("ask", "TokensReturned", "team"),
                1);
        scene.world.addBoat("late", 20, 0);
        scene.run(10);
        assertThat(scene.marking(PlanScene.MISSION, "wait")).doesNotContain(PlanScene.boat("late"));
        scene.untilBoat("late", "team");
        assertThat(scene.stands(PlanScene.boat("boat-1"), "team")).isTrue();
        assertThat(scene.used("TokensReturned").get(0).proxies()).containsExactly("boat-1", "late");
    }

    private static void interrupts(EventCatalogue catalogue) {
        catalogue.shows(
                "OperatorInterruptReceived",
                Seen.IN_THE_MARKING,
                "the button of that name takes its boats out; a press by another name is refused",
                () -> {
                    PlanScene scene = new PlanScene(
                            new PlanSketch()
                                    .asks("go", "ProxyGotoLatLon", "location", FAR)
                                    .on("go", "OperatorInterruptReceived", "out", "relevant", "interruptName", STOP),
                            2);
                    scene.press("Halt", "boat-1");
                    assertThat(scene.notes()).anyMatch(note -> note.contains("Halt"));
                    scene.press("Stop", "boat-1");
                    assertThat(scene.marking(PlanScene.MISSION, "out")).containsExactly(PlanScene.boat("boat-1"));
                });
        catalogue.shows(
                "GeneralInterrupt", Seen.AS_A_DECISION, "the button is offered while somebody stands there", () -> {
                    PlanScene scene = general();
                    assertThat(scene.buttons()).containsExactly("Stop");
                    scene.press("Stop");
                    assertThat(scene.buttons()).isEmpty();
                });
        catalogue.shows(
                "GeneralInterruptReceived", Seen.ON_A_BOAT, "the whole team leaves what it did, and stops", () -> {
                    PlanScene scene = general();
                    scene.run(5);
                    assertThat(scene.world.hull("boat-1").isAtRest()).isFalse();
                    scene.press("Stop");
                    scene.untilBoat("boat-1", "out").untilBoat("boat-2", "out");
                    scene.run(5);
                    assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
                });
        catalogue.shows(
                "ProxyInterrupt",
                Seen.AS_A_DECISION,
                "a press that names nobody asks for which of the standing boats it is",
                () -> {
                    PlanScene scene = proxyInterrupt();
                    scene.press("Stop");
                    Question question = scene.decision().question();
                    assertThat(((Question.ChooseProxies) question).proxies()).containsExactly("boat-1", "boat-2");
                });
        catalogue.shows(
                "ProxyInterruptReceived",
                Seen.IN_THE_MARKING,
                "the chosen boat is taken out, the other goes on",
                () -> {
                    PlanScene scene = proxyInterrupt();
                    scene.press("Stop");
                    scene.answer(new Answer.Proxies(List.of("boat-2")));
                    scene.untilBoat("boat-2", "out");
                    assertThat(scene.stands(PlanScene.boat("boat-1"), "go")).isTrue();
                });
    }

    private static PlanScene general() {
        return new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyGotoLatLon", "location", FAR)
                        .asks("go", "GeneralInterrupt", "interruptName", STOP)
                        .on("go", "GeneralInterruptReceived", "out", "any-token"),
                2);
    }

    /** As in the thesis, 7.0.2: the button's place is another than that of the boats that it takes. */
    private static PlanScene proxyInterrupt() {
        return new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyGotoLatLon", "location", FAR)
                        .on("go", "", "button", "generic")
                        .asks("button", "ProxyInterrupt", "interruptName", STOP)
                        .on("go", "ProxyInterruptReceived", "out")
                        .alsoFrom("button"),
                2);
    }

    private static void returns(EventCatalogue catalogue) {
        catalogue.shows(
                "ReturnValue", Seen.IN_THE_MARKING, "what the sub-mission sets last is what its parent hears", () -> {
                    PlanScene scene = returning("first", "done");
                    scene.untilBoat("boat-1", "well");
                });
        catalogue.shows(
                "CheckReturn",
                Seen.IN_THE_MARKING,
                "only the transition that waits for the returned value fires",
                () -> {
                    PlanScene scene = returning("done", "failed");
                    scene.untilBoat("boat-1", "badly");
                    assertThat(scene.marking(PlanScene.MISSION, "well")).isEmpty();
                });
        catalogue.shows(
                "SubMissionAborted",
                Seen.IN_THE_MARKING,
                "those who had started in the aborted sub-mission move on in its parent",
                () -> {
                    PlanScene scene = new PlanScene(
                            new PlanSketch()
                                    .runs("sub", "child")
                                    .on("sub", "SubMissionAborted", "rescued")
                                    .plan("child")
                                    .asks("go", "ProxyGotoLatLon", "location", FAR)
                                    .end("over")
                                    .on("go", "ProxyPathCompleted", "over"),
                            1);
                    scene.post(new Input.AbortMission(CHILD));
                    scene.untilBoat("boat-1", "rescued");
                    assertThat(scene.outcome(CHILD)).isEqualTo(Outcome.ABORTED);
                });
    }

    /** A sub-mission that sets one value, then another, and ends. */
    private static PlanScene returning(String first, String second) {
        return new PlanScene(
                new PlanSketch()
                        .runs("sub", "child")
                        .on("sub", "CheckReturn", "well", "any-token", "value", new TextValue("done"))
                        .on("sub", "CheckReturn", "badly", "any-token", "value", new TextValue("failed"))
                        .plan("child")
                        .asks("one", "ReturnValue", "value", new TextValue(first))
                        .on("one", "", "two", "any-token")
                        .asks("two", "ReturnValue", "value", new TextValue(second))
                        .end("over")
                        .on("two", "", "over", "any-token"),
                1);
    }

    private static void ends(EventCatalogue catalogue) {
        catalogue.shows("AbortMission", Seen.ON_A_BOAT, "the mission ends as aborted and its boat stops", () -> {
            PlanScene scene = stopped("AbortMission");
            assertThat(scene.outcome(PlanScene.MISSION)).isEqualTo(Outcome.ABORTED);
            scene.run(5);
            assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
        });
        catalogue.shows("CompleteMission", Seen.ON_A_BOAT, "the mission ends as completed and its boat stops", () -> {
            PlanScene scene = stopped("CompleteMission");
            assertThat(scene.outcome(PlanScene.MISSION)).isEqualTo(Outcome.COMPLETED);
            scene.run(5);
            assertThat(scene.world.hull("boat-1").isAtRest()).isTrue();
        });
        catalogue.shows(
                "AbortMissionReceived",
                Seen.IN_THE_MARKING,
                "an abort is taken by the plan, and the mission goes on",
                () -> {
                    PlanScene scene = intercepting("AbortMissionReceived");
                    scene.post(new Input.AbortMission(PlanScene.MISSION));
                    scene.untilBoat("boat-1", "after");
                });
        catalogue.shows(
                "CompleteMissionReceived",
                Seen.IN_THE_MARKING,
                "a completion is taken by the plan, and the mission goes on",
                () -> {
                    PlanScene scene = intercepting("CompleteMissionReceived");
                    scene.post(new Input.CompleteMission(PlanScene.MISSION));
                    scene.untilBoat("boat-1", "after");
                });
    }

    private static PlanScene stopped(String output) {
        PlanScene scene = new PlanScene(
                new PlanSketch()
                        .asks("go", "ProxyGotoLatLon", "location", FAR)
                        .asks("go", "StartSystemTimer", "duration", seconds(10))
                        .on("go", "TimerExpired", "stop")
                        .asks("stop", output),
                1);
        scene.run(5);
        assertThat(scene.world.hull("boat-1").isAtRest()).isFalse();
        scene.run(6);
        return scene;
    }

    private static PlanScene intercepting(String input) {
        return new PlanScene(
                new PlanSketch().asks("go", "ProxyGotoLatLon", "location", FAR).on("go", input, "after", "any-token"),
                1);
    }

    private static DurationValue seconds(long seconds) {
        return new DurationValue(seconds * 1000);
    }
}
