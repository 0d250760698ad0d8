package org.sami.crw.cli.legacy;

/**
 * How imported plans are tried.
 *
 * @param boats simulated boats that each run begins with
 * @param locations how many the simulated operator gives where it is asked for some
 * @param areaM side of the square in which they lie, in metres
 * @param millis how long each run takes at most, in simulated milliseconds
 * @param answerAfterMillis after how long the simulated operator answers, in simulated milliseconds
 * @param pressEveryMillis how far apart the presses of one interrupt are on average, in simulated milliseconds
 * @param seed where all chance comes from
 */
public record TrialSettings(
        int boats, int locations, double areaM, long millis, long answerAfterMillis, long pressEveryMillis, long seed) {
    /** Three boats, one hour, and an area that they explore in half of it, interrupts included. */
    public static TrialSettings of(long seed) {
        return new TrialSettings(3, 8, 100, 3_600_000, 5_000, 300_000, seed);
    }
}
