package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.Ack;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallCopter;

/** What a base is told of what a copter does without a link, where the copter is to go on in AUTO, and what it sets. */
@Timeout(300)
class CopterFailsafeTest {
    private static final String ENABLE = "FS_GCS_ENABLE";
    private static final String OPTIONS = "FS_OPTIONS";

    @TempDir
    private Path folder;

    private SmallCopter copter;

    @BeforeEach
    void start() throws Exception {
        copter = new SmallCopter(6, 45.7, 10.72, 1);
        copter.parameter(ENABLE, 1);
    }

    @AfterEach
    void end() throws Exception {
        copter.close();
    }

    private LinkClient linked() {
        return new LinkClient(folder, copter.address() + "/6");
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

    @ParameterizedTest
    @CsvSource({"RETURN, 1", "HOLD, 7", "DRIFT, 5"})
    void copterThatGoesOnInAutoIsToldSoAndHasThatBitAloneCleared(LostLinkAction wanted, int enable) {
        copter.parameter(OPTIONS, 18);
        LinkClient client = linked();
        try {
            says(client, LostLinkAction.CONTINUE, "FS_GCS_ENABLE 1, FS_OPTIONS 18");

            assertThat(client.ask(new SetLostLinkAction("wish", wanted))).isInstanceOf(Ack.class);

            assertThat(copter.parameter(OPTIONS)).isEqualTo(16);
            assertThat(copter.parameter(ENABLE)).isEqualTo(enable);
            says(client, wanted, "FS_GCS_ENABLE " + enable);
            assertThat(client.hasAlarm("somebody else")).isFalse();
        } finally {
            client.close();
        }
    }

    @Test
    void bitForModesOfPilotsChangesNothingOnMissions() {
        LinkClient client = linked();
        try {
            says(client, LostLinkAction.RETURN, "FS_GCS_ENABLE 1");
        } finally {
            client.close();
        }
    }

    @Test
    void bitThatAnotherStationSetsIsAnAlarmAndInForce() {
        LinkClient client = linked();
        try {
            says(client, LostLinkAction.RETURN, "FS_GCS_ENABLE 1");

            copter.setByAnother(OPTIONS, 18);

            client.untilAlarm(
                    "what vehicle 6 does when its link is lost was changed by somebody else: FS_OPTIONS 18, before 16");
            says(client, LostLinkAction.CONTINUE, "FS_GCS_ENABLE 1, FS_OPTIONS 18");
        } finally {
            client.close();
        }
    }
}
