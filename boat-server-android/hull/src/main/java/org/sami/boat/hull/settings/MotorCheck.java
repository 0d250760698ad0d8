package org.sami.boat.hull.settings;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * The guided check of a hull's motors, on land or tied up: each step drives something for two seconds and asks what a person saw. The answers become
 * settings. A model without a screen; one thread.
 */
public final class MotorCheck {
    /** How long a step drives, in ms. */
    public static final long STEP_MS = 2000;

    private static final double EFFORT = 0.3;

    /** What was seen. */
    public enum Answer {
        /** It was as asked. */
        YES,
        /** The other way round. */
        REVERSED,
        /** The motor on the other side turned. */
        OTHER_SIDE,
        /** Nothing moved. */
        NOTHING
    }

    /** What is tried. */
    public enum Step {
        /** The left motor of two. */
        LEFT_AHEAD("left motor forward: does it push forward?"),
        /** The right motor of two. */
        RIGHT_AHEAD("right motor forward: does it push forward?"),
        /** The motor of a rudder hull. */
        THRUST_AHEAD("motor forward: does it push forward?"),
        /** The rudder of a rudder hull. */
        RUDDER_STARBOARD("rudder to the right: would the boat turn right?");

        private final String question;

        Step(String question) {
            this.question = question;
        }

        /** What is asked of a person. */
        public String question() {
            return question;
        }
    }

    private final MotorDrive motors;
    private final HullSettings before;
    private final List<Step> steps;
    private final HullSettings.Builder result;
    private int at;
    private boolean driven;
    private String trouble = "";

    /** Begins the check of a hull with these settings; nothing moves yet. */
    public MotorCheck(HullSettings hull, MotorDrive motors) {
        this.motors = motors;
        before = hull;
        result = hull.change();
        List<Step> asked = new ArrayList<>();
        if (hull.kind() == HullKind.RUDDER) {
            asked.add(Step.THRUST_AHEAD);
            asked.add(Step.RUDDER_STARBOARD);
        } else {
            asked.add(Step.LEFT_AHEAD);
            asked.add(Step.RIGHT_AHEAD);
        }
        steps = Collections.unmodifiableList(asked);
    }

    /** All steps, in their order. */
    public List<Step> steps() {
        return steps;
    }

    /** The step that is due; empty at the end. */
    public Optional<Step> step() {
        return at < steps.size() ? Optional.of(steps.get(at)) : Optional.empty();
    }

    /** Drives what the step is about, again if asked again; whether it does. Not while the board is gone or the boat is under way. */
    public boolean drive() {
        if (!step().isPresent()) {
            return false;
        }
        switch (step().get()) {
            case LEFT_AHEAD:
                driven = motors.drive(EFFORT, 0, STEP_MS);
                break;
            case RIGHT_AHEAD:
                driven = motors.drive(0, EFFORT, STEP_MS);
                break;
            case THRUST_AHEAD:
                driven = motors.drive(EFFORT, EFFORT, STEP_MS);
                break;
            default:
                driven = motors.drive(1, -1, STEP_MS);
                break;
        }
        return driven;
    }

    /**
     * What a person saw. After {@link Answer#NOTHING} the step stays, and {@link #trouble} says what to look at.
     *
     * @throws IllegalStateException if the step was not driven, or there is none
     * @throws IllegalArgumentException if a hull with one motor has no other side
     */
    public void answer(Answer answer) {
        Step step = step().orElseThrow(() -> new IllegalStateException("the check is over"));
        if (!driven) {
            throw new IllegalStateException("nothing was driven yet: " + step.question());
        }
        boolean two = before.kind() == HullKind.DIFFERENTIAL;
        if (answer == Answer.OTHER_SIDE && !two) {
            throw new IllegalArgumentException("a hull with a rudder has no other side");
        }
        stop();
        if (answer == Answer.NOTHING) {
            trouble = step == Step.RUDDER_STARBOARD
                    ? "the rudder does not move: look at its cable and its servo"
                    : "the motor does not turn: look at its cable, its controller and the battery";
            return;
        }
        if (answer == Answer.OTHER_SIDE) {
            swap();
            return;
        }
        trouble = "";
        if (answer == Answer.REVERSED) {
            reverse(step);
        }
        at++;
    }

    private void stop() {
        motors.drive(0, 0, 0);
        driven = false;
    }

    /** The other motor is on this side: the step is driven and asked again on the right one. */
    private void swap() {
        HullSettings now = result.build();
        result.sidesSwapped(!now.sidesSwapped());
        at = 0; // what was said of a side was said of the other motor
        result.leftReversed(before.leftReversed()).rightReversed(before.rightReversed());
        trouble = "the motors are swapped in the settings: try again";
    }

    private void reverse(Step step) {
        HullSettings now = result.build();
        switch (step) {
            case RIGHT_AHEAD:
                result.rightReversed(!now.rightReversed());
                break;
            case RUDDER_STARBOARD:
                result.rudderReversed(!now.rudderReversed());
                break;
            default:
                result.leftReversed(!now.leftReversed());
                break;
        }
    }

    /** What is wrong, in words for people; empty if nothing is. */
    public String trouble() {
        return trouble;
    }

    /** The settings with what was found out; they count as checked once no step is left. The vehicle takes them as they become, so that a swap can be seen. */
    public HullSettings settings() {
        return result.motorsChecked(!step().isPresent()).build();
    }
}
