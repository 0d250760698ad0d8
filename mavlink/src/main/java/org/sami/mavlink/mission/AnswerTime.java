package org.sami.mavlink.mission;

/**
 * How long to wait for an answer of a vehicle before sending again: twice the time of its recent answers, and longer after each try without an answer. That is
 * about 0.05 s on a cable and more than 1 s on a slow radio.
 */
final class AnswerTime {
    private static final double UNKNOWN_MS = 700;
    private static final double MOST_MS = 1_500; // the protocol's own time
    private static final double LEAST_MS = 40;
    private static final double GROWTH = 1.4;
    private static final double NEW_PART = 0.2;
    private static final double MARGIN = 2;

    private double tookMs = Double.NaN;

    /** An answer came to what was sent once. */
    void answered(long ms) {
        tookMs = Double.isNaN(tookMs) ? ms : tookMs + NEW_PART * (ms - tookMs);
    }

    /** How long to wait for an answer; {@code tries} is how often it was sent in vain before. */
    long waitMs(int tries) {
        double first = Double.isNaN(tookMs) ? UNKNOWN_MS : Math.max(LEAST_MS, MARGIN * tookMs);
        return Math.round(Math.min(MOST_MS, first * Math.pow(GROWTH, tries)));
    }
}
