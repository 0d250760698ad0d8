package org.sami.boat.server.traffic;

/** How small hulls stop: they go straight on for a reaction time and then brake. */
final class Stopping {
    /** Seconds until a decision takes effect and others know of it. */
    static final double REACTION_S = 0.3;

    /** Deceleration with motors astern, in m/s². */
    private static final double BRAKING_MPS2 = 0.5;

    private Stopping() {}

    /**
     * The stopping distance in metres; negative astern.
     *
     * @param speedMps m/s ahead, negative astern
     * @param reactionS how long the boat holds its speed before it brakes, in seconds
     */
    static double distanceM(double speedMps, double reactionS) {
        return speedMps * reactionS + speedMps * Math.abs(speedMps) / (2 * BRAKING_MPS2);
    }

    /** The stopping segment: where a boat is until it has stopped, on the plane of {@link Surroundings}. */
    static Segment segment(double eastM, double northM, CourseVector heading, double speedMps, double reactionS) {
        return Segment.along(eastM, northM, distanceM(speedMps, reactionS), heading.east(), heading.north());
    }
}
