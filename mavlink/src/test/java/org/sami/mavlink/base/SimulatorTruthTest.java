package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import io.dronefleet.mavlink.MavlinkConnection;
import io.dronefleet.mavlink.ardupilotmega.Simstate;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SimulatorTruth;

/** What tests are told of where a simulated vehicle was. */
@Timeout(60)
class SimulatorTruthTest {
    private static final double METRE = 1 / 111_319.0; // in degrees of latitude

    /** A simulator that reports places on a line to the north, in metres, and then ends. */
    private static SimulatorTruth of(double... northM) throws Exception {
        try (ServerSocket server = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            SimulatorTruth truth = new SimulatorTruth(server.getLocalPort(), 1);
            try (Socket simulator = server.accept()) {
                MavlinkConnection codec =
                        MavlinkConnection.create(simulator.getInputStream(), simulator.getOutputStream());
                for (double metres : northM) {
                    codec.send2(
                            1,
                            1,
                            Simstate.builder()
                                    .lat((int) Math.round((45 + metres * METRE) * 1e7))
                                    .lng(100_000_000)
                                    .build());
                }
                Await.until("all is heard", () -> truth.samples() == northM.length);
            }
            return truth;
        }
    }

    @Test
    void betweenTwoReportsItIsTakenToHaveGoneStraight() throws Exception {
        try (SimulatorTruth truth = of(0, 2, 4)) {
            assertThat(truth.nearestM(45 + 3 * METRE, 10)).isCloseTo(0, within(0.02));
            assertThat(truth.nearestM(45 + 3 * METRE, 10 + 2 * METRE))
                    .isCloseTo(2 * Math.cos(Math.PI / 4), within(0.02));
        }
    }

    @Test
    void whereReportsAreMissingItIsSaidAndNothingIsGuessed() throws Exception {
        try (SimulatorTruth truth = of(0, 1, 41)) {
            assertThat(truth.nearestM(45 + 20 * METRE, 10)).isCloseTo(19, within(0.1));
            Await.until("its end is heard", () -> truth.gap().orElse("").startsWith("after 3 reports"));
        }
    }
}
