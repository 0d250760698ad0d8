package org.sami.session.rows;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Base64;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SettingsReport;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.boat.BoatSnapshot.Commander;
import org.sami.crw.proxy.explanation.BoatExplanation;
import org.sami.crw.proxy.explanation.BoatExplanation.Cause;
import org.sami.crw.proxy.status.BoatTuning;
import org.sami.crw.proxy.status.LinkState;
import org.sami.crw.proxy.status.StopLatch;

/** What a front is told of a boat's settings. */
class SettingRowsTest {
    private static final BoatTuning OWN =
            BoatTuning.of(new SettingsReport(new Gains(1, 0, 0), new Gains(2, 0, 0), 0.5, LostLinkAction.CONTINUE)
                    .withActionBy("FS_GCS_ENABLE 0"));

    private static BoatSnapshot boat() {
        return new BoatSnapshot(
                "mav86",
                LinkState.LINKED,
                OptionalLong.empty(),
                Optional.empty(),
                0,
                Optional.empty(),
                Optional.empty(),
                Commander.THIS_BASE,
                Optional.empty(),
                0,
                0,
                new BoatExplanation(false, Cause.NO_COMMAND, "mav86 rests"),
                Optional.empty(),
                StopLatch.NONE,
                List.of(),
                Optional.of(OWN));
    }

    @Test
    void frontElsewhereReadsTheSettingsWithTheParametersByWhichAVehicleActsWithoutALink() throws Exception {
        String report = BoatRows.settings(List.of(boat()))
                .rows()
                .get("mav86")
                .path("report")
                .asText();

        SettingsReport read =
                (SettingsReport) LinkCodec.readBody(Base64.getDecoder().decode(report));

        assertThat(BoatTuning.of(read)).isEqualTo(OWN);
        assertThat(OWN.lostLinkBy()).isEqualTo("FS_GCS_ENABLE 0");
    }
}
