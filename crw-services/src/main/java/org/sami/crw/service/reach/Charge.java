package org.sami.crw.service.reach;

/**
 * The charge of a boat's battery, and how far it takes that boat. Immutable.
 *
 * @param percent of full, 0 to 100
 * @param metresPerPercent how far one percent takes the boat on average, in metres, more than 0
 * @param homewardMetresPerPercent the same on its way home, where it may drive at another speed
 */
public record Charge(double percent, double metresPerPercent, double homewardMetresPerPercent) {
    /** Refuses a distance that is not positive. */
    public Charge {
        positive(metresPerPercent);
        positive(homewardMetresPerPercent);
    }

    /** That of a boat that drives out and home at one speed. */
    public Charge(double percent, double metresPerPercent) {
        this(percent, metresPerPercent, metresPerPercent);
    }

    private static void positive(double metres) {
        if (!(metres > 0 && metres < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("a percent of charge takes a boat farther than 0 m, not " + metres);
        }
    }

    /** The same charge on a way out on which a percent takes the boat another distance, in metres. */
    public Charge outward(double metres) {
        return new Charge(percent, metres, homewardMetresPerPercent);
    }

    /** The way out that costs as much as a way home, both in metres. */
    public double outwardM(double homewardM) {
        return homewardM * (metresPerPercent / homewardMetresPerPercent);
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
