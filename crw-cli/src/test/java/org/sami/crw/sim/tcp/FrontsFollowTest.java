package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CrwProcess;
import org.sami.crw.operator.decision.DecisionListener;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.session.api.DraftAnswer;
import org.sami.session.client.RemoteSession;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.value.GeoPoint;
import org.sami.work.postgres.testing.TestDatabase;

/** Fronts of a base that ends, and of the standby that takes over: both bases are processes on one journal in PostgreSQL. */
@Tag("process")
@Timeout(600)
class FrontsFollowTest {
    private static final long MESSAGE_MS = 500;
    private static final String PLAN = "station-keep";
    private static final String POINT = "ask-stations.location";

    /** Autonomy answers 45 s after the question: later than a take-over, on a session's clock that stands still meanwhile. */
    private static final String TIMED = """
        {"formatVersion": 1, "id": "timed", "name": "Timed", "domain": "crw", "plans": [{"id": "timed", "name": "Timed",
         "places": [
          {"id": "asking", "start": true, "outputs": [{"id": "ask", "type": "OperatorApprove",
           "fields": {"question": {"value": "Go on?"}},
           "markups": [{"type": "MixedInitiativeTrigger", "options": {"trigger": "TIMER", "timeout": "PT45S"}}]}]},
          {"id": "done", "end": true}],
         "transitions": [{"id": "yes", "inputs": [{"id": "i", "type": "YesOption"}]}],
         "inEdges": [{"id": "e1", "place": "asking", "transition": "yes",
           "requirements": [{"kind": "generic", "match": "at-least", "n": 1}]}],
         "outEdges": [{"id": "e2", "transition": "yes", "place": "done",
           "requirements": [{"kind": "generic", "action": "take", "n": 1}]}]}]}
        """;

    @TempDir
    private Path folder;

    /** How a base ends. */
    @FunctionalInterface
    private interface Ending {
        void end(CrwProcess base) throws Exception;
    }

    @Test
    void windowAndConsoleFollowTheStandbyOfAKilledBaseAndTheirQuestionStays() throws Exception {
        follow(CrwProcess::kill);
    }

    @Test
    void windowAndConsoleFollowTheStandbyOfABaseThatIsEndedInOrder() throws Exception {
        follow(CrwProcess::terminate);
    }

    private void follow(Ending ending) throws Exception {
        String journal = TestDatabase.address().text();
        try (BaseAndStandby bases = new BaseAndStandby(folder)) {
            CrwProcess first = bases.serve(journal);
            bases.standBy(journal);
            try (RemoteSession anna = bases.front()) {
                CrwProcess console = bases.console("wait decision within 120", "wait ended within 300", "quit");
                BaseAndStandby.await(console, "the session goes on when this console is left");
                get(anna.start(PLAN, PLAN, Map.of()));
                PendingDecision asked = asked(anna);
                BaseAndStandby.await(console, "> wait ended");

                ending.end(first);

                assertThat(bases.notices().next("connection lost ("))
                        .endsWith("; trying " + bases.first() + ", " + bases.second());
                assertThat(bases.notices().next("back at ws")).isEqualTo("back at " + bases.second());
                assertThat(asked(anna)).isEqualTo(asked);
                assertHalfIsJudged(anna, asked);
                BaseAndStandby.await(console, "connected again, at " + bases.second()); // to hear of the end
                get(anna.abortAll());
                assertThat(console.await(300)).as(console.out() + console.err()).isZero();
                assertThat(console.out())
                        .contains("connection lost (", "connected again, at " + bases.second())
                        .containsOnlyOnce("[1] Parameters of station-keep");
            }
        }
    }

    @Test
    void consoleThatWaitsForTheEndIsDoneThoughTheMissionEndedWhileItHadNoLink() throws Exception {
        String journal = TestDatabase.address().text();
        try (BaseAndStandby bases = new BaseAndStandby(folder)) {
            CrwProcess first = bases.serve(journal);
            bases.standBy(journal);
            try (RemoteSession anna = bases.front()) {
                CrwProcess console = bases.console("wait decision within 120", "wait ended within 300", "quit");
                BaseAndStandby.await(console, "the session goes on when this console is left");
                get(anna.start(PLAN, PLAN, Map.of()));
                BaseAndStandby.await(console, "> wait ended");

                console.standStill(true);
                first.kill();
                bases.notices().next("back at ws");
                get(anna.abortAll());
                Await.until(
                        "the mission has ended",
                        () -> anna.models().missions().snapshot().running().isEmpty());
                console.standStill(false);

                assertThat(console.await(120)).as(console.out() + console.err()).isZero();
            }
        }
    }

