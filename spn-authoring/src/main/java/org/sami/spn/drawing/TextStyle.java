package org.sami.spn.drawing;

/** The kinds of text on a drawing. */
public enum TextStyle {
    /** The plan's name. */
    TITLE(true, 22),
    /** The text about the whole drawing. */
    NOTE(false, 13),
    /** A vertex's name. */
    NAME(true, 13),
    /** Events and sub-missions. */
    EVENT(false, 12),
    /** Requirements. */
    EDGE(false, 12),
    /** The mark on an edge without requirement. */
    MISSING(true, 13);

    private final boolean bold;
    private final int size;

    TextStyle(boolean bold, int size) {
        this.bold = bold;
        this.size = size;
    }

    /** The height of its letters, in drawing units. */
    public int size() {
        return size;
    }

    /** Whether it is bold. */
    public boolean isBold() {
        return bold;
    }
}
