package org.sami.crw.proxy.status;

import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.BoatPerformance;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SettingsReport;

/**
 * The settings in force on a boat, how its control board is, and how far, how fast and how narrowly it drives, as it has reported.
 *
 * @param heading gains of the heading loop
 * @param speed gains of the speed loop
 * @param velocityMultiplier factor on the speed of every leg
 * @param lostLinkAction action when the link to its commander is lost
 * @param board how its control board is; empty for a boat without one, or an earlier one
 * @param capabilities what it cannot do and what it measures, where it says so
 * @param performance how far, how fast and how narrowly it drives, where it says so
 * @param lostLinkBy which settings of its own make it do the lost-link action, such as {@code FS_GCS_ENABLE 0}; empty text where it does not say it
 */
public record BoatTuning(
        Gains heading,
        Gains speed,
        double velocityMultiplier,
        LostLinkAction lostLinkAction,
        Optional<BoardCondition> board,
        BoatCapabilities capabilities,
        BoatPerformance performance,
        String lostLinkBy) {
    /** Those of a boat that does not say which settings of its own make it do the lost-link action. */
    public BoatTuning(
            Gains heading,
            Gains speed,
            double velocityMultiplier,
            LostLinkAction lostLinkAction,
            Optional<BoardCondition> board,
            BoatCapabilities capabilities,
            BoatPerformance performance) {
        this(heading, speed, velocityMultiplier, lostLinkAction, board, capabilities, performance, "");
    }

    /** Those of a boat that says nothing of what it can do. */
    public BoatTuning(
            Gains heading,
            Gains speed,
            double velocityMultiplier,
            LostLinkAction lostLinkAction,
            Optional<BoardCondition> board) {
        this(
                heading,
                speed,
                velocityMultiplier,
                lostLinkAction,
                board,
                BoatCapabilities.UNKNOWN,
                BoatPerformance.UNKNOWN);
    }

    /** Those of a boat without a control board. */
    public BoatTuning(Gains heading, Gains speed, double velocityMultiplier, LostLinkAction lostLinkAction) {
        this(heading, speed, velocityMultiplier, lostLinkAction, Optional.empty());
    }

    public BoatTuning {
        Objects.requireNonNull(heading, "heading");
        Objects.requireNonNull(speed, "speed");
        Objects.requireNonNull(lostLinkAction, "lostLinkAction");
        Objects.requireNonNull(board, "board");
        Objects.requireNonNull(capabilities, "capabilities");
        Objects.requireNonNull(performance, "performance");
        Objects.requireNonNull(lostLinkBy, "lostLinkBy");
    }

    /** Those of a report. */
    public static BoatTuning of(SettingsReport report) {
        return new BoatTuning(
                report.gains(GainAxis.HEADING),
                report.gains(GainAxis.SPEED),
                report.velocityMultiplier(),
                report.lostLinkAction(),
                report.board(),
                report.capabilities(),
                report.performance(),
                report.actionBy());
    }
}
