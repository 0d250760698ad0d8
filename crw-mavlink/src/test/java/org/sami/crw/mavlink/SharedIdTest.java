package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SensorMessages;
import org.sami.mavlink.testing.SmallBoat;
import org.sami.spn.protocol.Priority;

/** Two boats of one system id on one link, as where two radios send to one port. */
@Timeout(300)
class SharedIdTest {
    private static final double LAT = 45.7;
    private static final double LON = 10.72;

    @TempDir
    private Path folder;

    private SmallBoat boat;
    private LinkClient client;
    private int bootMs = 90_000_000;

    @BeforeEach
    void connect() throws Exception {
        boat = new SmallBoat(7, LAT, LON, 1);
        client = new LinkClient(folder, boat.address() + "/7");
    }

    @AfterEach
    void end() throws Exception {
        client.close();
        boat.close();
    }

    /** The other one says where it is, too. */
    private boolean otherIsHeard() {
        bootMs += 250;
        boat.sends(SensorMessages.position(LAT + 0.1, LON, bootMs));
        return client.hasAlarm("two vehicles answer as mav7 on " + boat.address());
    }

    @Test
    void isToldAtOnceAndNothingIsSet() {
        Await.until("two are noticed", this::otherIsHeard);

        assertThat(client.said("two vehicles answer as mav7", Priority.CRITICAL))
                .hasSize(1);
        assertThat(client.ask(new SetLostLinkAction("home", LostLinkAction.RETURN)))
                .isInstanceOfSatisfying(
                        Nack.class, no -> assertThat(no.detail()).contains("two vehicles have the id 7"));
        assertThat(boat.parameter("FS_GCS_ENABLE")).isZero();
    }
}
