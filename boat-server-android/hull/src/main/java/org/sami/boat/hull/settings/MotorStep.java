package org.sami.boat.hull.settings;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;

/** What the {@link MotorCheck} tries, and what may be answered. */
public enum MotorStep {
    /** The left motor of two. */
    LEFT_AHEAD(
            "left motor forward: does it push forward?",
            MotorAnswer.YES,
            MotorAnswer.REVERSED,
            MotorAnswer.OTHER_SIDE,
            MotorAnswer.NOTHING),
    /** The right motor of two. */
    RIGHT_AHEAD(
            "right motor forward: does it push forward?",
            MotorAnswer.YES,
            MotorAnswer.REVERSED,
            MotorAnswer.OTHER_SIDE,
            MotorAnswer.NOTHING),
    /** The motor of a rudder hull. */
    THRUST_AHEAD("motor forward: does it push forward?", MotorAnswer.YES, MotorAnswer.REVERSED, MotorAnswer.NOTHING),
    /** The rudder of a rudder hull. */
    RUDDER_STARBOARD(
            "rudder to the right: would the boat turn right?",
            MotorAnswer.YES,
            MotorAnswer.REVERSED,
            MotorAnswer.NOTHING),
    /** The most thrust at which motors, controllers and battery keep running: raised with each yes. */
    MOST_THRUST(
            "thrust at %s %% of full: did everything keep running?",
            MotorAnswer.YES, MotorAnswer.ENOUGH, MotorAnswer.FALTERED, MotorAnswer.LATER),
    /** Whether the hull goes straight, afloat: each answer that it turns changes the trim. */
    STRAIGHT(
            "afloat, on a long line: straight ahead with trim %s %%: does it go straight?",
            MotorAnswer.YES, MotorAnswer.PULLS_LEFT, MotorAnswer.PULLS_RIGHT, MotorAnswer.LATER);

    private final String question;
    private final List<MotorAnswer> answers;

    MotorStep(String question, MotorAnswer... answers) {
        this.question = question;
        this.answers = Collections.unmodifiableList(Arrays.asList(answers));
    }

    /** What is asked of a person, with a place {@code %s} for a number where the step has one. */
    String question() {
        return question;
    }

    /** What may be answered. */
    public List<MotorAnswer> answers() {
        return answers;
    }
}
