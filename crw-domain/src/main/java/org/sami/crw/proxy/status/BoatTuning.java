package org.sami.crw.proxy.status;

import java.util.Objects;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SettingsReport;

/**
 * The settings in force on a boat, as it has reported.
 *
 * @param heading gains of the heading loop
 * @param speed gains of the speed loop
 * @param velocityMultiplier factor on the speed of every leg
 * @param lostLinkAction action when the link to its commander is lost
 */
public record BoatTuning(Gains heading, Gains speed, double velocityMultiplier, LostLinkAction lostLinkAction) {
    public BoatTuning {
        Objects.requireNonNull(heading, "heading");
        Objects.requireNonNull(speed, "speed");
        Objects.requireNonNull(lostLinkAction, "lostLinkAction");
    }

    /** Those of a report. */
    public static BoatTuning of(SettingsReport report) {
        return new BoatTuning(
                report.gains(GainAxis.HEADING),
                report.gains(GainAxis.SPEED),
                report.velocityMultiplier(),
                report.lostLinkAction());
    }
}
