package org.sami.crw.service.coverage;

import java.util.Locale;

/**
 * The strip that boats likely miss between lanes because their positions err. Two neighbouring lanes are driven at different times, so their errors
 * are independent: where the errors point apart by more than the overlap of the lanes, a strip as wide as the difference is missed. For two normal
 * errors with deviation σ its mean width is σ/√π where lanes do not overlap (docs/services.md).
 */
final class MissedBetweenLanes {
    private static final double LEAST_SHARE = 0.005;

    private MissedBetweenLanes() {}

    /**
     * The part of the area that is likely missed, 0 to 1.
     *
     * @param positionM standard deviation of the boats' positions, in metres
     * @param laneM distance between two lanes, in metres
     * @param spacingM width of the strip that a boat covers, in metres, at least {@code laneM}
     */
    static double share(double positionM, double laneM, double spacingM) {
        double deviationM = positionM * Math.sqrt(2);
        if (deviationM == 0) {
            return 0;
        }
        double overlap = Math.max(0, spacingM - laneM) / deviationM;
        double density = Math.exp(-overlap * overlap / 2) / Math.sqrt(2 * Math.PI);
        return Math.min(1, deviationM * (density - overlap * tail(overlap)) / laneM);
    }

    /** The probability that a standard normal error exceeds a number from 0 (M. Abramowitz, I. Stegun, 26.2.17). */
    private static double tail(double number) {
        double t = 1 / (1 + 0.2316419 * number);
        double series =
                t * (0.319381530 + t * (-0.356563782 + t * (1.781477937 + t * (-1.821255978 + t * 1.330274429))));
        return series * Math.exp(-number * number / 2) / Math.sqrt(2 * Math.PI);
    }

    /** The same in words, to go on with after what is certain; empty where next to nothing is missed. */
    static String words(double positionM, double laneM, double spacingM) {
        double share = share(positionM, laneM, spacingM);
        return share < LEAST_SHARE
                ? ""
                : String.format(
                        Locale.ROOT,
                        "; as positions err by %.1f m, about %.0f %% are likely missed between the lanes unseen",
                        positionM,
                        Math.max(1, 100 * share));
    }
}
