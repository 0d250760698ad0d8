package org.sami.boat.link;

/** Which of the boat's two control loops a set of gains is for. */
public enum GainAxis {
    /** From heading error (rad) to steering effort. */
    HEADING,
    /** From speed error (m/s) to thrust, on top of the feed-forward. */
    SPEED
}
