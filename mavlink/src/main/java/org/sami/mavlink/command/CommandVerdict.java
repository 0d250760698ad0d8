package org.sami.mavlink.command;

/** How a command ended. */
public enum CommandVerdict {
    /** The vehicle carries it out, or has. */
    ACCEPTED("accepts"),
    /** It cannot now, but may later. */
    NOT_NOW("refuses for now"),
    /** It refuses; asking again does not help. */
    DENIED("refuses"),
    /** Its firmware has no such command. */
    UNKNOWN_TO_IT("does not know how"),
    /** It tried and failed. */
    FAILED("fails"),
    /** Somebody cancelled it. */
    CANCELLED("was stopped by another command"),
    /** It did not answer, however often it was asked; it may have carried it out. */
    UNANSWERED("does not answer"),
    /** A later command of this base took its place. */
    REPLACED("was given a later command");

    private final String words;

    CommandVerdict(String words) {
        this.words = words;
    }

    /** What the vehicle does with the command, for people. */
    public String words() {
        return words;
    }
}
