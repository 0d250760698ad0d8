package org.sami.crw.operator.mission;

/** How a transition at a marked place may come to fire. */
enum Outlook {
    /** What it waits for is under way: a command, a timer, a question, a computation, a sub-mission. */
    UNDER_WAY,
    /** It waits for news that come by themselves, maybe never: a reading, a battery, a boat in an area. */
    NEWS,
    /** It waits for a press of an interrupt. */
    PRESS,
    /** It waits for tokens that other transitions may bring, or for a command that nobody has sent yet. */
    OTHERS,
    /** What it waits for has failed and will not come. */
    NEVER
}
