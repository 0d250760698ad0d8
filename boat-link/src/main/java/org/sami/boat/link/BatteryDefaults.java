package org.sami.boat.link;

/**
 * Numbers of batteries. A base and its boats must use the same ones and do not send them to each other. {@code crw defaults}
 * prints them.
 */
public final class BatteryDefaults {
    /** A rise of the charge by this much, in percent of full, means that the battery was charged or swapped. */
    public static final double RECHARGED_PERCENT = 5;

    private BatteryDefaults() {}
}
