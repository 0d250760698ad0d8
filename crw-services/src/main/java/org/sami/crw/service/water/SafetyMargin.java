package org.sami.crw.service.water;

/**
 * Distances that plans keep from no-go areas and between waiting boats, so that boats with this cross-track error stay out of the areas and get past each
 * other (docs/services.md).
 */
public record SafetyMargin(CrossTrackError error) {
    private static final double POSITION_DEVIATIONS = 3; // exceeded once in some hours
    private static final double SEPARATION_DEVIATIONS =
            1.5; // of the distance between two boats, added to their separation
    private static final double STATION_M = 1.5; // boats that drift come closer to their stations by so much
    private static final double ROUNDING_M =
            0.01; // ways are planned on one plane, given in degrees, and measured on another

    /** How far paths keep off what is forbidden where there is room, in metres. */
    public double pathM() {
        return error.steeringM() + POSITION_DEVIATIONS * error.positionM() + CrossTrackError.TURN_S * error.driftMps();
    }

    /**
     * How far from one another boats are to lie so that others find a way between them, in metres.
     *
     * @param separationM the distance that boats keep from each other, in metres
     */
    public double berthM(double separationM) {
        double apartM = separationM + SEPARATION_DEVIATIONS * Math.sqrt(2) * error.positionM();
        return 2 * (apartM + (error.driftMps() > 0 ? STATION_M : 0));
    }

    /** How far a boat may come into what its path passes at a distance, in metres; zero where it may not. */
    public double insideM(double clearanceM) {
        double insideM = error.mostM() - clearanceM;
        return insideM > ROUNDING_M ? insideM : 0;
    }
}
