package org.sami.boat.link;

/**
 * Numbers that hold on both sides of the link. A base and its boats must use the same ones and do not send them to each other. {@code crw defaults}
 * prints them.
 */
public final class SharedDefaults {
    /** A link is lost after this time in ms without a frame; what is known of the other side is then stale. */
    public static final long LINK_LOST_AFTER_MS = 3500;

    /** Each side sends a frame at least this often, in ms. */
    public static final long HEARTBEAT_MS = 1000;

    /** Telemetry messages a second where a client asks for no other rate. */
    public static final double TELEMETRY_HZ = 1;

    /** Speed in m/s of paths that name none, and of ways home. */
    public static final double CRUISE_SPEED_MPS = 1.5;

    /** A boat within this distance of a location, in metres, has reached it. */
    public static final double ARRIVAL_RADIUS_M = 3;

    /** A boat that keeps its station drifts up to this distance in metres before it drives back. */
    public static final double HOLD_RADIUS_M = 5;

    /** Distance in metres that boats keep from each other; planners leave room for it. */
    public static final double SEPARATION_M = 3.5;

    /** A rise of the charge by this much, in percent of full, means that the battery was charged or swapped. */
    public static final double RECHARGED_PERCENT = 5;

    private SharedDefaults() {}
}
