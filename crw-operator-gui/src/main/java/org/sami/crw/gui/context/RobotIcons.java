package org.sami.crw.gui.context;

import org.sami.crw.fleet.RobotKind;

/** The icons of a session's robots, by their names. */
public final class RobotIcons {
    private RobotIcons() {}

    /** Of one of them. */
    public static String one(RobotKind robots) {
        return robots == RobotKind.COPTER ? "copter" : "boat";
    }

    /** Of several. */
    public static String some(RobotKind robots) {
        return robots == RobotKind.COPTER ? "copters" : "fleet";
    }

    /** Of staying where they are: an anchor holds boats only. */
    public static String hold(RobotKind robots) {
        return robots == RobotKind.COPTER ? "pause" : "hold";
    }
}
