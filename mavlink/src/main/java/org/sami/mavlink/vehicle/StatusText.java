package org.sami.mavlink.vehicle;

/**
 * What an autopilot says in words of its own, such as {@code PreArm: GPS 1: Bad fix}.
 *
 * @param heardMs when its last part came, on the base's clock
 */
public record StatusText(TextSeverity severity, String text, long heardMs) {}
