package org.sami.crw.operator.alarm;

/** Limits beyond which the operator is warned of a boat. No plan and no option sets them. {@code crw defaults} prints them. */
public final class AlarmLimits {
    /** A linked boat that says for this time, in ms, nothing of its position raises an alarm. */
    public static final long POSITION_STALE_AFTER_MS = 5_000;

    /** A boat without a command that is carried farther than this, in metres, drifts. */
    public static final double DRIFT_WITHOUT_COMMAND_M = 20;

    /** A boat on a station that is farther than this outside its circle, in metres, drifts. */
    public static final double DRIFT_OUTSIDE_STATION_M = 5;

    /** A boat has to be out for this time, in ms, before it counts as drifting. */
    public static final long DRIFT_AFTER_MS = 20_000;

    /** Boats that are about to come closer than this, in metres, raise an alarm; heights of robots that fly count. */
    public static final double APPROACH_M = 3;

    /** Looked-ahead time for {@link #APPROACH_M}, in seconds; boats themselves give way from 8 s on. */
    public static final double APPROACH_WITHIN_S = 3;

    /** A boat may seem to be this far inside a no-go area, in metres: positions are no better (1.4 m along each axis, jumps up to 2.1 m). */
    public static final double NO_GO_DEPTH_M = 2;

    /** A path may lead this far into a no-go area, in metres: planned paths may touch it. */
    public static final double NO_GO_PATH_DEPTH_M = 0.5;

    /** A position that moves faster than this, in m/s, has jumped: no boat of the fleet is that fast. */
    public static final double FASTEST_MPS = 6;

    /** A position that stays the same for this time, in ms, while the boat moves is frozen. */
    public static final long FROZEN_AFTER_MS = 5_000;

    /** A heading that differs from the boat's course by more than this, in degrees, is doubtful. */
    public static final double WRONG_COURSE_DEG = 60;

    private AlarmLimits() {}
}
