package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.assertj.core.groups.Tuple;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.crw.event.ProxyMaps;
import org.sami.crw.proxy.BoatProxy;
import org.sami.crw.proxy.command.BoatCommand;
import org.sami.crw.service.Geodesy;
import org.sami.spn.engine.MissionView;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.TextValue;

/** The events that make boats abort missions: mission 1 asks, boat a is on its way for 1, and 2 and 3 wait in its queue. */
class AbortTest {
    private static final GeoPath NORTH =
            new GeoPath(List.of(Geodesy.offset(TestWorld.HOME, 0, 200), Geodesy.offset(TestWorld.HOME, 0, 400)));

    private final ScriptedEngine engine = new ScriptedEngine(TestWorld.VOCABULARY);
    private final TestWorld world = new TestWorld(engine);

    @BeforeEach
    void threeMissionsWantTheBoat() {
        world.addBoat("a", 0, 0);
        world.addBoat("b", 5, 0);
        for (long mission = 1; mission <= 4; mission++) {
            String boat = mission == 4 ? "b" : "a";
            engine.missions.put(
                    mission,
                    new MissionView(
                            mission,
                            0,
                            mission,
                            "plan",
                            "",
                            MissionStatus.RUNNING,
                            Map.of("here", List.of(new Token.Proxy(boat)))));
        }
        world.run(1);
        for (long mission = 1; mission <= 4; mission++) {
            String boat = mission == 4 ? "b" : "a";
            world.happens(
                    engine,
                    new TestActivations("ProxyExecutePath")
                            .id(mission)
                            .mission(mission)
                            .with("paths", ProxyMaps.toValue(Map.of(boat, NORTH)))
                            .of(boat)
                            .effect());
        }
        world.run(10);
        assertThat(wanted()).containsExactly(1L, 2L, 3L);
        assertThat(world.hull("a").isAtRest()).isFalse();
    }

    @Test
    void abortMissionSignalsAndTheBoatGoesOnForTheNextMission() {
        ask("SendAbortMission");

        assertThat(signals()).containsExactly(tuple(1L, 9L, List.of("a")));
        assertThat(wanted()).containsExactly(2L, 3L);
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
    }

    @Test
    void abortOfAllMissionsEmptiesTheQueueStopsTheBoatAndIsHeardByEachMission() {
        ask("SendProxyAbortAllMissions");
        world.run(3);

        assertThat(signals())
                .containsExactlyInAnyOrder(
                        tuple(1L, 9L, List.of("a")), tuple(2L, 0L, List.of("a")), tuple(3L, 0L, List.of("a")));
        assertThat(wanted()).isEmpty();
        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(engine.received("ProxyPathFailed"))
                .extracting(Occurrence::mission, Occurrence::activation)
                .containsExactly(tuple(2L, 2L), tuple(3L, 3L));
        assertThat(engine.received("ProxyPathFailed").get(0).values())
                .containsEntry("reason", new TextValue("mission 1 made a abort it"));
    }

    @Test
    void abortOfFutureMissionsLeavesTheOneThatIsUnderWay() {
        ask("SendProxyAbortFutureMissions");
        world.run(3);

        assertThat(signals()).containsExactly(tuple(2L, 0L, List.of("a")), tuple(3L, 0L, List.of("a")));
        assertThat(wanted()).containsExactly(1L);
        assertThat(world.hull("a").isAtRest()).isFalse();
    }

    @Test
    void abortOfFutureMissionsWhileNothingWaitsSignalsNothing() {
        ask("SendProxyAbortFutureMissions");
        int before = signals().size();

        ask("SendProxyAbortFutureMissions");

        assertThat(signals()).hasSize(before);
        assertThat(wanted()).containsExactly(1L);
    }

    @Test
    void proxyAbortMissionWithdrawsWhatThisMissionWantsAndSignalsNothing() {
        ask("ProxyAbortMission");

        assertThat(wanted()).containsExactly(2L, 3L);
        assertThat(signals()).isEmpty();
        assertThat(engine.received("ProxyPathFailed")).isEmpty();
    }

    @Test
    void proxyAbortMissionEndsTheMissionsBlock() {
        world.happens(
                engine,
                new TestActivations("BlockMovement")
                        .id(8)
                        .priority(Priority.HIGH)
                        .of("a")
                        .effect());
        world.run(3);
        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(wanted()).containsExactly(2L, 3L);

        ask("ProxyAbortMission");
        world.run(3);

        assertThat(world.hull("a").isAtRest()).isFalse();
    }

