package org.sami.boat.link;

/**
 * A frame that cannot be used: what is wrong with it, and where.
 *
 * <p>It says nothing about the peer's intent; the receiver counts it, answers it where it can, and goes on.
 */
public final class LinkException extends Exception {

    /** What is wrong with a frame; each kind is counted on its own. */
    public enum Fault {
        /** The stream ends in the middle of a frame. */
        TRUNCATED,
        /** The declared length is negative, zero, or more than the receiver takes. */
        LENGTH,
        /** The version byte is not one that the receiver reads. */
        VERSION,
        /** The check value does not fit: the frame was damaged on its way. */
        CHECK,
        /** The body is not strict UTF-8. */
        ENCODING,
        /** The body is not one JSON object, or nests too deeply. */
        SYNTAX,
        /** The message type is not known. */
        UNKNOWN_TYPE,
        /** A member that must be there is missing. */
        MISSING,
        /** A member has another JSON type than it must have. */
        WRONG_TYPE,
        /** A value is out of its range, not finite, too long, or not one of its words. */
        BAD_VALUE
    }

    private final Fault fault;
    private final String where;
    private final String what;
    private final String commandId;

    LinkException(Fault fault, String where, String what) {
        this(fault, where, what, "");
    }

    private LinkException(Fault fault, String where, String what, String commandId) {
        super(fault + " at " + (where.isEmpty() ? "the frame" : where) + ": " + what);
        this.fault = fault;
        this.where = where;
        this.what = what;
        this.commandId = commandId;
    }

    /** The same fault, naming the command in whose frame it is. */
    LinkException ofCommand(String id) {
        return new LinkException(fault, where, what, id);
    }

    /** What kind of fault it is. */
    public Fault fault() {
        return fault;
    }

    /** Where in the body the fault is, as a JSON pointer; empty if it concerns the frame as a whole. */
    public String where() {
        return where;
    }

    /** The id of the command in the frame, for a refusal that names it; empty if unreadable. */
    public String commandId() {
        return commandId;
    }
}
