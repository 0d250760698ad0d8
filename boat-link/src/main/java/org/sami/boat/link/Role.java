package org.sami.boat.link;

/** What a client of a boat may do. Several may observe; one commands. */
public enum Role {
    /** May command the boat; the loss of its link is the boat's lost link. */
    COMMANDER,
    /** Sees what the boat reports; its commands are refused. */
    OBSERVER
}
