package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionException;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.operator.boat.BoatCommands;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.session.api.RefusedException;

/** Missions that cannot go on say so, since when, why and what would help; those that merely wait do not. */
@Tag("long")
@Timeout(900)
class StuckMissionTest {
    /** Boats drive to a point; by an interrupt they go back to the start. Nothing is planned for a path that fails. */
    private static final String DRIVE = """
        {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
          "id": "drive", "name": "Drive there",
          "places": [{"id": "drive", "name": "Under way", "start": true, "outputs": [{"id": "go", "type": "ProxyGotoPoint",
              "fields": {"points": {"value": {"anna": {"lat": 45.404, "lon": 10.9}}}}}]},
            {"id": "watch", "name": "Watch"},
            {"id": "end", "end": true}],
          "transitions": [
            {"id": "there", "name": "There", "inputs": [{"id": "i2", "type": "ProxyPathCompleted"}]},
            {"id": "leave", "name": "Leave it", "inputs": [{"id": "i3", "type": "OperatorInterruptReceived", "fields": {"interruptName": "Leave it"}}]}],
          "inEdges": [
            {"id": "e2", "place": "drive", "transition": "there", "requirements": [{"match": "all", "kind": "relevant"}]},
            {"id": "e3", "place": "drive", "transition": "leave", "requirements": [{"match": "at-least", "n": 1, "kind": "any-proxy"}]}],
          "outEdges": [
            {"id": "o2", "transition": "there", "place": "end", "requirements": [{"action": "take", "n": "all", "kind": "relevant"}]},
            {"id": "o3", "transition": "leave", "place": "watch", "requirements": [{"action": "take", "n": "all", "kind": "any-token"}]}]}]}
        """;

    @TempDir
    private Path folder;

    private TestSession world;

    @BeforeEach
    void open() {
        world = new TestSession(folder);
    }

    @AfterEach
    void close() throws Exception {
        world.close();
    }

    private Session begun(String project, String... boats) throws Exception {
        Session session = world.opened(TestSession.project(project));
        session.begin();
        for (String boat : boats) {
            BoatOnTcp one = world.boat(boat);
            TestSession.get(session.fleet().connect(TestSession.address(one)));
            TestSession.until(
                    boat + " has joined", session, view -> view.proxies().contains(boat));
        }
        return session;
    }

    private static MissionSnapshot mission(Session session, long id) {
        return session.models().missions().snapshot().mission(id).orElseThrow();
    }

    private static String command(Session session, String boat) {
        Await.until(boat + " has a command", () -> current(session, boat).isPresent());
        return current(session, boat).orElseThrow();
    }

    private static Optional<String> current(Session session, String boat) {
        return session.models().commands().snapshot().stream()
                .filter(one -> one.boat().equals(boat))
                .map(BoatCommands::queue)
                .flatMap(queue -> queue.current().stream())
                .map(entry -> entry.command().commandId())
                .findFirst();
    }

    private static List<HealthEntry> faults(Session session) {
        return session.models().health().snapshot().of(HealthKind.MISSION);
    }

    @Test
    void aMissionWhoseCommandFailedIsStuckAndGoesOnWhenItIsSentAgain() throws Exception {
        Session session = begun(DRIVE, "anna");
        long mission = TestSession.get(session.start("drive", "", Map.of()));
        TestSession.get(session.fleet().cancel("anna", command(session, "anna")));

        Await.until("it is stuck", () -> mission(session, mission).stuck().isPresent());

        StuckMission stuck = mission(session, mission).stuck().orElseThrow();
        assertThat(stuck.what()).isEqualTo("anna cannot go on in 'Under way': the operator cancelled it");
        assertThat(stuck.help()).isEqualTo("Send it again, press 'Leave it', or complete or abort the mission");
        assertThat(stuck.boats()).containsExactly("anna");
        assertThat(faults(session)).singleElement().satisfies(entry -> {
            assertThat(entry.fault().text()).isEqualTo("\"Drive there\" is stuck: " + stuck.what());
            assertThat(entry.sinceMillis()).isEqualTo(stuck.sinceMillis());
            assertThat(entry.fault().advice()).isEqualTo(stuck.help());
            assertThat(entry.fault().mission()).isEqualTo(mission);
        });

        TestSession.get(session.sendAgain(mission));

        command(session, "anna");
        Await.until("it is stuck no longer", () -> faults(session).isEmpty());
        assertThat(mission(session, mission).stuck()).isEmpty();
        assertThatThrownBy(() -> TestSession.get(session.sendAgain(mission)))
                .isInstanceOf(CompletionException.class)
                .hasCauseInstanceOf(RefusedException.class)
                .hasMessageContaining("nothing has failed");
    }

    @Test
    void aMissionIsNotStuckWhileAnotherOfItsBoatsIsUnderWayThere() throws Exception {
        String both = DRIVE.replace("10.9}}", "10.9}, \"bert\": {\"lat\": 45.404, \"lon\": 10.9005}}");
        Session session = begun(both, "anna", "bert");
        long mission = TestSession.get(session.start("drive", "", Map.of()));
        command(session, "bert");
        TestSession.get(session.fleet().cancel("anna", command(session, "anna")));
        long failedAt = session.scheduler().nowMs();

        Await.until("it could be stuck by now", () -> session.scheduler().nowMs() > failedAt + 8_000);

        assertThat(mission(session, mission).stuck()).isEmpty();
        TestSession.get(session.fleet().cancel("bert", command(session, "bert")));
        Await.until("it is stuck", () -> mission(session, mission).stuck().isPresent());
        assertThat(mission(session, mission).stuck().orElseThrow().boats()).containsExactlyInAnyOrder("anna", "bert");
    }

    @Test
    void aMissionThatWaitsForAPressAloneIsNotStuckAndOneThatNothingLeadsOnIs() throws Exception {
        String watching = DRIVE.replace(
                "\"ProxyPathCompleted\"", "\"OperatorInterruptReceived\", \"fields\": {\"interruptName\": \"Go\"}");
        Session session = begun(watching, "anna");
        long mission = TestSession.get(session.start("drive", "", Map.of()));
        TestSession.get(session.fleet().cancel("anna", command(session, "anna")));
        long failedAt = session.scheduler().nowMs();

        Await.until("it could be stuck by now", () -> session.scheduler().nowMs() > failedAt + 8_000);

        assertThat(mission(session, mission).stuck()).isEmpty();
        TestSession.get(session.press("Leave it", mission, List.of()));
        Await.until("it is stuck", () -> !faults(session).isEmpty());
        assertThat(faults(session).get(0).fault().text())
                .startsWith("\"Drive there\" is stuck: nothing is under way, it stands in 'Watch'");
        assertThat(faults(session).get(0).fault().advice()).isEqualTo("Complete or abort the mission");
        assertThatThrownBy(() -> TestSession.get(session.sendAgain(mission)))
                .hasMessageContaining("nothing has failed");

        TestSession.get(session.abort(mission));
        Await.until("its fault is over", () -> faults(session).isEmpty());
        assertThat(TestSession.missions(session)).isEmpty();
    }
}
