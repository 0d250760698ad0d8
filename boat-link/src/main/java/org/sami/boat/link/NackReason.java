package org.sami.boat.link;

/** Why a boat refused a command. */
public enum NackReason {
    /** The sender has not said hello. */
    NOT_GREETED,
    /** The sender only observes. */
    NOT_COMMANDER,
    /** Another session has been appointed commander since; the detail names it. */
    SUPERSEDED,
    /** No other client of the name in the grant is linked. */
    UNKNOWN_CLIENT,
    /** The frame could not be read. */
    MALFORMED,
    /** The boat does not hold the waypoint list that the command speaks of. */
    UNKNOWN_LIST,
    /** The index lies behind the end of the list. */
    BAD_INDEX,
    /** The list has more waypoints than the boat keeps. */
    TOO_LONG,
    /** The boat has no camera. */
    NO_CAMERA,
    /** The fleet stop is latched. */
    FLEET_STOPPED,
    /** The command is older than one that the boat has already taken. */
    STALE,
    /** The sender has used the id for another command. */
    ID_TAKEN,
    /** The boat cannot keep on its disk what the command changes. */
    NOT_KEPT,
    /** The boat cannot do it, or not now; the detail says why, in its own words. */
    NOT_ABLE,
    /** The sender, or all clients together, ask too often; later it may be granted. */
    TOO_OFTEN
}
