package org.sami.boat.hull.position;

/** What is doubtful about a position, for as long as it is. */
public enum PositionDoubt {
    /** No position has come for two seconds, or none yet. */
    NO_GPS("no GPS position"),
    /** The receiver gives positions that make no sense: 0,0, no numbers, or far from each other. */
    GPS_IMPLAUSIBLE("GPS positions make no sense"),
    /** The compass does not fit the course over ground. */
    COMPASS_DISAGREES("compass and course over ground disagree"),
    /** There is no compass: the heading comes from the course over ground, and from the motors where there is no gyro. */
    NO_COMPASS("no compass: heading from course over ground");

    private final String words;

    PositionDoubt(String words) {
        this.words = words;
    }

    /** It in words for people. */
    public String words() {
        return words;
    }
}
