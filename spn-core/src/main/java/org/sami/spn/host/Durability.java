package org.sami.spn.host;

/** What a batch of the journal must survive before its effects leave (decision 0030). */
public enum Durability {
    /** The death of the process; the loss of power may cost the last 100 ms. */
    PROCESS,
    /** The loss of power as well: asked for before a command leaves to a robot. */
    POWER
}
