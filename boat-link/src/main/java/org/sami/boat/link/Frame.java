package org.sami.boat.link;

import java.util.Objects;

/** A message with its place in the sender's sequence, and the term in which it was sent: what a frame holds. */
public final class Frame {
    private final long sequence;
    private final String term;
    private final LinkMessage message;

    /** Makes the content of a frame; one of a boat, or of a client that does not command, has the empty term. */
    public Frame(long sequence, String term, LinkMessage message) {
        this.sequence = Checks.atLeastZero("seq", sequence);
        this.term = Checks.text("term", term);
        this.message = Objects.requireNonNull(message, "message");
    }

    /** Counts the frames of one sender on one connection. */
    public long sequence() {
        return sequence;
    }

    /** The term of the last welcome that the sender had read; empty if it did not command. */
    public String term() {
        return term;
    }

    /** The message. */
    public LinkMessage message() {
        return message;
    }
}
