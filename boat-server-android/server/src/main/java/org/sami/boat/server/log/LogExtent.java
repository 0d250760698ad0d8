package org.sami.boat.server.log;

/** What was found in a boat's log besides its entries. */
public final class LogExtent {
    private final long wholeBytes;
    private final int unreadLines;

    LogExtent(long wholeBytes, int unreadLines) {
        this.wholeBytes = wholeBytes;
        this.unreadLines = unreadLines;
    }

    /** The length in bytes up to the end of the last whole line; anything after it is a line that was cut off. */
    public long wholeBytes() {
        return wholeBytes;
    }

    /** Whole lines that say nothing, because they are damaged or were written by a server that knew other messages. */
    public int unreadLines() {
        return unreadLines;
    }
}