    @Test
    void anEmergencyAbortStopsTheMotorsAndFailsEveryMissionsCommand() {
        ask("ProxyEmergencyAbort");
        world.run(1);

        assertThat(world.hull("a").isAtRest()).isTrue();
        assertThat(wanted()).isEmpty();
        assertThat(engine.received("ProxyPathFailed"))
                .extracting(Occurrence::mission)
                .containsExactly(1L, 2L, 3L);
        assertThat(engine.received("ProxyPathFailed").get(2).values())
                .containsEntry("reason", new TextValue("mission 1 stopped the boat"));
    }

    @Test
    void anEmergencyAbortAlsoStopsABoatThatKeepsItsStation() {
        ask("SendProxyAbortAllMissions");
        world.happens(
                engine,
                new TestActivations("ProxyGotoLatLon")
                        .id(10)
                        .with("location", world.hull("a").position())
                        .of("a")
                        .effect());
        world.run(20);
        assertThat(boat("a").status().mode()).contains(BoatMode.HOLD);

        ask("ProxyEmergencyAbort");
        world.run(2);

        assertThat(boat("a").status().mode()).contains(BoatMode.STOPPED);
    }

    @Test
    void noOtherBoatIsTouched() {
        for (String event : List.of(
                "SendAbortMission",
                "SendProxyAbortAllMissions",
                "SendProxyAbortFutureMissions",
                "ProxyAbortMission",
                "ProxyEmergencyAbort")) {
            ask(event);
        }
        world.run(3);

        assertThat(boat("b").commands().current().map(BoatCommand::mission)).contains(4L);
        assertThat(world.hull("b").isAtRest()).isFalse();
        assertThat(signals()).noneMatch(signal -> signal.toList().contains(List.of("b")));
    }

    private void ask(String event) {
        world.happens(engine, new TestActivations(event).id(9).of("a").effect());
    }

    private BoatProxy boat(String id) {
        return world.boats.find(id).orElseThrow();
    }

    /** The missions that have a command for boat a, in the order of their turn. */
    private List<Long> wanted() {
        List<Long> missions = new ArrayList<>();
        boat("a").commands().current().ifPresent(command -> missions.add(command.mission()));
        boat("a").commands().waiting().forEach(command -> missions.add(command.mission()));
        return missions;
    }

    private List<Tuple> signals() {
        return engine.received("ProxyAbortMissionReceived").stream()
                .map(signal -> tuple(signal.mission(), signal.activation(), signal.proxies()))
                .toList();
    }

    /** Mission 5 sends boat c, which has not said where it is. */
    private void boatThatWaitsForItsPosition() {
        world.addBoat("c", 20, 0);
        world.happens(engine, north("c", NORTH));
    }

    private static Effect north(String boat, GeoPath path) {
        return new TestActivations("ProxyExecutePath")
                .id(5)
                .mission(5)
                .with("paths", ProxyMaps.toValue(Map.of(boat, path)))
                .of(boat)
                .effect();
    }

    private void askFor(String event, String boat) {
        world.happens(engine, new TestActivations(event).id(9).of(boat).effect());
    }

    private void assertFailedAndStays(String boat) {
        assertThat(engine.received("ProxyPathFailed"))
                .extracting(Occurrence::mission, Occurrence::activation, Occurrence::proxies)
                .containsExactly(tuple(5L, 5L, List.of(boat)));
        world.run(10);
        assertThat(boat(boat).commands().current()).isEmpty();
        assertThat(world.hull(boat).isAtRest()).isTrue();
    }

    @Test
    void anEmergencyAbortFailsAMoveThatWaitsForThePositionOfItsBoat() {
        boatThatWaitsForItsPosition();

        askFor("ProxyEmergencyAbort", "c");

        assertFailedAndStays("c");
    }

    @Test
    void abortOfFutureMissionsFailsAMoveThatWaitsForThePositionOfItsBoat() {
        boatThatWaitsForItsPosition();

        askFor("SendProxyAbortFutureMissions", "c");

        assertThat(signals()).containsExactly(tuple(5L, 0L, List.of("c")));
        assertFailedAndStays("c");
    }

    @Test
    void abortOfAllMissionsWithdrawsAQuestionAndFailsWhatItIsAbout() {
        world.addBoat("c", 20, 0);
        world.run(1);
        world.happens(engine, north("c", new GeoPath(List.of(Geodesy.offset(TestWorld.HOME, 0, 6_000)))));
        assertThat(engine.inputs).anyMatch(Input.AskOperator.class::isInstance);

        askFor("SendProxyAbortAllMissions", "c");

        assertThat(engine.inputs).contains(new Input.WithdrawQuestion("DoubtfulWay", "m5-a5"));
        assertFailedAndStays("c");
    }
}
