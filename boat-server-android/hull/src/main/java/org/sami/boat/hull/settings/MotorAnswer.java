package org.sami.boat.hull.settings;

/** What a person saw at a step of the {@link MotorCheck}. */
public enum MotorAnswer {
    /** It was as asked. */
    YES("yes"),
    /** The other way round. */
    REVERSED("the other way round"),
    /** The motor on the other side turned. */
    OTHER_SIDE("the motor on the other side"),
    /** Nothing moved. */
    NOTHING("nothing moved"),
    /** A motor stopped, or a controller or the board restarted. */
    FALTERED("no: a motor stopped or the board restarted"),
    /** Everything ran at that thrust, and more is not needed. */
    ENOUGH("yes, and that is enough thrust"),
    /** The hull turned to the left. */
    PULLS_LEFT("it turns left"),
    /** The hull turned to the right. */
    PULLS_RIGHT("it turns right"),
    /** The setting stays as it was before the check. */
    LATER("not now: leave it as it was");

    private final String words;

    MotorAnswer(String words) {
        this.words = words;
    }

    /** What a person says. */
    public String words() {
        return words;
    }
}
