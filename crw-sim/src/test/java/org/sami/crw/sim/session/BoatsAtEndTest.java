package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.proxy.status.BoatStatus;
import org.sami.crw.session.BoatsAtEnd;
import org.sami.crw.session.Session;
import org.sami.spn.value.GeoPoint;

/** What boats under way do once a session was left, as they say it themselves. */
@Timeout(120)
class BoatsAtEndTest {
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

    @ParameterizedTest
    @CsvSource({"STOP, STOPPED", "HOLD, HOLD", "GO_ON, PATH"})
    void boatsDoWhatIsChosenAsTheSessionIsLeft(BoatsAtEnd end, BoatMode wanted) throws Exception {
        try (Session session = world.opened(TestSession.library("clv"), folder.resolve("session.journal"))) {
            session.begin();
            TestSession.get(session.fleet().connect(TestSession.address(world.boat("anna"))));
            TestSession.until("anna has joined", session, view -> view.proxies().contains("anna"));
            GeoPoint far = GeoPoint.of(TestSession.PIER.latDeg() + 0.002, TestSession.PIER.lonDeg());
            Await.until("anna says where she is", () -> anna(session).pose().isPresent());
            TestSession.get(session.byHand().goTo("anna", far));
            Await.until("anna is under way", () -> anna(session).mode().equals(Optional.of(BoatMode.PATH)));

            assertThat(session.leave(end)).isEmpty();

            Await.until("anna does it", () -> anna(session).mode().equals(Optional.of(wanted)));
        }
    }

    private static BoatStatus anna(Session session) {
        return TestSession.get(session.fleet().boats()).get(0);
    }
}
