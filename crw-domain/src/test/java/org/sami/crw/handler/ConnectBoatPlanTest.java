package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TextValue;

/** Connect Boat (thesis 6.3.1) in several missions at once: each gets the boat that it asked for. */
class ConnectBoatPlanTest {
    private static final String PLAN = "connect-boat-by-address";
    private static final Project PROJECT = DomainLibrary.fromClassPath("/org/sami/domain/crw")
            .orThrow()
            .projectOf(PLAN)
            .orElseThrow();

    private static Input.StartMission connect(String name, String server) {
        return new Input.StartMission(
                PLAN,
                name,
                Map.of(
                        "name", new TextValue(name),
                        "color", new TextValue("#ffce00"),
                        "server", new TextValue(server)));
    }

    @Test
    void missionsThatConnectBoatsAtOnceEachGetTheirOwn() {
        TestWorld world = new TestWorld(new HostedEngine(PROJECT));
        PlanScene scene = new PlanScene(world);
        world.host.post(connect("anna", "10.0.0.1:11411"));
        world.host.post(connect("bert", "10.0.0.2:11411"));
        world.run(0.1);

        scene.until(
                "both missions have ended",
                () -> world.host.ask(view -> view.missions().isEmpty()));

        assertThat(List.of(scene.outcome(1), scene.outcome(2))).containsOnly(Outcome.ENDED);
        assertThat(scene.used("ProxyConnected"))
                .extracting(Occurrence::mission, Occurrence::proxies)
                .containsExactlyInAnyOrder(
                        tuple(1L, List.of("anna at 10.0.0.1:11411")), tuple(2L, List.of("bert at 10.0.0.2:11411")));
        assertThat(scene.used("SetGainsSucceeded"))
                .extracting(Occurrence::mission, Occurrence::proxies)
                .containsExactlyInAnyOrder(
                        tuple(1L, List.of("anna at 10.0.0.1:11411")), tuple(2L, List.of("bert at 10.0.0.2:11411")));
        assertThat(scene.notes()).noneMatch(note -> note.contains("Proxy"));
    }

    @Test
    void boatThatSomebodyElseConnectsIsNotTheMissions() {
        TestWorld world = new TestWorld(new HostedEngine(PROJECT));
        PlanScene scene = new PlanScene(world);
        world.cutLink("anna at 10.0.0.1:11411", true);
        world.host.post(connect("anna", "10.0.0.1:11411"));
        world.run(0.1);

        world.addBoat("late", 0, 50);
        world.run(5);

        assertThat(scene.stands(new Token.Proxy("late"), "connected")).isFalse();
        assertThat(scene.stands(Token.GENERIC, "connect")).isTrue();
        world.cutLink("anna at 10.0.0.1:11411", false);
        scene.until(
                "the mission has ended",
                () -> world.host.ask(view -> view.missions().isEmpty()));
        assertThat(scene.used("SetGainsSucceeded"))
                .extracting(Occurrence::proxies)
                .containsExactly(List.of("anna at 10.0.0.1:11411"));
    }

    @Test
    void boatThatIsConnectedForOneMissionIsNewsToThoseThatWaitForAny() {
        Project waiting =
                new PlanSketch().joining("here", "ProxyCreated", "team").project();
        TestWorld world = new TestWorld(new HostedEngine(both(waiting)));
        PlanScene scene = new PlanScene(world);
        world.host.post(new Input.StartMission(PlanSketch.ROOT, "waits", Map.of()));
        world.host.post(connect("anna", "10.0.0.1:11411"));

        scene.untilBoat("anna at 10.0.0.1:11411", "team");
        scene.until(
                "the other has ended",
                () -> world.host.ask(view -> view.missions().size()) == 1);
    }

    private static Project both(Project other) {
        return new Project(
                "both",
                "both",
                "crw",
                PROJECT.globals(),
                List.of(),
                Stream.concat(PROJECT.plans().stream(), other.plans().stream()).toList());
    }
}
