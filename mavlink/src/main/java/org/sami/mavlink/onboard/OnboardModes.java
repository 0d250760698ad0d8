package org.sami.mavlink.onboard;

/** The numbers of modes of a boat, as ArduPilot's boats have them: ground stations know them by name. */
public final class OnboardModes {
    /** By hand. */
    public static final int MANUAL = 0;

    /** Motors at rest, though armed. */
    public static final int HOLD = 4;

    /** Keeps its place. */
    public static final int LOITER = 5;

    /** Carries out its mission. */
    public static final int AUTO = 10;

    /** Returns to its home. */
    public static final int RETURN = 11;

    /** Goes to places that it is given one by one. */
    public static final int GUIDED = 15;

    private OnboardModes() {}

    /** The mode's name for people. */
    public static String name(long mode) {
        return switch ((int) mode) {
            case MANUAL -> "MANUAL";
            case HOLD -> "HOLD";
            case LOITER -> "LOITER";
            case AUTO -> "AUTO";
            case RETURN -> "RTL";
            case GUIDED -> "GUIDED";
            default -> "mode " + mode;
        };
    }
}
