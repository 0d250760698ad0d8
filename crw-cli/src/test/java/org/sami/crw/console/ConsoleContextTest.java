package org.sami.crw.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.sim.run.TestRuns;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.model.Project;

/** What the console waits for before its next command. */
class ConsoleContextTest {
    /** Ends at once, and says so. */
    private static final String PLAN = """
            {"formatVersion": 1, "id": "p", "name": "P", "domain": "crw", "plans": [{
              "id": "p", "name": "Ends at once",
              "places": [{"id": "start", "start": true},
                {"id": "end", "end": true, "outputs": [{"id": "say", "type": "DisplayMessage",
                  "fields": {"message": {"value": "It is over"}}}]}],
              "transitions": [{"id": "go"}],
              "inEdges": [{"id": "i", "place": "start", "transition": "go",
                "requirements": [{"match": "at-least", "n": 1, "kind": "generic"}]}],
              "outEdges": [{"id": "o", "transition": "go", "place": "end",
                "requirements": [{"action": "take", "n": "all", "kind": "generic"}]}]}]}
            """;

    /** As on a machine that is busy: what the plan says reaches the operator after the mission's end. */
    @Test
    void afterAWaitTheOperatorHasBeenToldWhatFollowedTooThoughTheFleetWasLate() throws Exception {
        Project project =
                new ProjectReader(TestRuns.LIBRARY.vocabulary()).read(PLAN).orThrow();
        CountDownLatch fleetGoesOn = new CountDownLatch(1);
        try (Session session = Session.open(SessionSetup.of(TestRuns.LIBRARY.vocabulary(), project));
                ConsoleContext context = new ConsoleContext(session)) {
            context.listen();
            session.begin();
            session.fleet().ask(boats -> await(fleetGoesOn));
            session.start("p", "p", Map.of());
            assertThat(context.until(() -> hasEnded(session), 60)).isTrue();
            assertThat(session.models().messages().snapshot()).isEmpty();

            new Thread(fleetGoesOn::countDown, "test").start();
            context.catchUp();

            assertThat(session.models().messages().snapshot())
                    .extracting(entry -> entry.message().text())
                    .containsExactly("It is over");
        }
    }

    private static boolean hasEnded(Session session) {
        return session.models().missions().snapshot().missions().stream().anyMatch(MissionSnapshot::hasEnded);
    }

    private static boolean await(CountDownLatch latch) {
        try {
            return latch.await(120, TimeUnit.SECONDS);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return false;
        }
    }
}
