package org.sami.boat.link;

/** What a boat is doing. */
public enum BoatMode {
    /** Motors at zero; the boat drifts. */
    STOPPED,
    /** On the way along its waypoint list. */
    PATH,
    /** Keeping its station inside a radius. */
    HOLD,
    /** Driven by hand. */
    TELEOPERATION,
    /** On the way to its home position because the link was lost. */
    RETURN,
    /** Stopped for the whole fleet: motors at zero until released. */
    FLEET_STOP;

    /** Whether a boat in this mode is under way, even while it waits for others to pass. */
    public boolean isUnderWay() {
        return this == PATH || this == TELEOPERATION || this == RETURN;
    }
}
