package org.sami.crw.service.reach;

/**
 * The charge of a boat's battery, and how far it takes that boat. Immutable.
 *
 * @param percent of full, 0 to 100
 * @param metresPerPercent how far one percent takes the boat on average, in metres, more than 0
 */
public record Charge(double percent, double metresPerPercent) {
    /** Refuses a distance that is not positive. */
    public Charge {
        if (!(metresPerPercent > 0 && metresPerPercent < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(
                    "a percent of charge takes a boat farther than 0 m, not " + metresPerPercent);
        }
    }

    /** That of a boat which does not say how far a percent takes it: {@link Range#METRES_PER_PERCENT}. */
    public static Charge usual(double percent) {
        return new Charge(percent, Range.METRES_PER_PERCENT);
    }

    /** How far it lasts on average, in metres. */
    public double meanM() {
        return percent * metresPerPercent;
    }

    /** How far it is sure to last, in metres: also where each metre costs the most. */
    public double sureM() {
        return percent * metresPerPercent / Range.COSTLIEST_METRE;
    }

    /** What so many metres take of it on average, in percent of full. */
    public double usedPercent(double metres) {
        return metres / metresPerPercent;
    }
}
