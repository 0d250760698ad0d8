package org.sami.mavlink.link;

/** How far a link is. */
public enum MavlinkLinkState {
    /** It is being opened for the first time. */
    OPENING,
    /** It is open; whether anybody speaks on it is another question. */
    OPEN,
    /** It could not be opened, or it broke; it is tried again. */
    BROKEN
}
