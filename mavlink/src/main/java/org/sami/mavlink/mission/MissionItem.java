package org.sami.mavlink.mission;

import io.dronefleet.mavlink.common.MavCmd;
import io.dronefleet.mavlink.common.MissionItemInt;
import io.dronefleet.mavlink.util.EnumValue;
import java.util.Locale;

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
    private static final double DEGREES = 1e-7;

    static MissionItem of(MissionItemInt item) {
        return new MissionItem(
                item.seq(),
                item.command().value(),
                item.frame().value(),
                item.x() * DEGREES,
                item.y() * DEGREES,
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
