package org.sami.mavlink.vehicle;

/** How bad it is what an autopilot says, worst first; the eight degrees of RFC 5424. */
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
