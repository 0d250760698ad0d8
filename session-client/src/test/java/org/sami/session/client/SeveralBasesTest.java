package org.sami.session.client;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.nio.file.Path;
import java.time.LocalTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.security.Identity;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.session.client.testing.FrontNotices;
import org.sami.session.person.PeopleFile;
import org.sami.session.person.Person;
import org.sami.session.person.PersonKey;
import org.sami.session.person.PersonRole;
import org.sami.session.server.ServerAddress;
import org.sami.session.server.SessionBases;
import org.sami.session.server.SessionServer;
import org.sami.session.server.StandbyServer;
import org.sami.session.server.testing.ServedSession;

/** A front of a session whose base ends while a standby waits: real servers on loopback, one of which serves the session at a time. */
class SeveralBasesTest {
    private static final String PLAN = "station-keep";

    @TempDir
    private Path folder;

    private final ExecutorService front = Executors.newSingleThreadExecutor();
    private final FrontNotices notices = new FrontNotices();
    private final List<AutoCloseable> opened = new ArrayList<>();
    private final Identity first = Identity.generate();
    private final Identity second = Identity.generate();
    private ServedSession served;

    @BeforeEach
    void begin() throws Exception {
        served = session(PLAN).with("anna", PersonRole.OPERATOR);
    }

    private ServedSession session(String plan) throws Exception {
        ServedSession made = ServedSession.ofPlan(plan, folder).begin();
        opened.add(made);
        return made;
    }

    @AfterEach
    void end() throws Exception {
        for (int last = opened.size() - 1; last >= 0; last--) {
            opened.get(last).close();
        }
        front.shutdown();
    }

    private static ServerAddress secured(int port, Identity identity) {
        return new ServerAddress(InetAddress.getLoopbackAddress(), port, Optional.of(identity));
    }

    private StandbyServer standby(SessionBases bases) throws IOException {
        StandbyServer one = StandbyServer.start(served.people(), secured(0, second), Optional.empty(), bases);
        one.say("the session is held by laptop-1");
        opened.add(one);
        return one;
    }

    private SessionServer serve(int port, Identity identity, SessionBases bases) throws IOException {
        return served.serve(secured(port, identity), bases);
    }

    private static SessionAddress address(int port) {
        return SessionAddress.parse("wss://127.0.0.1:" + port);
    }

    private static SessionBases bases(int port, Optional<String> print) {
        return SessionBases.parse(List.of(address(port) + "=" + print.orElseThrow()));
    }

    private RemoteSession open(SessionAddress at, String trusted) throws Exception {
        ServerTrust trust = new ServerTrust(
                new KnownServers(folder.resolve("servers")), (authority, print) -> print.equals(trusted));
        RemoteSession one = RemoteSession.open(
                List.of(at), new Login("anna", "key of anna"), trust, front, notices, () -> LocalTime.of(14, 2, 31));
        opened.add(one);
        return one;
    }

    private static <T> T get(CompletionStage<T> stage) throws Exception {
        return stage.toCompletableFuture().get();
    }

    @Test
    void frontOfABaseThatEndsGoesToTheOneThatTakesOverAndItsQuestionStays() throws Exception {
        StandbyServer waiting = standby(SessionBases.NONE);
        int other = waiting.listensAt().getPort();
        SessionServer holder = serve(0, first, bases(other, waiting.certificate()));
        SessionAddress at = address(holder.listensAt().getPort());
        RemoteSession anna = open(at, holder.certificate().orElseThrow());
        get(anna.start(PLAN, PLAN, Map.of()));
        get(anna.caughtUp());
        PendingDecision asked = anna.models().decisions().pending().get(0);
        DecisionChanges changes = new DecisionChanges();
        anna.models().decisions().addListener(changes);

        holder.close();
        assertThat(notices.next("connection lost ("))
                .endsWith(", last seen 14:02:31; trying " + at + ", " + address(other));
        assertThat(notices.next("connection lost, "))
                .contains(address(other) + ", a standby: the session is held by laptop-1");
        waiting.close();
        serve(other, second, SessionBases.NONE);

        assertThat(notices.next("back")).isEqualTo("back at " + address(other));
        assertThat(anna.address()).isEqualTo(address(other));
        get(anna.caughtUp());
        assertThat(anna.models().decisions().find(asked.decision().id())).contains(asked);
        assertThat(changes.lines()).isEmpty();
        get(anna.abortAll());
    }

