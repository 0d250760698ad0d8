package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Path;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicReference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.ConnectAttempt;
import org.sami.crw.session.ConnectAttempt.State;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.SimulatedBoatsOnTcp;

/** What an operator hears of addresses to which a session connects, over real sockets. */
@Timeout(900)
class ConnectAttemptTest {
    @TempDir
    private Path folder;

    private static final class Attempts {
        private final AtomicReference<ConnectAttempt> latest = new AtomicReference<>();

        /** What a stage that is ready runs comes before the attempt is handed out. */
        void begin(Session session, BoatAddress address) throws Exception {
            session.ask(view -> true)
                    .thenAccept(front -> latest.set(ConnectAttempt.begin(session, address, one -> {})))
                    .toCompletableFuture()
                    .get(60, TimeUnit.SECONDS);
        }

        void until(Session session, String words) {
            Await.until("\"" + words + "\" is said", () -> said(session).contains(words));
        }

        String said(Session session) {
            return session.ask(view -> true)
                    .thenApply(front -> latest.get().words())
                    .toCompletableFuture()
                    .join();
        }
    }

    private static BoatAddress deaf() throws IOException {
        try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            return new BoatAddress("127.0.0.1", taken.getLocalPort()); // closed again: nobody listens there
        }
    }

    @Test
    void aBoatThatAnswersIsNamedAndOneThatIsThereAlreadyToo() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("clv"));
            session.begin();
            BoatAddress anna = new SimulatedBoatsOnTcp(1).launch("anna", TestSession.PIER);
            Attempts attempts = new Attempts();

            attempts.begin(session, anna);
            attempts.until(session, anna + " is connected as anna");
            assertThat(attempts.latest.get().state()).isEqualTo(State.CONNECTED);

            Await.until(
                    "it is a boat of the fleet",
                    () -> session.models().fleet().boat("anna").isPresent());
            attempts.begin(session, anna);
            attempts.until(session, anna + " is anna, which is connected already");
        }
    }

    @Test
    void whereNobodyAnswersItIsSaidWhyAndHowOftenItWasTried() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("clv"));
            session.begin();
            BoatAddress nobody = deaf();
            Attempts attempts = new Attempts();

            attempts.begin(session, nobody);

            attempts.until(session, nobody + " does not answer (connection refused, tried ");
            assertThat(attempts.latest.get().state()).isEqualTo(State.NO_ANSWER);
            assertThat(attempts.said(session)).endsWith("; it goes on being tried");
        }
    }
}
