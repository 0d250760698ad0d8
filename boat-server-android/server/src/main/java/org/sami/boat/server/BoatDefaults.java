package org.sami.boat.server;

import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;

/**
 * Numbers of a boat's server that hold unless its configuration says otherwise, besides those that a base must know as well (the {@code *Defaults} of
 * {@code org.sami.boat.link}). {@code crw defaults} prints them.
 */
public final class BoatDefaults {
    /** Speed in m/s that full thrust gives in still water. */
    public static final double FULL_THRUST_SPEED_MPS = 3.2;

    /** What a boat does when the link to its commander is lost. */
    public static final LostLinkAction LOST_LINK_ACTION = LostLinkAction.HOLD;

    /** Teleoperation stops the motors after this time in ms without a new setting. */
    public static final long TELEOPERATION_STOP_MS = 2000;

    /** Charge in percent below which the battery is low. */
    public static final double LOW_BATTERY_PERCENT = 30;

    /** Charge in percent below which the battery is critical, wherever the boat is. */
    public static final double CRITICAL_BATTERY_PERCENT = 15;

    /**
     * The battery is also critical where it holds less than this many times the way home: a tenth for metres that cost more than the mean, a quarter for
     * a current or an unknown detour.
     */
    public static final double HOME_RESERVE_FACTOR = 1.4;

    /** The longest waypoint list that a boat takes. */
    public static final int MAX_WAYPOINTS = 20_000;

    /** Most bytes of a boat's log, over all of its files. */
    public static final long LOG_BYTES = 32L << 20;

    /** Gains of the heading loop. */
    public static final Gains HEADING_GAINS = new Gains(1.2, 0, 0);

    /** Gains of the speed loop. */
    public static final Gains SPEED_GAINS = new Gains(0.3, 0.05, 0);

    private BoatDefaults() {}
}