    @Test
    void frontThatComesToAStandbyFindsTheHolderThroughIt() throws Exception {
        SessionServer holder = serve(0, first, SessionBases.NONE);
        SessionAddress at = address(holder.listensAt().getPort());
        StandbyServer waiting = standby(bases(holder.listensAt().getPort(), holder.certificate()));

        RemoteSession anna = open(
                address(waiting.listensAt().getPort()), waiting.certificate().orElseThrow());

        assertThat(anna.address()).isEqualTo(at);
        assertThat(notices.next("wss:"))
                .endsWith(", a standby: the session is held by laptop-1; trying "
                        + address(waiting.listensAt().getPort()) + ", " + at);
    }

    @Test
    void certificateThatATrustedBaseNamedIsTrustedForThisSessionAlone() throws Exception {
        SessionServer holder = serve(0, first, SessionBases.NONE);
        StandbyServer waiting = standby(bases(holder.listensAt().getPort(), holder.certificate()));
        open(address(waiting.listensAt().getPort()), waiting.certificate().orElseThrow());

        assertThatThrownBy(() -> open(address(holder.listensAt().getPort()), "another"))
                .hasMessageStartingWith("nobody has compared the certificate of 127.0.0.1:"
                        + holder.listensAt().getPort());
    }

    @Test
    void baseWithAnotherCertificateThanWasNamedGetsNoKey() throws Exception {
        StandbyServer waiting = standby(SessionBases.NONE);
        int other = waiting.listensAt().getPort();
        String forged = "AB:" + waiting.certificate().orElseThrow().substring(3);
        SessionServer holder = serve(0, first, bases(other, Optional.of(forged)));
        int port = holder.listensAt().getPort();
        open(address(port), holder.certificate().orElseThrow());
        waiting.close();
        serve(other, second, SessionBases.NONE);

        holder.close();
        notices.next("connection lost (");
        serve(port, first, SessionBases.NONE);

        assertThat(notices.next("back")).isEqualTo("back at " + address(port));
    }

    @Test
    void baseThatHasAnotherSessionIsPassedOver() throws Exception {
        SessionServer stranger = session("clv").serve(secured(0, second), SessionBases.NONE);
        int other = stranger.listensAt().getPort();
        SessionServer holder = serve(0, first, bases(other, stranger.certificate()));
        int port = holder.listensAt().getPort();
        open(address(port), holder.certificate().orElseThrow());

        holder.close();
        notices.next("connection lost, last seen 14:02:31; " + address(other) + ": another session is at ");
        serve(port, first, SessionBases.NONE);

        assertThat(notices.next("back")).isEqualTo("back at " + address(port));
    }

    @Test
    void personWhomTheNextBaseDoesNotKnowGoesOnAtTheFirst() throws Exception {
        PeopleFile others = new PeopleFile(folder.resolve("others"));
        others.add(new Person("ben", PersonRole.OPERATOR, List.of(), PersonKey.hash("key of ben")));
        SessionServer strict =
                SessionServer.start(served.session(), others, secured(0, second), Optional.empty(), SessionBases.NONE);
        opened.add(strict);
        int other = strict.listensAt().getPort();
        SessionServer holder = serve(0, first, bases(other, strict.certificate()));
        int port = holder.listensAt().getPort();
        open(address(port), holder.certificate().orElseThrow());

        holder.close();
        notices.next("connection lost, last seen 14:02:31; " + address(other) + ": no such name and key");
        serve(port, first, SessionBases.NONE);

        assertThat(notices.next("back")).isEqualTo("back at " + address(port));
    }
}
