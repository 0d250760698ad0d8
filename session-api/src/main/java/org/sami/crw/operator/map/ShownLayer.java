package org.sami.crw.operator.map;

/** A layer of the map; drawn in this order, the last on top. */
public enum ShownLayer {
    /** What sensors measured. */
    SENSOR_DATA("sensor data", false),
    /** Areas that plans and the project speak of. */
    AREAS("areas", true),
    /** Areas that boats are not to enter. */
    NO_GO("no-go areas", true),
    /** The area that boats are to stay in. */
    FENCE("fence", true),
    /** The part of the map that an event speaks of (markup Relevant Area). */
    RELEVANT_AREA("relevant area", true),
    /** Places that plans and the project speak of. */
    PLACES("places", true),
    /** Where boats were. */
    PAST_PATHS("past paths", true),
    /** Where boats will be sent when they have done what they do now. */
    FUTURE_PATHS("future paths", false),
    /** Where boats are going now. */
    CURRENT_PATHS("current paths", true),
    /** Where boats without a link are expected to come home by themselves. */
    WAYS_HOME("expected ways home", true),
    /** The boats. */
    BOATS("boats", true),
    /** Battery and speed next to each boat. */
    BOAT_STATE("state of boats", false);

    private final String label;
    private final boolean onByDefault;

    ShownLayer(String label, boolean onByDefault) {
        this.label = label;
        this.onByDefault = onByDefault;
    }

    /** What people call it. */
    public String label() {
        return label;
    }

    /** Whether it is drawn where neither a person nor a markup says otherwise. */
    public boolean isOnByDefault() {
        return onByDefault;
    }
}
