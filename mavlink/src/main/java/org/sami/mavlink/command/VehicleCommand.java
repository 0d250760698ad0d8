package org.sami.mavlink.command;

import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;

/**
 * A command of the command protocol (MAV_CMD), with its parameters.
 *
 * @param number the command's number
 * @param does what it asks for, in words that continue "the vehicle refuses to", such as {@code arm}
 * @param params param1 to param7; where it has a place, param5 and param6 are not used
 * @param place where it leads; such a command is sent as COMMAND_INT, which has positions to the centimetre
 * @param newestWins whether it makes an earlier command of this number that is not answered yet meaningless, as a mode does; others are sent one after the other
 */
public record VehicleCommand(
        int number, String does, List<Double> params, Optional<CommandPlace> place, boolean newestWins) {
    /** The number of {@link #sendEvery}. */
    public static final int SEND_EVERY = 511;

    private static final int PARAMS = 7;
    private static final int TAKE_OFF = 22;
    private static final int SET_MODE = 176;
    private static final int REPOSITION = 192;
    private static final int CHANGE_SPEED = 178;
    private static final int SWITCH_FENCE = 207;
    private static final int SET_CURRENT = 224;
    static final int ARM_DISARM = 400;
    private static final int SEND_ONCE = 512;
    private static final int REBOOT = 246;
    private static final int TAKE_PICTURES = 2_000;
    private static final int TRIGGER_CAMERA = 203;
    private static final double CUSTOM_MODE = 1;
    private static final double GROUND_SPEED = 1;
    private static final double FORCED_DISARM = 21_196; // the number that the protocol asks for
    private static final double US = 1e6;

    /** A command.
     *
     * @throws IllegalArgumentException if it has not seven parameters
     */
    public VehicleCommand {
        Objects.requireNonNull(does, "does");
        Objects.requireNonNull(place, "place");
        params = List.copyOf(params);
        if (params.size() != PARAMS) {
            throw new IllegalArgumentException(
                    does + ": a command has " + PARAMS + " parameters, not " + params.size());
        }
    }

    /** Whether it turns motors off. */
    public boolean isDisarming() {
        return number == ARM_DISARM && params.get(0) == 0;
    }

    /** Any command that has no place, its parameters from param1 on; those left out are 0. Commands of its number are sent one after the other. */
    public static VehicleCommand of(int number, String does, double... params) {
        return made(number, does, false, params);
    }

    private static VehicleCommand made(int number, String does, boolean newestWins, double... params) {
        Double[] all = new Double[PARAMS];
        for (int i = 0; i < PARAMS; i++) {
            all[i] = i < params.length ? params[i] : 0;
        }
        return new VehicleCommand(number, does, List.of(all), Optional.empty(), newestWins);
    }

    /** Lets the motors turn, if the autopilot's checks pass. */
    public static VehicleCommand arm() {
        return made(ARM_DISARM, "arm", true, 1);
    }

    /** Motors off. A copter in the air refuses. */
    public static VehicleCommand disarm() {
        return made(ARM_DISARM, "disarm", true, 0);
    }

    /** Motors off whatever the vehicle does: a copter in the air falls. */
    public static VehicleCommand disarmAtOnce() {
        return made(ARM_DISARM, "disarm", true, 0, FORCED_DISARM);
    }

    /** Changes the mode to the number that the autopilot gives it; {@code name} is for people. */
    public static VehicleCommand setMode(long customMode, String name) {
        return made(SET_MODE, "change to " + name, true, CUSTOM_MODE, (double) customMode);
    }

    /** Makes an item of the mission the one that is carried out now, or next in mode AUTO. */
    public static VehicleCommand setCurrentItem(int item) {
        return made(SET_CURRENT, "go on at item " + item, true, item);
    }

    /** Takes off straight up to a height, metres over its home, and stays there. ArduPilot's copters do so in mode GUIDED, armed, on the ground. */
    public static VehicleCommand takeOff(double heightM) {
        String does = String.format(Locale.ROOT, "take off to %.0f m over its home", heightM);
        return made(TAKE_OFF, does, true, 0, 0, 0, 0, 0, 0, heightM);
    }

    /** Changes the speed of the leg under way, metres a second over ground. */
    public static VehicleCommand setSpeed(double speedMps) {
        return made(CHANGE_SPEED, "change its speed", true, GROUND_SPEED, speedMps, -1);
    }

    /**
     * Puts the fence that it holds in force, where its parameters have one in force and somebody has switched it off. The parameters stay as they are.
     *
     * @param kinds the kinds of fence, in bits of ArduPilot's {@code FENCE_TYPE}; earlier firmware takes all that it has
     */
    public static VehicleCommand fenceOn(int kinds) {
        return made(SWITCH_FENCE, "put its fence in force", true, 1, kinds);
    }

    /**
     * Goes to a place and stays there, in mode GUIDED, in which it has to be: ArduPilot refuses it in others. The command does not change the mode, as it is sent again
     * until it is answered, and a pilot may have taken the vehicle meanwhile. It is answered, which a {@link GuidedTarget} is not.
     *
     * @param speedMps metres a second; ArduPilot's boats refuse the command with one while they stand: {@link #setSpeed} after it does the same
     */
    public static VehicleCommand reposition(CommandPlace place, Optional<Double> speedMps) {
        Double speed = speedMps.orElse(-1.0);
        return new VehicleCommand(
                REPOSITION,
                "go to a place",
                List.of(speed, 0.0, 0.0, Double.NaN, 0.0, 0.0, place.heightM()),
                Optional.of(place),
                true);
    }

    /** Asks for a message every so many seconds; 0 for the vehicle's own default, a negative number for never. */
    public static VehicleCommand sendEvery(int message, double seconds) {
        double us = seconds < 0 ? -1 : seconds * US;
        return made(SEND_EVERY, "send message " + message, false, message, us);
    }

    /** Asks for a message once, now. */
    public static VehicleCommand sendOnce(int message) {
        return made(SEND_ONCE, "send message " + message + " once", false, message);
    }

    /**
     * Takes one picture with the first camera (IMAGE_START_CAPTURE). Without a camera ArduPilot refuses.
     *
     * @param number from 1, another for each picture: a camera that counts them takes no second one where the command comes twice
     */
    public static VehicleCommand takePicture(int number) {
        return made(TAKE_PICTURES, "take a picture", false, 0, 0, 1, number);
    }

    /** Triggers the camera once (DO_DIGICAM_CONTROL), as firmwares know it that have no {@link #takePicture}. ArduPilot accepts it without a camera, too. */
    public static VehicleCommand triggerCamera() {
        return made(TRIGGER_CAMERA, "take a picture", false, 0, 0, 0, 0, 1);
    }

    /** Starts the autopilot again; it refuses while it is armed. */
    public static VehicleCommand reboot() {
        return made(REBOOT, "start again", false, 1);
    }
}
