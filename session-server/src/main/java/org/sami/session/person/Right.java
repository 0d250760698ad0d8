package org.sami.session.person;

import java.util.Locale;

/** What a person may do in a session. */
public enum Right {
    /** Stop the whole fleet. */
    STOP,
    /** Answer decisions, stop their timers, acknowledge, write notes. */
    ANSWER,
    /** Press interrupts, release the fleet stop. */
    PRESS,
    /** Start and abort missions. */
    START,
    /** Drive boats by hand. */
    DRIVE,
    /** Set up boats: the settings in force on them. */
    SETUP;

    /** Its name in messages. */
    public String word() {
        return name().toLowerCase(Locale.ROOT);
    }
}
