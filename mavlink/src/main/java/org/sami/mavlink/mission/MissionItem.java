package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MavFrame;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.Locale;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * An item of a list that a vehicle holds. Item 0 of an ArduPilot mission is its home.
 *
 * @param number its place in the list, from 0
 * @param command the number of the command (MAV_CMD)
 * @param frame the number of the frame of its position (MAV_FRAME)
 * @param latDeg degrees north, WGS 84; 0 where the command has no position
 * @param lonDeg degrees east, WGS 84; 0 where the command has no position
 * @param heightM metres, over what the frame says
 * @param param1 to {@code param4}: what they mean depends on the command
 */
public record MissionItem(
        int number,
        int command,
        int frame,
        double latDeg,
        double lonDeg,
        double heightM,
        double param1,
        double param2,
        double param3,
        double param4) {
    private static final double TO_WHOLE = 1e7;
    private static final double HEIGHT_KEPT_M = 0.011; // autopilots keep centimetres
    private static final double PARAM_KEPT = 1e-3;
    private static final double MAX_LAT = 90;
    private static final double MAX_LON = 180;
    private static final int WAYPOINT = 16;
    private static final int GLOBAL = 0;
    private static final int RELATIVE = 3;
    private static final int GLOBAL_INT = 5;
    private static final int RELATIVE_INT = 6;
    private static final int TERRAIN = 10;
    private static final int TERRAIN_INT = 11;

    /** An item.
     *
     * @throws IllegalArgumentException if its place is not on the earth
     */
    public MissionItem {
        if (!(Math.abs(latDeg) <= MAX_LAT && Math.abs(lonDeg) <= MAX_LON) || Double.isInfinite(heightM)) {
            throw new IllegalArgumentException(
                    "item " + number + " has no place " + latDeg + ", " + lonDeg + ", " + heightM + " m");
        }
        latDeg = whole(latDeg) / TO_WHOLE; // as exactly as messages carry it, so that what comes back is equal
        lonDeg = whole(lonDeg) / TO_WHOLE;
        heightM = asSent(heightM);
        param1 = asSent(param1);
        param2 = asSent(param2);
        param3 = asSent(param3);
        param4 = asSent(param4);
    }

    /** A place to go to, {@code waitS} seconds of waiting there included; its height is over home. */
    public static MissionItem waypoint(int number, double latDeg, double lonDeg, double heightM, double waitS) {
        return new MissionItem(number, WAYPOINT, RELATIVE, latDeg, lonDeg, heightM, waitS, 0, 0, 0);
    }

    /** A command of the mission that has no place. */
    public static MissionItem command(int number, int command, double param1, double param2, double param3) {
        return new MissionItem(number, command, 2, 0, 0, 0, param1, param2, param3, 0);
    }

    /** The same at another place of the list. */
    public MissionItem at(int place) {
        return new MissionItem(place, command, frame, latDeg, lonDeg, heightM, param1, param2, param3, param4);
    }

    /**
     * Whether a vehicle that holds the other item would do the same: the same command and place, as exactly as messages and autopilots keep them. Frames that
     * differ only in how positions are written are the same.
     */
    public boolean isSameAs(MissionItem other) {
        return number == other.number
                && command == other.command
                && sameFrame(other)
                && whole(latDeg) == whole(other.latDeg)
                && whole(lonDeg) == whole(other.lonDeg)
                && near(heightM, other.heightM, HEIGHT_KEPT_M)
                && near(param1, other.param1, PARAM_KEPT)
                && near(param2, other.param2, PARAM_KEPT)
                && near(param3, other.param3, PARAM_KEPT)
                && near(param4, other.param4, PARAM_KEPT);
    }

    private boolean sameFrame(MissionItem other) {
        return (hasNoPlace() && other.hasNoPlace()) || plainFrame(frame) == plainFrame(other.frame);
    }

    private boolean hasNoPlace() {
        return latDeg == 0 && lonDeg == 0 && heightM == 0;
    }

    private static int plainFrame(int frame) {
        return switch (frame) {
            case GLOBAL_INT -> GLOBAL;
            case RELATIVE_INT -> RELATIVE;
            case TERRAIN_INT -> TERRAIN;
            default -> frame;
        };
    }

    private static double asSent(double value) {
        float single = (float) value; // what messages carry
        return single;
    }

    private static long whole(double degrees) {
        return Math.round(degrees * TO_WHOLE);
    }

    private static boolean near(double one, double other, double within) {
        return Double.isNaN(one) ? (Double.isNaN(other) || other == 0) : Math.abs(one - other) <= within;
    }

    /** The item as a message of the library. */
    public MissionItemInt message(VehicleId to, HeldKind kind) {
        return MissionItemInt.builder()
                .targetSystem(to.system())
                .targetComponent(to.component())
                .seq(number)
                .command(EnumValue.create(MavCmd.class, command))
                .frame(EnumValue.create(MavFrame.class, frame))
                .autocontinue(1)
                .x((int) whole(latDeg))
                .y((int) whole(lonDeg))
                .z((float) heightM)
                .param1((float) param1)
                .param2((float) param2)
                .param3((float) param3)
                .param4((float) param4)
                .missionType(kind.type())
                .build();
    }

    /** An item as the library read it.
     *
     * @throws IllegalArgumentException if its place is not on the earth
     */
    public static MissionItem of(MissionItemInt item) {
        return new MissionItem(
                item.seq(),
                item.command().value(),
                item.frame().value(),
                item.x() / TO_WHOLE,
                item.y() / TO_WHOLE,
                item.z(),
                item.param1(),
                item.param2(),
                item.param3(),
                item.param4());
    }

    /** The command's name for people, such as {@code nav waypoint}; {@code command N} where it is not known. */
    public String commandName() {
        MavCmd known = EnumValue.create(MavCmd.class, command).entry();
        return known == null
                ? "command " + command
                : known.name()
                        .substring("MAV_CMD_".length())
                        .toLowerCase(Locale.ROOT)
                        .replace('_', ' ');
    }
}
