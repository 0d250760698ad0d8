package org.sami.crw.sim.run;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.InputStream;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BatteryDefaults;
import org.sami.boat.server.ServerConfig;
import org.sami.crw.proxy.link.ProxyConfig;
import org.sami.crw.service.reach.WayBack;

/** Numbers that two modules need and that no module can give to both. */
class SharedNumbersTest {
    @Test
    void boatThatWouldComeHomeWithALowBatteryIsNamed() {
        assertThat(WayBack.PLENTY_PERCENT).isEqualTo(BatteryDefaults.LOW_PERCENT);
    }

    @Test
    void bothSidesCallALinkLostAfterTheSameTime() {
        assertThat(ServerConfig.of("anna", "1").build().lostLinkAfterMs()).isEqualTo(ProxyConfig.DEFAULT.lostAfterMs());
    }

    @Test
    void batteryWatchThatAuthorsAddHasTheThresholdsOfBoats() throws IOException {
        try (InputStream file = SharedNumbersTest.class.getResourceAsStream("/org/sami/domain/crw/authoring.json")) {
            JsonNode fields = new ObjectMapper().readTree(file).findParent("low");

            assertThat(fields.get("low").get("value").asDouble()).isEqualTo(BatteryDefaults.LOW_PERCENT);
            assertThat(fields.get("critical").get("value").asDouble()).isEqualTo(BatteryDefaults.CRITICAL_PERCENT);
        }
    }
}
