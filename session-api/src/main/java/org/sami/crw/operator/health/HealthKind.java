package org.sami.crw.operator.health;

/** What part of a session a fault is in. */
public enum HealthKind {
    /** The engine has stopped: no mission goes on, no answer is taken in. */
    ENGINE,
    /** The journal cannot be written, or its file is gone. */
    JOURNAL,
    /** The disk of the journal is nearly full. */
    DISK,
    /** The process has no memory left, or nearly none. */
    MEMORY,
    /** A thread of the session met an error and does its work no longer, or did not do a part of it. */
    THREAD,
    /** A running mission cannot go on by itself. */
    MISSION,
    /** A boat that was to be connected has never answered. */
    UNREACHED_BOAT,
    /** The link to a boat is lost, or was lost repeatedly. */
    LINK,
    /** A boat without a command has drifted from its place, or a boat has left the circle of its station: where the alarm is raised. */
    DRIFT,
    /** Boats are stopped until they are released. */
    FLEET_STOP,
    /** A boat sends more than the base takes in. */
    FLOOD,
    /** A file that the session was to use is damaged, gone or another one than before. */
    FILE,
    /** Another active alarm about a boat. */
    ALARM
}
