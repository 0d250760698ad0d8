package org.sami.boat.server;

import org.sami.boat.link.Gains;

/**
 * Limits and gains of a boat's server, unless its configuration has others. Speeds, batteries and the link have their {@code *Defaults} in
 * {@code org.sami.boat.link}. {@code crw defaults} prints them.
 */
public final class BoatServerDefaults {
    /** The longest waypoint list that a boat takes. */
    public static final int MAX_WAYPOINTS = 20_000;

    /** Most bytes of a boat's log, over all of its files. */
    public static final long LOG_BYTES = 32L << 20;

    /** Gains of the heading loop. */
    public static final Gains HEADING_GAINS = new Gains(1.2, 0, 0);

    /** Gains of the speed loop. */
    public static final Gains SPEED_GAINS = new Gains(0.3, 0.05, 0);

    private BoatServerDefaults() {}
}
