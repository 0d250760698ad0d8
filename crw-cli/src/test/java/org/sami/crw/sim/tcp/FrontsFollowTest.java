package org.sami.crw.sim.tcp;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.cli.CrwProcess;
import org.sami.crw.judgement.DraftAnswer;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.journal.postgres.PostgresAddress;
import org.sami.session.client.KnownServers;
import org.sami.session.client.Login;
import org.sami.session.client.PersonRights;
import org.sami.session.client.RemoteListener;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.ServerTrust;
import org.sami.session.client.SessionAddress;
import org.sami.spn.value.GeoPoint;
import org.sami.work.postgres.testing.TestDatabase;

/** Fronts of a base that ends, and of the standby that takes over: both bases are processes on one journal in PostgreSQL. */
@Tag("process")
@Timeout(600)
class FrontsFollowTest {
    /** A machine with much else to do starts processes slowly. */
    private static final double AT_MOST_S = 120;

    private static final long AT_MOST_MILLIS = 300_000;
    private static final String PLAN = "station-keep";
    private static final String POINT = "ask-stations.location";

    @TempDir
    private Path folder;

    private final BlockingQueue<String> heard = new LinkedBlockingQueue<>();

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
        ExecutorService front = Executors.newSingleThreadExecutor();
        try (Doorway one = new Doorway();
                Doorway two = new Doorway()) {
            String bases = one.address() + "," + two.address();
            try (CrwProcess first = serve(journal, "--bases", bases)) {
                one.leadTo(port(first, "the session is at "));
                try (CrwProcess standby = serve(journal, "--bases", bases, "--standby")) {
                    two.leadTo(port(standby, "standby: it answers at "));
                    await(standby, "standby: the session is held by ");
                    try (RemoteSession anna = open(one.address(), front);
                            CrwProcess console = console(one.address())) {
                        await(console, "the session goes on when this console is left");
                        get(anna.start(PLAN, PLAN, Map.of()));
                        get(anna.caughtUp());
                        PendingDecision asked =
                                anna.models().decisions().pending().get(0);
                        await(console, "[1] Parameters of station-keep");

                        await(console, "> wait ended");
                        ending.end(first);

                        assertThat(heard("connection lost (")).endsWith("; trying " + bases.replace(",", ", "));
                        assertThat(heard("back")).isEqualTo("back at " + two.address());
                        get(anna.caughtUp());
                        assertThat(anna.models().decisions().pending()).containsExactly(asked);
                        assertHalfIsJudged(anna, asked);
                        get(anna.abortAll());
                        assertThat(console.await(300))
                                .as(console.out() + console.err())
                                .isZero();
                        assertThat(console.out())
                                .contains("connection lost (", "connected again, at " + two.address())
                                .containsOnlyOnce("[1] Parameters of station-keep");
                    }
                }
            }
        } finally {
            front.shutdown();
        }
    }

    @Test
    void frontLeavesABaseThatStandsStillAndDoesNotGoBackToIt() throws Exception {
        String journal = TestDatabase.address().text();
        ExecutorService front = Executors.newSingleThreadExecutor();
        try (Doorway one = new Doorway();
                Doorway two = new Doorway()) {
            String bases = one.address() + "," + two.address();
            try (CrwProcess first = serve(journal, "--bases", bases);
                    CrwProcess standby = serve(journal, "--bases", bases, "--standby")) {
                one.leadTo(port(first, "the session is at "));
                two.leadTo(port(standby, "standby: it answers at "));
                await(standby, "standby: the session is held by ");
                try (RemoteSession anna = open(one.address(), front)) {
                    get(anna.caughtUp());

                    first.standStill(true);

                    assertThat(heard("nothing comes from ")).startsWith("nothing comes from " + one.address());
                    assertThat(heard("connection lost (")).startsWith("connection lost (nothing came for 5 s)");
                    assertThat(heard("back at ws")).isEqualTo("back at " + two.address());
                    first.standStill(false);
                    Await.until("the first base knows that it was followed", AT_MOST_S, () -> !first.isAlive());
                    assertThat(first.out()).contains(" took the session over at ");
                    get(anna.caughtUp());
                    assertThat(anna.address()).hasToString(two.address());
                }
            }
        } finally {
            front.shutdown();
        }
    }

    @Test
    void frontLeavesABaseThatIsCutOffFromTheJournalOnceAnotherHoldsTheSession() throws Exception {
        PostgresAddress journal = TestDatabase.address();
        ExecutorService front = Executors.newSingleThreadExecutor();
        try (Doorway one = new Doorway();
                Doorway two = new Doorway();
                Doorway database = new Doorway()) {
            String bases = one.address() + "," + two.address();
            String there = journal.text().split("localhost:")[1].split("/")[0];
            database.leadTo(Integer.parseInt(there));
            String through = journal.text().replace("localhost:" + there, "localhost:" + database.port());
            try (CrwProcess first = serve(through, "--bases", bases);
                    CrwProcess standby = serve(journal.text(), "--bases", bases, "--standby")) {
                one.leadTo(port(first, "the session is at "));
                two.leadTo(port(standby, "standby: it answers at "));
                await(standby, "standby: the session is held by ");
                try (RemoteSession anna = open(one.address(), front)) {
                    get(anna.caughtUp());

                    database.shut();

                    assertThat(heard("connection lost (")).contains(one.address() + " stands still");
                    assertThat(heard("back at ws")).isEqualTo("back at " + two.address());
                    assertThat(first.isAlive()).as("the base that is cut off").isTrue();
                    get(anna.start(PLAN, PLAN, Map.of()));
                }
            }
        } finally {
            front.shutdown();
        }
    }

    /** Such as a form asks while somebody types. */
    private static void assertHalfIsJudged(RemoteSession anna, PendingDecision asked) throws Exception {
        DraftAnswer half = DraftAnswer.of(Map.of(POINT, GeoPoint.of(45.4, 10.9)));
        assertThat(get(anna.drafts().judge(asked.decision(), half))).isNotNull();
    }

    @Test
    void baseThatIsEndedInOrderGivesTheSessionBackAtOnce() throws Exception {
        PostgresAddress journal = TestDatabase.address();
        try (CrwProcess base = serve(journal.text())) {
            await(base, "the session is at ");
            String left = "SELECT count(*) FROM lease WHERE ends > clock_timestamp()";
            assertThat(TestDatabase.number(journal, left)).isOne();

            base.terminate();
            base.await(60);

            assertThat(TestDatabase.number(journal, left)).as(base.out()).isZero();
        }
    }

    private CrwProcess console(String address) throws IOException {
        Path script =
                Files.writeString(folder.resolve("script"), "wait decision within 120\nwait ended within 300\nquit\n");
        return CrwProcess.start(
                folder, List.of("session", "--session", address, "--person", "ben", "--script", script.toString()));
    }

    private RemoteSession open(String address, ExecutorService front) throws Exception {
        ServerTrust trust = new ServerTrust(new KnownServers(folder.resolve("servers")), (authority, print) -> false);
        RemoteListener listener = new RemoteListener() {
            @Override
            public void lost(String words) {
                heard.add(words);
            }

            @Override
            public void back(SessionAddress base) {
                heard.add("back at " + base);
            }

            @Override
            public void ended(String why) {
                heard.add("ended: " + why);
            }

            @Override
            public void rights(PersonRights now) {
                heard.add("role: " + now.role());
            }

            @Override
            public void news(String text) {
                heard.add(text);
            }
        };
        return RemoteSession.open(
                List.of(SessionAddress.parse(address)), new Login("anna", ""), trust, front, listener, LocalTime::now);
    }

    /** What the front got to know next that begins so; lines before it are passed over. */
    private String heard(String beginning) throws InterruptedException {
        String line = "";
        while (!line.startsWith(beginning)) {
            line = Optional.ofNullable(heard.poll(AT_MOST_MILLIS, TimeUnit.MILLISECONDS))
                    .orElseThrow();
        }
        return line;
    }

    private CrwProcess serve(String journal, String... more) throws IOException {
        List<String> line = new ArrayList<>(List.of("serve", "--port", "0", "--journal", journal));
        line.addAll(List.of(more));
        return CrwProcess.start(folder, line);
    }

    private static void await(CrwProcess base, String words) {
        Await.until("'" + words + "'", AT_MOST_S, () -> base.out().contains(words) || !base.isAlive());
        assertThat(base.out()).as(base.err()).contains(words);
    }

    /** The port of the address that it prints behind some words. */
    private static int port(CrwProcess base, String words) {
        await(base, words + "http://127.0.0.1:");
        String at = base.out().split(words + "http://127.0.0.1:")[1];
        return Integer.parseInt(at.substring(0, at.indexOf('/')));
    }

    private static <T> T get(CompletionStage<T> stage) throws Exception {
        return stage.toCompletableFuture().get(AT_MOST_MILLIS, TimeUnit.MILLISECONDS);
    }
}
