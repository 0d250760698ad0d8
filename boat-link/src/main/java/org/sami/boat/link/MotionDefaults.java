package org.sami.boat.link;

/**
 * Speeds and distances of boats that hold where nothing else is asked for. A base and its boats must use the same ones and do not send them to each other. {@code crw defaults}
 * prints them.
 */
public final class MotionDefaults {
    /** Speed in m/s of paths that name none, and of ways home. */
    public static final double CRUISE_SPEED_MPS = 1.5;

    /** A boat within this distance of a location, in metres, has reached it. */
    public static final double ARRIVAL_RADIUS_M = 3;

    /** A boat that keeps its station drifts up to this distance in metres before it drives back. */
    public static final double HOLD_RADIUS_M = 5;

    /** Distance in metres that boats keep from each other; planners leave room for it. */
    public static final double SEPARATION_M = 3.5;

    /** Speed in m/s that full thrust gives in still water. */
    public static final double FULL_THRUST_SPEED_MPS = 3.2;

    /** How fast small hulls slow down with motors at rest, in m/s per second. */
    public static final double BRAKING_MPS2 = 0.35;

    private MotionDefaults() {}
}
