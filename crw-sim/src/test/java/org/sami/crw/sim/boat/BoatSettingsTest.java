package org.sami.crw.sim.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.server.ServerConfig;

class BoatSettingsTest {
    @Test
    void serverKnowsHowFarItsBatteryGoes() {
        ServerConfig server = BoatSettings.of("anna", TcpTestFleet.port(0), TcpTestFleet.PIER, 1)
                .server("boot1");

        assertThat(server.metresPerPercent()).isCloseTo(35, within(1e-9));
        assertThat(server.performance())
                .isEqualTo(new BoatPerformance(OptionalDouble.of(35), OptionalDouble.of(1.5), OptionalDouble.of(0)));
        assertThat(server.fullThrustSpeedMps()).isEqualTo(3.2);
    }
}
