package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;

/** What a base is told of what a vehicle does without a link, by its parameters, and what it sets. */
@Timeout(300)
class VehicleFailsafeTest {
    @TempDir
    private Path folder;

    private SmallBoat boat;

    @BeforeEach
    void start() throws Exception {
        boat = new SmallBoat(5, 45.7, 10.72, 1);
    }

    @AfterEach
    void end() throws Exception {
        boat.close();
    }

    private LinkClient linked() {
        return new LinkClient(folder, boat.address() + "/5");
    }

    private static void says(LinkClient client, LostLinkAction action, String by) {
        Await.until(
                "it is " + action + " by " + by,
                60,
                () -> client.last(SettingsReport.class)
                        .filter(said -> said.lostLinkAction() == action
                                && said.actionBy().equals(by))
                        .isPresent());
    }

    @Test
    void saysByWhichParametersItDoesWhatItDoesAndSetsThem() {
        boat.parameter("FS_GCS_TIMEOUT", 5);
        LinkClient client = linked();
        try {
            says(client, LostLinkAction.CONTINUE, "FS_GCS_ENABLE 0");

            assertThat(client.ask(new SetLostLinkAction("home", LostLinkAction.RETURN)))
                    .isInstanceOf(Ack.class);

            assertThat(boat.parameter("FS_GCS_ENABLE")).isEqualTo(1);
            assertThat(boat.parameter("FS_ACTION")).isEqualTo(3);
            says(client, LostLinkAction.RETURN, "FS_GCS_ENABLE 1, FS_ACTION 3, after 5 s");
            assertThat(client.hasAlarm("somebody else")).isFalse();
        } finally {
            client.close();
        }
    }

    @Test
    void saysWhereItReturnsToByItsRallyPoints() {
        boat.parameter("FS_GCS_ENABLE", 1);
        boat.parameter("FS_ACTION", 1);
        boat.parameter("RALLY_TOTAL", 2);
        LinkClient client = linked();
        try {
            says(
                    client,
                    LostLinkAction.RETURN,
                    "FS_GCS_ENABLE 1, FS_ACTION 1, to the nearest of its home and its 2 rally points");

            assertThat(client.ask(new SetLostLinkAction("home", LostLinkAction.RETURN)))
                    .isInstanceOf(Ack.class);

            says(
                    client,
                    LostLinkAction.RETURN,
                    "FS_GCS_ENABLE 1, FS_ACTION 3, to the nearest of its home and its 2 rally points where it does not go"
                            + " back the way that it came");

            boat.setByAnother("RALLY_TOTAL", 1);

            client.untilAlarm("what vehicle 5 does when its link is lost was changed by somebody else: RALLY_TOTAL 1");
        } finally {
            client.close();
        }
    }

    @Test
    void whatAnotherStationSetsIsAnAlarmAndInForce() {
        boat.parameter("FS_GCS_ENABLE", 1);
        boat.parameter("FS_ACTION", 1);
        LinkClient client = linked();
        try {
            says(client, LostLinkAction.RETURN, "FS_GCS_ENABLE 1, FS_ACTION 1");

            boat.setByAnother("FS_GCS_ENABLE", 0);

            client.untilAlarm("what vehicle 5 does when its link is lost was changed by somebody else: FS_GCS_ENABLE 0,"
                    + " before 1");
            says(client, LostLinkAction.CONTINUE, "FS_GCS_ENABLE 0");
            assertThat(client.ask(new SetLostLinkAction("hold", LostLinkAction.HOLD)))
                    .isInstanceOf(Ack.class);
            says(client, LostLinkAction.HOLD, "FS_GCS_ENABLE 1, FS_ACTION 6");
        } finally {
            client.close();
        }
    }

    @Test
    void vehicleWhoseFailsafeIsOffOnMissionsGoesOn() {
        boat.parameter("FS_GCS_ENABLE", 2);
        boat.parameter("FS_ACTION", 1);
        LinkClient client = linked();
        try {
            says(client, LostLinkAction.CONTINUE, "FS_GCS_ENABLE 2, FS_ACTION 1");
        } finally {
            client.close();
        }
    }

    @Test
    void vehicleThatHeedsAnotherGroundStationGoesOnWithoutThisOneAndIsNotSet() {
        boat.parameter("FS_GCS_ENABLE", 1);
        boat.parameter("FS_ACTION", 1);
        boat.parameter("SYSID_MYGCS", 252);
        LinkClient client = linked();
        try {
            says(
                    client,
                    LostLinkAction.CONTINUE,
                    "FS_GCS_ENABLE 1, FS_ACTION 1, SYSID_MYGCS 252 is another ground station than this base, 255");

            assertThat(client.ask(new SetLostLinkAction("home", LostLinkAction.RETURN)))
                    .isInstanceOfSatisfying(
                            Nack.class,
                            refused -> assertThat(refused.detail()).contains("vehicle 5 does not heed this base"));
        } finally {
            client.close();
        }
    }
}
