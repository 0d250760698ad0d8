package org.sami.crw.gui.context;

import org.sami.crw.fleet.RobotKind;

/** The icons of a session's robots, by their names. */
public final class RobotIcons {
    private RobotIcons() {}

    /** Of one of them. */
    public static String one(RobotKind robots) {
        return switch (robots) {
            case BOAT -> "boat";
            case COPTER -> "copter";
            case ROBOT -> "team";
        };
    }

    /** Of several. */
    public static String some(RobotKind robots) {
        return switch (robots) {
            case BOAT -> "fleet";
            case COPTER -> "copters";
            case ROBOT -> "team";
        };
    }

    /** Of staying where they are: an anchor holds boats only. */
    public static String hold(RobotKind robots) {
        return robots == RobotKind.BOAT ? "hold" : "pause";
    }
}
