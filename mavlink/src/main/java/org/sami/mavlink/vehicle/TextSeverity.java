package org.sami.mavlink.vehicle;

/** Severity of an autopilot's text, worst first: the eight levels of RFC 5424. */
public enum TextSeverity {
    EMERGENCY,
    ALERT,
    CRITICAL,
    ERROR,
    WARNING,
    NOTICE,
    INFO,
    DEBUG
}
