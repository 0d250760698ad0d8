package org.sami.crw.sim.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.OwnPort;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.boat.FleetCount;
import org.sami.crw.operator.boat.UnreachedBoat;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.crw.session.Session;
import org.sami.crw.sim.boat.BoatOnTcp;
import org.sami.crw.sim.boat.BoatSettings;

/** A boat that was to be connected and does not answer is known, counted and a fault, until it answers or is given up. */
@Timeout(900)
class UnreachedBoatTest {
    @TempDir
    private Path folder;

    private static String count(OperatorModels models) {
        return FleetCount.of(models.fleet().snapshot(), models.unreached().snapshot())
                .words();
    }

    private static List<HealthEntry> faults(OperatorModels models) {
        return models.health().snapshot().of(HealthKind.UNREACHED_BOAT);
    }

    @Test
    void boatThatNeverAnsweredIsCountedAndNamedUntilItAnswers() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("clv"));
            OperatorModels models = session.models();
            int port = OwnPort.draw();
            BoatAddress absent = new BoatAddress("127.0.0.1", port);
            session.begin();
            session.fleet().connect(TestSession.address(world.boat("anna")));
            session.fleet().connect(absent);

            Await.until("anna answers, the other does not", () -> count(models).equals("1 of 2 boats"));
            UnreachedBoat shown = models.unreached().snapshot().get(0);
            assertThat(shown.address()).isEqualTo(absent.toString());
            assertThat(shown.state(shown.sinceMillis() + 65_000))
                    .startsWith("no answer · connection refused · tried ")
                    .endsWith(" in 65 s");
            Await.until("it is a fault", () -> !faults(models).isEmpty());
            assertThat(faults(models).get(0).fault().text())
                    .startsWith(absent + " does not answer (connection refused, tried ");
            Await.until(
                    "it is told",
                    () -> models.messages().messages().stream()
                            .anyMatch(message -> message.text().startsWith(absent + " does not answer")));

            BoatSettings late = BoatSettings.of(
                            "bert", new InetSocketAddress(InetAddress.getLoopbackAddress(), port), TestSession.PIER, 1)
                    .loggingTo(folder);
            try (BoatOnTcp bert = new BoatOnTcp(late, new SteadyClock(ProcessClock::ms), TcpServerListener.NONE)) {
                Await.until("bert answers", () -> count(models).equals("2 of 2 boats"));
                Await.until("no fault is left", () -> faults(models).isEmpty());
                Await.until(
                        "that it answers is told",
                        () -> models.messages().messages().stream()
                                .anyMatch(message -> message.text().equals(absent + " answers now")));
                assertThat(bert.address().getPort()).isEqualTo(port);
            }
        }
    }

    @Test
    void secondBoatOfAnIdIsSaidToBeRefusedAndNotToBeSilent() throws Exception {
        try (TestSession world = new TestSession(folder);
                BoatOnTcp twin = new BoatOnTcp(
                        BoatSettings.of(
                                "anna",
                                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                                TestSession.PIER,
                                1),
                        new SteadyClock(ProcessClock::ms),
                        TcpServerListener.NONE)) {
            Session session = world.opened(TestSession.library("clv"));
            OperatorModels models = session.models();
            session.begin();
            session.fleet().connect(TestSession.address(world.boat("anna")));
            Await.until("anna is known", () -> count(models).equals("1 of 1 boat"));

            session.fleet().connect(TestSession.address(twin));

            Await.until("it is a fault", () -> !faults(models).isEmpty());
            UnreachedBoat shown = models.unreached().snapshot().get(0);
            assertThat(shown.state(shown.sinceMillis()))
                    .startsWith("refused · anna is reached by another link · tried ");
            assertThat(faults(models).get(0).fault().text())
                    .startsWith(TestSession.address(twin) + " is refused: anna is reached by another link (tried ");
            assertThat(faults(models).get(0).fault().advice()).contains("an id of its own");
        }
    }

    @Test
    void addressThatIsGivenUpIsCountedNoLonger() throws Exception {
        try (TestSession world = new TestSession(folder)) {
            Session session = world.opened(TestSession.library("clv"));
            OperatorModels models = session.models();
            BoatAddress absent = new BoatAddress("127.0.0.1", OwnPort.draw());
            session.begin();
            session.fleet().connect(absent);
            Await.until("it does not answer", () -> count(models).equals("0 of 1 boat"));

            session.fleet().disconnect(absent);

            Await.until("it is gone", () -> count(models).equals("0 of 0 boats"));
        }
    }
}
