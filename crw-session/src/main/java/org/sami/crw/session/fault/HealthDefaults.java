package org.sami.crw.session.fault;

/** Limits beyond which a session warns that its disk or its memory is nearly full. {@code crw defaults} prints them. */
public final class HealthDefaults {
    /** A disk that will be full within this time, in minutes, is a warning. */
    public static final double ROOM_LOW_MIN = 60;

    /** A disk that will be full within this time, in minutes, is a fault. */
    public static final double ROOM_GONE_MIN = 10;

    /** A disk with less room than this, in bytes, is a warning. */
    public static final long ROOM_LOW_BYTES = 50L << 20;

    /** A disk with less room than this, in bytes, is a fault. */
    public static final long ROOM_GONE_BYTES = 2L << 20;

    /** Memory is nearly full from this share of what the process may have. */
    public static final double MEMORY_FULL_SHARE = 0.9;

    private HealthDefaults() {}
}
