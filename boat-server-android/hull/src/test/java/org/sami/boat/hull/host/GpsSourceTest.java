package org.sami.boat.hull.host;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.hull.nmea.GpsdReader;
import org.sami.boat.hull.nmea.NmeaSentence;
import org.sami.boat.hull.position.PositionFilter;
import org.sami.boat.hull.stream.TcpPort;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;

/** Receivers on real sockets. */
@Timeout(900)
class GpsSourceTest {
    private final PositionFilter filter = new PositionFilter();
    private final SteadyClock clock = new SteadyClock(ProcessClock::ms);
    private final List<String> news = new CopyOnWriteArrayList<>();
    private ServerSocket server;

    @BeforeEach
    void listens() throws IOException {
        server = new ServerSocket(0, 5, InetAddress.getLoopbackAddress());
    }

    @AfterEach
    void ends() throws IOException {
        server.close();
    }

    private TcpPort port() {
        return new TcpPort("127.0.0.1", server.getLocalPort());
    }

    private static void send(Socket to, String text) throws IOException {
        to.getOutputStream().write(text.getBytes(StandardCharsets.US_ASCII));
        to.getOutputStream().flush();
    }

    private boolean isAt(double latDeg) {
        return Math.abs(filter.pose(clock.getAsLong()).latDeg() - latDeg) < 1e-3;
    }

    @Test
    void gpsdIsAskedToReportAndItsPositionsAreTaken() throws Exception {
        try (GpsSource source = GpsSource.gpsd(port(), filter, clock, news::add)) {
            source.openFirst();
            source.start();
            try (Socket client = server.accept()) {
                BufferedReader in =
                        new BufferedReader(new InputStreamReader(client.getInputStream(), StandardCharsets.US_ASCII));
                assertThat(in.readLine() + "\n").isEqualTo(GpsdReader.WATCH);
                send(
                        client,
                        "{\"class\":\"SKY\",\"satellites\":[" + "{},".repeat(9000)
                                + "{}]}\n"); // longer than a line may be
                send(client, "{\"class\":\"TPV\",\"mode\":3,\"lat\":45.4,\"lon\":10.9}\n");

                Await.until("the position is known", () -> isAt(45.4));
            }
        }
    }

    @Test
    void receiverThatVanishesIsToldAndReadAgainWhenItIsBack() throws Exception {
        try (GpsSource source = GpsSource.nmea(port(), filter, clock, news::add)) {
            source.start();
            try (Socket client = server.accept()) {
                send(client, NmeaSentence.line("GPRMC,1,A,4524.000,N,01054.000,E,0.0,0.0,,,"));
                Await.until("the position is known", () -> isAt(45.4));
            }
            Await.until("it is told", () -> !news.isEmpty());
            assertThat(news.get(0))
                    .isEqualTo("GPS " + port().name()
                            + " is gone (the other side has closed it): plug it in again; it is tried every second");
            try (Socket again = server.accept()) {
                Await.until("it is back", () -> news.contains("GPS " + port().name() + " is back"));
                send(again, "garbage" + "x".repeat(1_000_000) + "\r\n");
                send(again, NmeaSentence.line("GPHDT,90.0,T"));
                Await.until(
                        "the next sentence counts",
                        () -> Math.abs(filter.pose(clock.getAsLong()).headingRad() - Math.PI / 2) < 0.01);
            }
        }
    }

    @Test
    void declinationThatAPersonGivesIsNotReplacedByTheReceivers() throws Exception {
        try (GpsSource source = GpsSource.nmea(port(), filter, clock, news::add)) {
            source.setDeclination(0.5);
            source.start();
            try (Socket client = server.accept()) {
                send(client, NmeaSentence.line("HCHDG,0.0,,,10.0,W"));

                Await.until(
                        "the heading is known",
                        () -> Math.abs(filter.pose(clock.getAsLong()).headingRad() - 0.5) < 0.01);
            }
        }
    }
}
