package org.sami.crw.session;

/** Numbers of a session with boats in real time that no plan and no option sets. {@code crw defaults} prints them. */
public final class SessionDefaults {
    /** Telemetry messages a second that a session asks of its boats: several while a boat passes a location. */
    public static final double TELEMETRY_HZ = 10;

    /** A boat that has not answered for this time, in ms, is a fault: one that is switched on answers sooner. */
    public static final long UNREACHED_AFTER_MS = 5_000;

    private SessionDefaults() {}
}
