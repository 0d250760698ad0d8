package org.sami.boat.link;

/** What a boat does by itself when the link to its commander is lost. */
public enum LostLinkAction {
    /** Keep station where it is. */
    HOLD,
    /** Drive to the home position and keep station there. */
    RETURN,
    /** Go on with the waypoint list, if it is on one; otherwise as {@link #HOLD}. */
    CONTINUE,
    /** Motors to zero; what flies lands where it is. */
    DRIFT
}
