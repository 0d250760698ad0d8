package org.sami.session.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.net.http.HttpClient;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.security.LinkRefusedException;
import org.sami.boat.server.testing.Await;
import org.sami.crw.operator.health.HealthFault;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.file.BoatFileSource;
import org.sami.crw.proxy.file.FileFetchException;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.fault.ThreadGuard;
import org.sami.session.api.LinkedBoat;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.Person;
import org.sami.session.person.PersonRole;
import org.sami.session.server.testing.ServedSession;

/** What the base answers over HTTP where a boat does not give its logs. */
class LogsTest {
    private static final LinkedBoat ANNA = new LinkedBoat("anna", BoatAddress.parse("127.0.0.1:11411"));

    @TempDir
    private Path folder;

    private final List<HealthFault> faults = Collections.synchronizedList(new ArrayList<>());
    private final List<String> stops = Collections.synchronizedList(new ArrayList<>());
    private CompletionStage<LogBoats.Found> found =
            CompletableFuture.completedFuture(new LogBoats.Found(Optional.of(ANNA), true));
    private Throwing opening = () -> {};
    private ServedSession served;
    private LogHandler logs;
    private PageServer server;

    @FunctionalInterface
    private interface Throwing {
        void run() throws IOException;
    }

    @BeforeEach
    void serve() throws Exception {
        served = ServedSession.ofPlan("station-keep", folder)
                .with("paul", PersonRole.PILOT)
                .begin();
        PeopleFile people = served.people();
        Person paul = people.all().get(0);
        LogBoats boats = new LogBoats() {
            @Override
            public CompletionStage<Found> find(String boat) {
                return found;
            }

            @Override
            public BoatFileSource files(LinkedBoat boat) {
                return new Anna();
            }
        };
        logs = new LogHandler(
                boats,
                ticket -> Optional.of(paul),
                SessionBases.NONE,
                new LogNews(new PeopleNews(served.session(), text -> {}), () -> 0),
                () -> 0,
                new ThreadGuard(faults::add, stops::add));
        server = new PageServer(
                ServerAddress.onThisMachine(0), people, SessionBases.NONE, Optional.empty(), List.of(logs), from -> "");
        server.start();
    }

    @AfterEach
    void end() throws Exception {
        server.stop();
        logs.close();
        served.close();
    }

    /** Has one log, once it is open. */
    private final class Anna implements BoatFileSource {
        @Override
        public void open() throws IOException {
            opening.run();
        }

        @Override
        public String boatId() {
            return "anna";
        }

        @Override
        public List<KeptFile> list(String kind) {
            return List.of(new KeptFile("anna.log", KeptFile.LOG, 3, "0f".repeat(32)));
        }

        @Override
        public byte[] piece(String name, long offset, int atMost) {
            return new byte[3];
        }

        @Override
        public void close() {}
    }

    private HttpResponse<String> get(String path) throws Exception {
        return HttpClient.newHttpClient()
                .send(
                        HttpRequest.newBuilder(URI.create(server.url() + path))
                                .header("Authorization", "Bearer of paul")
                                .build(),
                        HttpResponse.BodyHandlers.ofString());
    }

    @Test
    void logsOfABoatThatAnswersAreListed() throws Exception {
        HttpResponse<String> answer = get("logs?boat=anna");

        assertThat(answer.statusCode()).isEqualTo(200);
        assertThat(answer.body())
                .isEqualTo("{\"files\":[{\"name\":\"anna.log\",\"bytes\":3,\"sha256\":\"" + "0f".repeat(32) + "\"}]}");
    }

    @Test
    void boatThatIsNotReachedIsToBeAskedAgain() throws Exception {
        opening = () -> {
            throw new IOException("no route");
        };

        HttpResponse<String> answer = get("logs?boat=anna");

        assertThat(answer.statusCode()).isEqualTo(503);
        assertThat(answer.body()).isEqualTo("no route");
    }

    @Test
    void boatThatRefusesIsNotAskedAgain() throws Exception {
        opening = () -> {
            throw new FileFetchException("anna gives none");
        };

        assertThat(get("logs?boat=anna").statusCode()).isEqualTo(502);
    }

    @Test
    void boatThatRefusesTheKeyOfTheBaseIsNotAskedAgain() throws Exception {
        opening = () -> {
            throw new LinkRefusedException("anna does not know this base");
        };

        HttpResponse<String> answer = get("logs?boat=anna");

        assertThat(answer.statusCode()).isEqualTo(502);
        assertThat(answer.body()).isEqualTo("anna does not know this base");
    }

    @Test
    void boatWhoseLinkHasNotAnsweredYetIsToBeAskedAgain() throws Exception {
        found = CompletableFuture.completedFuture(new LogBoats.Found(Optional.empty(), true));

        assertThat(get("logs?boat=anna").statusCode()).isEqualTo(503);
    }

    @Test
    void boatThatTheSessionDoesNotKnowIsNotAskedAgain() throws Exception {
        found = CompletableFuture.completedFuture(new LogBoats.Found(Optional.empty(), false));

        assertThat(get("logs?boat=anna").statusCode()).isEqualTo(404);
    }

    @Test
    void boatIsToBeAskedAgainWhereTheSessionDoesNotSayWhetherItKnowsIt() throws Exception {
        found = CompletableFuture.failedFuture(new IllegalStateException("it begins"));

        assertThat(get("logs?boat=anna").statusCode()).isEqualTo(503);
    }

    @Test
    @SuppressWarnings("NullAway")
    void faultInTheSearchForABoatEndsTheRequestAndIsTold() throws Exception {
        found = CompletableFuture.completedFuture(null);

        assertThat(get("logs?boat=anna").statusCode()).isEqualTo(500);

        Await.until("it is told", () -> !faults.isEmpty());
        assertThat(faults).extracting(HealthFault::kind).containsExactly(HealthKind.THREAD);
    }

    @Test
    void memoryThatRunsOutOnALogEndsItsRequestAndNotTheSession() throws Exception {
        opening = () -> {
            throw new OutOfMemoryError("of this test");
        };

        assertThat(get("logs?boat=anna").statusCode()).isEqualTo(500);

        Await.until("it is told", () -> !faults.isEmpty());
        assertThat(faults).extracting(HealthFault::kind).containsExactly(HealthKind.MEMORY);
        assertThat(stops).isEmpty();
    }

    @Test
    void baseThatWaitsForTheSessionAsksToComeAgain() throws Exception {
        try (StandbyServer standby = StandbyServer.start(
                served.people(), ServerAddress.onThisMachine(0), Optional.empty(), SessionBases.NONE)) {
            HttpResponse<String> answer = HttpClient.newHttpClient()
                    .send(
                            HttpRequest.newBuilder(URI.create(standby.url() + "logs?boat=anna"))
                                    .build(),
                            HttpResponse.BodyHandlers.ofString());

            assertThat(answer.statusCode()).isEqualTo(503);
            assertThat(answer.body()).isEqualTo("this base does not hold the session");
        }
    }
}
