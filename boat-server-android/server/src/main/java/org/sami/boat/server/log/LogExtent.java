package org.sami.boat.server.log;

/** What was found in a file of a boat's log besides its entries. */
public final class LogExtent {
    private final long wholeBytes;
    private final int unreadLines;
    private final boolean headWhole;
    private final long headBytes;

    LogExtent(long wholeBytes, int unreadLines, boolean headWhole, long headBytes) {
        this.wholeBytes = wholeBytes;
        this.unreadLines = unreadLines;
        this.headWhole = headWhole;
        this.headBytes = headBytes;
    }

    /** The length in bytes up to the end of the last whole line; anything after it is a line that was cut off. */
    public long wholeBytes() {
        return wholeBytes;
    }

    /** Whole lines that say nothing, because they are damaged or were written by a server that knew other messages. */
    public int unreadLines() {
        return unreadLines;
    }

    /** Whether the file begins with all that a restarted boat needs of earlier files. */
    public boolean isHeadWhole() {
        return headWhole;
    }

    /** Length in bytes of that beginning; 0 without one. */
    long headBytes() {
        return headBytes;
    }
}
