package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.boat.mavlink.DrivenBoat.STATION;

import org.junit.jupiter.api.Test;
import org.sami.boat.link.LostLinkAction;
import org.sami.mavlink.onboard.OnboardParameter;

/** What ground stations set of a boat that they command. */
class BoatParametersTest {
    private final DrivenBoat boat = new DrivenBoat(LostLinkAction.RETURN);

    private void set(String name, double value) {
        assertThat(boat.command.take(STATION, boat.nowMs)).isEmpty();
        assertThat(boat.parameters.set(name, value, boat.nowMs).isAccepted()).isTrue();
        boat.pass(200, STATION);
    }

    private double value(String name) {
        return boat.parameters.all().stream()
                .filter(each -> each.name().equals(name))
                .mapToDouble(OnboardParameter::value)
                .findFirst()
                .orElseThrow();
    }

    private LostLinkAction action() {
        return boat.client.settings().orElseThrow().lostLinkAction();
    }

    @Test
    void aFailsafeThatIsSwitchedOffAndOnDoesWhatItDidBefore() {
        for (int on : new int[] {1, 0, 1}) {
            set("FS_GCS_ENABLE", on);

            assertThat(value("FS_GCS_ENABLE")).isEqualTo(on);
            assertThat(value("FS_ACTION")).isEqualTo(1);
            assertThat(action()).isEqualTo(on == 1 ? LostLinkAction.RETURN : LostLinkAction.CONTINUE);
        }
    }

    @Test
    void anActionThatIsSetWhileTheFailsafeIsOffIsDoneOnceItIsOn() {
        set("FS_GCS_ENABLE", 0);
        set("FS_ACTION", 2);
        assertThat(action()).isEqualTo(LostLinkAction.CONTINUE);

        set("FS_GCS_ENABLE", 1);
        assertThat(action()).isEqualTo(LostLinkAction.DRIFT);
    }
}
