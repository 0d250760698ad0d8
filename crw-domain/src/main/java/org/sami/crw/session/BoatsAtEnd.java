package org.sami.crw.session;

/** What boats are told as a session is left whose missions still run. Without a link, each then does what is set on it for a lost one. */
public enum BoatsAtEnd {
    /** What missions have for them is taken back: motors to zero, they drift. */
    STOP,
    /** What missions have for them is taken back, and each keeps the place where it is. */
    HOLD,
    /** Nothing: they go on with what they were told last. */
    GO_ON
}
