package org.sami.boat.link;

import java.util.Objects;

/** A message with its place in the sender's sequence: what a frame holds. */
public final class Frame {
    private final long sequence;
    private final LinkMessage message;

    /** Makes the content of a frame. */
    public Frame(long sequence, LinkMessage message) {
        this.sequence = Checks.atLeastZero("seq", sequence);
        this.message = Objects.requireNonNull(message, "message");
    }

    /** Counts the frames of one sender in one session, from 0. */
    public long sequence() {
        return sequence;
    }

    /** What is said. */
    public LinkMessage message() {
        return message;
    }
}
