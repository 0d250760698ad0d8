package org.sami.crw.proxy;

import org.sami.spn.protocol.Priority;

/** What a mission wants one boat to do. */
public sealed interface BoatCommand permits FollowPath, KeepStation, Panorama, Stop {

    /**
     * Names this command among all that the boat ever gets, by a rule of the caller that a repeated run follows again, such
     * as {@code m3-a17-boat2}.
     */
    String commandId();

    /** The mission that wants it. */
    long mission();

    /** The activation that asked for it. */
    long activation();

    /** Its rank in the boat's queue. */
    Priority priority();

    /**
     * Whether the boat is kept for this mission from the moment the command runs until the mission ends: commands of other
     * missions then wait, but for critical ones.
     */
    boolean block();
}
