package org.sami.boat.hull.settings;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * The guided check of a hull's motors, on land or tied up: each step drives something for some seconds and asks what a person saw. The answers become settings:
 * what is reversed or swapped, how much thrust motors and controllers bear, and the trim that keeps the hull straight. A model without a screen; one thread.
 */
public final class MotorCheck {
    /** How long a step drives, in ms. */
    public static final long STEP_MS = 2000;

    /** How long the last step drives, in ms: a hull needs time to show that it turns. */
    public static final long STRAIGHT_MS = 5000;

    private static final double EFFORT = 0.3;
    private static final int FIRST_TENTHS = 3;
    private static final int FULL_TENTHS = 10;
    private static final double TRIM_STEP = 0.03;

    private final MotorDrive motors;
    private final HullSettings before;
    private final List<MotorStep> steps;
    private final HullSettings.Builder result;
    private int at;
    private int thrustTenths = FIRST_TENTHS;
    private double trim;
    private boolean driven;
    private String trouble = "";

    /** Begins the check of a hull with these settings; nothing moves yet. */
    public MotorCheck(HullSettings hull, MotorDrive motors) {
        this.motors = motors;
        before = hull;
        result = hull.change();
        trim = hull.trim();
        List<MotorStep> asked = new ArrayList<>();
        if (hull.kind() == HullKind.RUDDER) {
            asked.add(MotorStep.THRUST_AHEAD);
            asked.add(MotorStep.RUDDER_STARBOARD);
        } else {
            asked.add(MotorStep.LEFT_AHEAD);
            asked.add(MotorStep.RIGHT_AHEAD);
        }
        asked.add(MotorStep.MOST_THRUST);
        asked.add(MotorStep.STRAIGHT);
        steps = Collections.unmodifiableList(asked);
    }

    /** All steps, in their order. */
    public List<MotorStep> steps() {
        return steps;
    }

    /** The step that is due; empty at the end. */
    public Optional<MotorStep> step() {
        return at < steps.size() ? Optional.of(steps.get(at)) : Optional.empty();
    }

    /** What the step that is due asks of a person; empty text at the end. */
    public String question() {
        if (!step().isPresent()) {
            return "";
        }
        String question = step().get().question();
        switch (step().get()) {
            case MOST_THRUST:
                return String.format(Locale.ROOT, question, thrustTenths * 10);
            case STRAIGHT:
                return String.format(Locale.ROOT, question, Math.round(trim * 100));
            default:
                return question;
        }
    }

    /**
     * Drives what the step is about, again if asked again; whether it does. Not while the board is gone or the boat is under way. The vehicle has the
     * {@link #settings} of this moment, as the thrust that is tried is one of them.
     */
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
            case RUDDER_STARBOARD:
                driven = motors.drive(1, -1, STEP_MS);
                break;
            case MOST_THRUST:
                driven = motors.drive(1, 1, STEP_MS);
                break;
            default: // a test of motors has no trim of its own
                driven = motors.drive(EFFORT + trim, EFFORT - trim, STRAIGHT_MS);
                break;
        }
        return driven;
    }

    /**
     * What a person saw. After {@link MotorAnswer#NOTHING} the step stays, and {@link #trouble} says what to look at. {@link MotorAnswer#LATER} needs no drive before it.
     *
     * @throws IllegalStateException if the step was not driven, or there is none
     * @throws IllegalArgumentException if it is no answer to this step
     */
    public void answer(MotorAnswer answer) {
        MotorStep step = step().orElseThrow(() -> new IllegalStateException("the check is over"));
        if (!step.answers().contains(answer)) {
            throw new IllegalArgumentException("'" + answer.words() + "' does not answer: " + question());
        }
        if (!driven && answer != MotorAnswer.LATER) {
            throw new IllegalStateException("nothing was driven yet: " + question());
        }
        motors.drive(0, 0, 0);
        driven = false;
        trouble = "";
        switch (step) {
            case MOST_THRUST:
                answerThrust(answer);
                break;
            case STRAIGHT:
                answerStraight(answer);
                break;
            default:
                answerTurning(step, answer);
                break;
        }
    }

    private void answerTurning(MotorStep step, MotorAnswer answer) {
        if (answer == MotorAnswer.NOTHING) {
            trouble = step == MotorStep.RUDDER_STARBOARD
                    ? "the rudder does not move: look at its cable and its servo"
                    : "the motor does not turn: look at its cable, its controller and the battery";
            return;
        }
        if (answer == MotorAnswer.OTHER_SIDE) {
            swap();
            return;
        }
        if (answer == MotorAnswer.REVERSED) {
            reverse(step);
        }
        at++;
    }

    /** The other motor is on this side: the step is driven and asked again on the right one. */
    private void swap() {
        HullSettings now = result.build();
        result.sidesSwapped(!now.sidesSwapped());
        at = 0; // what was said of a side was said of the other motor
        result.leftReversed(before.leftReversed()).rightReversed(before.rightReversed());
        trouble = "the motors are swapped in the settings: try again";
    }

    private void reverse(MotorStep step) {
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

    private void answerThrust(MotorAnswer answer) {
        if (answer == MotorAnswer.LATER) {
            result.safeMaximum(before.safeMaximum());
            at++;
        } else if (answer == MotorAnswer.FALTERED && thrustTenths == FIRST_TENTHS) {
            trouble =
                    "with so little thrust the fault is elsewhere: look at the battery, its plugs and the controllers";
        } else if (answer == MotorAnswer.FALTERED) {
            keepThrust(thrustTenths - 1);
        } else if (answer == MotorAnswer.ENOUGH || thrustTenths == FULL_TENTHS) {
            keepThrust(thrustTenths);
        } else {
            thrustTenths++;
        }
    }

    private void keepThrust(int tenths) {
        result.safeMaximum(tenths / 10.0);
        trouble = "the most thrust is " + tenths * 10 + " % from now on";
        at++;
    }

    private void answerStraight(MotorAnswer answer) {
        switch (answer) {
            case PULLS_LEFT:
                turnTrim(TRIM_STEP);
                return;
            case PULLS_RIGHT:
                turnTrim(-TRIM_STEP);
                return;
            case YES:
                result.trim(trim);
                break;
            default:
                result.trim(before.trim());
                break;
        }
        at++;
    }

    private void turnTrim(double by) {
        double next = Math.rint((trim + by) * 100) / 100;
        if (Math.abs(next) > HullSettings.MAX_TRIM) {
            trouble = "more trim than " + Math.round(HullSettings.MAX_TRIM * 100)
                    + " % is not possible: look for weed, a bent shaft or a weak motor";
            return;
        }
        trim = next;
        trouble = String.format(Locale.ROOT, "the trim is %d %% now: try again", Math.round(trim * 100));
    }

    /** What is to be known of the answers so far, in words for people; empty if nothing is. */
    public String trouble() {
        return trouble;
    }

    /** The settings with what was found out; they count as checked once no step is left. The vehicle takes them as they become, so that a swap can be seen. */
    public HullSettings settings() {
        boolean triesThrust = step().filter(MotorStep.MOST_THRUST::equals).isPresent();
        HullSettings found = result.motorsChecked(!step().isPresent()).build();
        return triesThrust ? found.change().safeMaximum(thrustTenths / 10.0).build() : found;
    }
}
