package org.sami.boat.link;

/**
 * Times of the link, and what a boat does without one. A base and its boats must use the same times and do not send them to each other.
 * {@code crw defaults} prints them.
 */
public final class LinkDefaults {
    /** A link is lost after this time in ms without a frame; what is known of the other side is then stale. */
    public static final long LINK_LOST_AFTER_MS = 3500;

    /** Each side sends a frame at least this often, in ms. */
    public static final long HEARTBEAT_MS = 1000;

    /** Telemetry messages a second where a client asks for no other rate. */
    public static final double TELEMETRY_HZ = 1;

    /** What a boat does when the link to its commander is lost. */
    public static final LostLinkAction LOST_LINK_ACTION = LostLinkAction.HOLD;

    /** Teleoperation stops the motors after this time in ms without a new setting. */
    public static final long TELEOPERATION_STOP_MS = 2000;

    private LinkDefaults() {}
}
