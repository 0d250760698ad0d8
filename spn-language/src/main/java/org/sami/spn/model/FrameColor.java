package org.sami.spn.model;

/** The colour of a frame. None of them is that of a state: start, end, warning, fault. */
public enum FrameColor {
    /** Blue, as a frame is drawn at first. */
    BLUE,
    /** Blue-green. */
    TEAL,
    /** Violet. */
    VIOLET,
    /** Pink. */
    PINK,
    /** Yellow-brown. */
    SAND,
    /** Grey. */
    GREY
}
