package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.testing.ArduPilotBoats;
import org.sami.mavlink.vehicle.VehicleId;

/** What the real firmware of a copter does without a link, by its options too. */
@Tag("long")
@Timeout(600)
class ArduPilotCopterFailsafeTest {
    private static final int NUMBER = 108;
    private static final int SPEED = 5;
    private static final double START_S = 120;
    private static final VehicleId ID = new VehicleId(NUMBER + 1, 1);

    @TempDir
    private Path work;

    @Test
    void optionToGoOnInAutoIsTakenBackWhereItIsToReturn() throws Exception {
        assumeTrue(ArduPilotBoats.areThere(), ArduPilotBoats::missing);
        Path own = Files.writeString(work.resolve("own.parm"), "FS_GCS_ENABLE 1\nFS_OPTIONS 18\n");
        try (ArduPilotBoats copter = ArduPilotBoats.of("copter", NUMBER, SPEED, work, own)) {
            LinkClient client =
                    new LinkClient(work.resolve("vehicles"), ArduPilotBoats.address(NUMBER) + "/" + (NUMBER + 1));
            try (MavlinkBase other = new MavlinkBase(
                    List.of(AddressText.parse("mavlink:tcp:127.0.0.1:" + ArduPilotBoats.secondPort(NUMBER))),
                    ProcessClock::ms)) {
                does(client, LostLinkAction.CONTINUE, "FS_GCS_ENABLE 1, FS_OPTIONS 18, after 5 s");

                assertThat(client.ask(new SetLostLinkAction("home", LostLinkAction.RETURN)))
                        .isInstanceOf(Ack.class);

                does(client, LostLinkAction.RETURN, "FS_GCS_ENABLE 1, after 5 s");
                Await.until(
                        "the other station hears it",
                        START_S,
                        () -> !other.vehicles().join().isEmpty());
                assertThat(other.parameter(ID, "FS_OPTIONS").join()).isEqualTo(16);
            } finally {
                client.close();
            }
        }
    }

    private static void does(LinkClient client, LostLinkAction action, String by) {
        Await.until(
                "it is " + action + " by " + by,
                START_S,
                () -> client.last(SettingsReport.class)
                        .filter(said -> said.lostLinkAction() == action
                                && said.actionBy().equals(by))
                        .isPresent());
    }
}
