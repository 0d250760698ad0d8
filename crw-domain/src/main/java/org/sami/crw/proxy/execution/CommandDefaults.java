package org.sami.crw.proxy.execution;

/** Numbers of how a base carries out commands that no plan and no option sets. {@code crw defaults} prints them. */
public final class CommandDefaults {
    /** A command that fails is tried so often. */
    public static final int MAX_TRIES = 3;

    /** A boat that comes no nearer to its next waypoint for this time, in ms, is shown to the operator. */
    public static final long NO_PROGRESS_SHOWN_AFTER_MS = 60_000;

    /** A path along which a boat makes no progress for this time, in ms, has failed. */
    public static final long NO_PROGRESS_FAILED_AFTER_MS = 300_000;

    /** A panorama that is not reported complete after this time, in ms, is taken again. */
    public static final long LONGEST_PANORAMA_MS = 180_000;

    /** A boat whose path was given up stays within this distance of its place, in metres. */
    public static final double PLACE_RADIUS_M = 10;

    private CommandDefaults() {}
}
