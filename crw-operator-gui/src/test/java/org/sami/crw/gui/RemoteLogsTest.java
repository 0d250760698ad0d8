package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.LocalTime;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Function;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.security.Identity;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionSetup;
import org.sami.crw.session.archive.SessionJournal;
import org.sami.crw.session.file.LogFetch;
import org.sami.crw.session.file.LogRow;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;
import org.sami.session.api.LinkedBoat;
import org.sami.session.client.KnownServers;
import org.sami.session.client.Login;
import org.sami.session.client.PersonRights;
import org.sami.session.client.RemoteListener;
import org.sami.session.client.RemoteSession;
import org.sami.session.client.ServerTrust;
import org.sami.session.client.SessionAddress;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.Person;
import org.sami.session.person.PersonKey;
import org.sami.session.person.PersonRole;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionBases;
import org.sami.session.server.SessionServer;
import org.sami.session.server.StandbyServer;
import org.sami.spn.journal.JournalHeader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;

/** Logs of real boats, fetched in a front elsewhere: over HTTPS from the session's machine, which asks the boats over TCP. */
@Timeout(900)
class RemoteLogsTest {
    private static final int LINES = 3000; // of a log that comes in several pieces

    private final ExecutorService front = Executors.newSingleThreadExecutor();
    private final Identity identity = Identity.generate();

    @TempDir
    private Path folder;

    private Session session;
    private PeopleFile people;
    private SessionServer server;
    private BoatOnTcp anna;

    @BeforeEach
    void serve() throws Exception {
        Project project = SessionWorld.LIBRARY.projectOf("station-keep").orElseThrow();
        JournalHeader header = JournalHeader.of(
                new ProjectWriter(SessionWorld.LIBRARY.vocabulary()).text(project),
                SessionWorld.LIBRARY.files().texts(),
                Map.of());
        session = Session.open(
                SessionSetup.of(SessionWorld.LIBRARY.vocabulary(), project).with(SessionJournal.none(header)));
        people = new PeopleFile(folder.resolve("people"));
        people.add(new Person("paul", PersonRole.PILOT, List.of(), PersonKey.hash("key of paul")));
        people.add(new Person("otto", PersonRole.OBSERVER, List.of(), PersonKey.hash("key of otto")));
        server = serveAt(0);
        session.begin();
        Path logs = Files.createDirectories(folder.resolve("boats"));
        anna = new BoatOnTcp(
                BoatSettings.of(
                                "anna",
                                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                                GeoPoint.of(45.4, 10.9),
                                1)
                        .loggingTo(logs),
                SteadyClock.ofThisMachine(),
                TcpServerListener.NONE);
        Files.writeString(logs.resolve("anna.log.000001"), "a later line of the log of anna\n".repeat(LINES * 10));
        session.fleet()
                .connect(BoatAddress.parse("127.0.0.1:" + anna.address().getPort()))
                .toCompletableFuture()
                .get();
    }

    @AfterEach
    void end() throws Exception {
        anna.close();
        server.close();
        session.close();
        front.shutdown();
    }

    private SessionServer serveAt(int port) throws Exception {
        return serveAt(port, SessionBases.NONE);
    }

    private SessionServer serveAt(int port, SessionBases bases) throws Exception {
        return SessionServer.start(session, people, at(port), Optional.empty(), bases);
    }

    private ServerAddress at(int port) {
        return new ServerAddress(InetAddress.getLoopbackAddress(), port, Optional.of(identity));
    }

    /** Only logs count here. */
    private static final class Quiet implements RemoteListener {
        @Override
        public void lost(String words) {}

        @Override
        public void back(SessionAddress base) {}

        @Override
        public void ended(String why) {}

        @Override
        public void rights(PersonRights now) {}

        @Override
        public void news(String text) {}
    }

    private RemoteSession open(String name) throws Exception {
        return RemoteSession.open(
                List.of(SessionAddress.parse(
                        "wss://127.0.0.1:" + server.listensAt().getPort())),
                new Login(name, "key of " + name),
                new ServerTrust(new KnownServers(folder.resolve("servers")), (address, print) -> true),
                front,
                new Quiet(),
                () -> LocalTime.NOON);
    }

