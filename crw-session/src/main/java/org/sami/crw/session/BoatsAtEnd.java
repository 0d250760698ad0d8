package org.sami.crw.session;

/** The last command to the boats when a session ends while missions still run. Without a link, each boat then starts its lost-link action. */
public enum BoatsAtEnd {
    /** What missions have for them is taken back: motors to zero, they drift. */
    STOP,
    /** What missions have for them is taken back, and each keeps the place where it is. */
    HOLD,
    /** Nothing: they go on with their last command. */
    GO_ON
}
