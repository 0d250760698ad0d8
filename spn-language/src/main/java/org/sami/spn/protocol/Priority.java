package org.sami.spn.protocol;

/** Rank of an interaction or a command (markup Priority, appendix .2.3). */
public enum Priority {
    LOW,
    MEDIUM,
    HIGH,
    CRITICAL
}