    private static List<LinkedBoat> boats(RemoteSession remote) throws Exception {
        return remote.fleet().linkedBoats().toCompletableFuture().get();
    }

    private <T> T ask(LogFetch fetch, Function<LogFetch, T> question) {
        return CompletableFuture.supplyAsync(() -> question.apply(fetch), front).join();
    }

    private LogFetch begin(RemoteSession remote, List<LinkedBoat> boats) {
        LogFetch fetch = new LogFetch(front, boat -> remote.fleet().files(boat), () -> {});
        return ask(fetch, one -> {
            one.offer(boats);
            one.begin(Set.of(boats.get(0).address()), folder.resolve("here"));
            return one;
        });
    }

    @Test
    void logsComeWholeAndThatIsNotedInTheOperatorsLog() throws Exception {
        try (RemoteSession paul = open("paul")) {
            assertThat(boats(paul)).extracting(LinkedBoat::boat).containsExactly("anna");
            LogFetch fetch = begin(paul, boats(paul));
            Await.until("it has ended", () -> !ask(fetch, LogFetch::isRunning));

            assertThat(ask(fetch, LogFetch::said)).isEqualTo("Logs of anna are in " + folder.resolve("here"));
            assertThat(folder.resolve("here/anna/anna.log.000001"))
                    .hasSameBinaryContentAs(folder.resolve("boats/anna.log.000001"));
            assertThat(session.models().log().snapshot())
                    .anyMatch(entry -> entry.text().equals("paul fetches the logs of anna"));
        }
    }

    @Test
    void fetchGoesOnAfterTheConnectionWasLost() throws Exception {
        int port = server.listensAt().getPort();
        try (RemoteSession paul = open("paul")) {
            List<LinkedBoat> boats = boats(paul);
            server.close();
            LogFetch fetch = begin(paul, boats);
            Await.until(
                    "no answer is said", () -> ask(fetch, LogFetch::rows).get(0).state() == LogRow.State.NO_ANSWER);

            server = serveAt(port);

            Await.until("it has ended", () -> !ask(fetch, LogFetch::isRunning));
            assertThat(ask(fetch, LogFetch::isBad)).isFalse();
            assertThat(folder.resolve("here/anna/anna.log.000001"))
                    .hasSameBinaryContentAs(folder.resolve("boats/anna.log.000001"));
        }
    }

    @Test
    void fetchGoesOnAtTheBaseThatTakesTheSessionOver() throws Exception {
        server.close();
        try (StandbyServer standby = StandbyServer.start(people, at(0), Optional.empty(), SessionBases.NONE)) {
            standby.say("the session is held by laptop-1");
            int other = standby.listensAt().getPort();
            server = serveAt(
                    0,
                    SessionBases.parse(List.of("wss://127.0.0.1:" + other + "="
                            + standby.certificate().orElseThrow())));
            try (RemoteSession paul = open("paul")) {
                List<LinkedBoat> boats = boats(paul);
                server.close();
                LogFetch fetch = begin(paul, boats);
                Await.until(
                        "no answer is said",
                        () -> ask(fetch, LogFetch::rows).get(0).state() == LogRow.State.NO_ANSWER);

                standby.close();
                server = serveAt(other);

                Await.until("it has ended", () -> !ask(fetch, LogFetch::isRunning));
                assertThat(ask(fetch, LogFetch::said)).isEqualTo("Logs of anna are in " + folder.resolve("here"));
                assertThat(folder.resolve("here/anna/anna.log.000001"))
                        .hasSameBinaryContentAs(folder.resolve("boats/anna.log.000001"));
            }
        }
    }

    @Test
    void observerGetsNoLogAndIsToldWhy() throws Exception {
        try (RemoteSession paul = open("paul");
                RemoteSession otto = open("otto")) {
            LogFetch fetch = begin(otto, boats(paul));
            Await.until("it has ended", () -> !ask(fetch, LogFetch::isRunning));

            assertThat(ask(fetch, LogFetch::rows).get(0).words())
                    .isEqualTo("The role observer of otto does not have the right 'drive'");
            assertThat(folder.resolve("here/anna")).doesNotExist();
        }
    }
}
