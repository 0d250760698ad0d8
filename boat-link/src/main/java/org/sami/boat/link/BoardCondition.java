package org.sami.boat.link;

/** Whether the control board of a hull, which drives its motors and reads its battery, answers the boat's server. */
public enum BoardCondition {
    /** It answers. */
    WORKING,
    /** It is plugged in and says nothing that can be read; the motors are 0. */
    SILENT,
    /** It is not there; the motors are 0. */
    GONE
}
