package org.sami.crw.service.reach;

/**
 * How long the charge of an aircraft's battery keeps it in the air: it pays for time, also where it hovers. Immutable.
 *
 * @param percent charge of full, 0 to 100
 * @param percentPerS charge that a second in the air takes, in percent, more than 0
 * @param isSeen whether that was seen of this aircraft; else it is what is assumed of any
 */
public record Endurance(double percent, double percentPerS, boolean isSeen) {
    /** How long a full battery is assumed to last in the air as long as nothing was seen of the aircraft's own, in seconds: 25 minutes. */
    public static final double USUAL_S = 25 * 60;

    /** The charge with which an aircraft is to be on the ground again, in percent: at this our copters turn critical. */
    public static final double LANDING_PERCENT = 20;

    private static final double FULL_PERCENT = 100;

    /** Refuses a time in the air that costs nothing. */
    public Endurance {
        if (!(percentPerS > 0 && percentPerS < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a second in the air takes more than 0 % of charge, not " + percentPerS);
        }
    }

    /** That of an aircraft of which it was seen what a second in the air takes. */
    public static Endurance seen(double percent, double percentPerS) {
        return new Endurance(percent, percentPerS, true);
    }

    /** That of an aircraft that has not flown far enough to know it: {@link #USUAL_S}. */
    public static Endurance usual(double percent) {
        return new Endurance(percent, FULL_PERCENT / USUAL_S, false);
    }

    /** How long it may stay in the air until it is to be down, in seconds; 0 where it has less charge than it is to land with. */
    public double seconds() {
        return Math.max(0, percent - LANDING_PERCENT) / percentPerS;
    }
}