    private static PendingDecision asked(RemoteSession of) throws Exception {
        get(of.caughtUp());
        assertThat(of.models().decisions().pending()).hasSize(1);
        return of.models().decisions().pending().get(0);
    }

    /** Such as a form asks while somebody types. */
    private static void assertHalfIsJudged(RemoteSession anna, PendingDecision asked) throws Exception {
        DraftAnswer half = DraftAnswer.of(Map.of(POINT, GeoPoint.of(45.4, 10.9)));
        assertThat(get(anna.drafts().judge(asked.decision(), half))).isNotNull();
    }

    @Test
    void timeUntilAutonomyAnswersGoesOnAtTheNextBase() throws Exception {
        String journal = TestDatabase.address().text();
        Path project = Files.writeString(folder.resolve("timed.json"), TIMED);
        try (BaseAndStandby bases = new BaseAndStandby(folder)) {
            CrwProcess first = bases.serve(journal, project.toString());
            bases.standBy(journal);
            try (RemoteSession anna = bases.front()) {
                CompletableFuture<Optional<Answerer>> answered = new CompletableFuture<>();
                anna.models().decisions().addListener(new DecisionListener() {
                    @Override
                    public void opened(PendingDecision decision) {}

                    @Override
                    public void closed(PendingDecision decision, Optional<Answer> answer, Optional<Answerer> by) {
                        answered.complete(by);
                    }
                });
                get(anna.start("timed", "timed", Map.of()));
                PendingDecision asked = asked(anna);
                assertThat(asked.decision().deadlineMillis()).isPresent();

                first.kill();

                bases.notices().next("back at ws");
                assertThat(asked(anna)).isEqualTo(asked);
                assertThat(get(answered)).contains(Answerer.AUTONOMY);
                assertThat(anna.nowMillis())
                        .as("but for the time that a message takes")
                        .isGreaterThan(asked.decision().deadlineMillis().getAsLong() - MESSAGE_MS);
            }
        }
    }

    @Test
    void frontLeavesABaseThatStandsStillAndDoesNotGoBackToIt() throws Exception {
        String journal = TestDatabase.address().text();
        try (BaseAndStandby bases = new BaseAndStandby(folder)) {
            CrwProcess first = bases.serve(journal);
            bases.standBy(journal);
            try (RemoteSession anna = bases.front()) {
                get(anna.caughtUp());

                first.standStill(true);

                assertThat(bases.notices().next("nothing comes from "))
                        .startsWith("nothing comes from " + bases.first());
                assertThat(bases.notices().next("connection lost ("))
                        .startsWith("connection lost (nothing came for 5 s)");
                assertThat(bases.notices().next("back at ws")).isEqualTo("back at " + bases.second());
                first.standStill(false);
                Await.until("the first knows that it was followed", BaseAndStandby.AT_MOST_S, () -> !first.isAlive());
                assertThat(first.out()).contains(" took the session over at ");
                get(anna.caughtUp());
                assertThat(anna.address()).hasToString(bases.second());
            }
        }
    }

    @Test
    void frontLeavesABaseThatIsCutOffFromTheJournalOnceAnotherHoldsTheSession() throws Exception {
        PostgresAddress journal = TestDatabase.address();
        try (BaseAndStandby bases = new BaseAndStandby(folder);
                ForwardedPort database = new ForwardedPort()) {
            String port = journal.text().split("localhost:")[1].split("/")[0];
            database.leadTo(Integer.parseInt(port));
            CrwProcess first = bases.serve(journal.text().replace("localhost:" + port, "localhost:" + database.port()));
            bases.standBy(journal.text());
            try (RemoteSession anna = bases.front()) {
                get(anna.caughtUp());

                database.shut();

                assertThat(bases.notices().next("connection lost (")).contains(bases.first() + " stands still");
                assertThat(bases.notices().next("back at ws")).isEqualTo("back at " + bases.second());
                assertThat(first.isAlive()).as("the base that is cut off").isTrue();
                get(anna.start(PLAN, PLAN, Map.of()));
            }
        }
    }

    @Test
    void baseThatIsEndedInOrderGivesTheSessionBackAtOnce() throws Exception {
        PostgresAddress journal = TestDatabase.address();
        String held = "SELECT count(*) FROM lease WHERE ends > clock_timestamp()";
        try (BaseAndStandby bases = new BaseAndStandby(folder)) {
            CrwProcess base = bases.serve(journal.text());
            assertThat(TestDatabase.number(journal, held)).isOne();

            base.terminate();
            base.await(60);

            assertThat(TestDatabase.number(journal, held)).as(base.out()).isZero();
        }
    }

    private static <T> T get(CompletionStage<T> stage) throws Exception {
        return stage.toCompletableFuture().get(300, TimeUnit.SECONDS);
    }
}
