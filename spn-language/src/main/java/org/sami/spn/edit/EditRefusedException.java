package org.sami.spn.edit;

/** An edit is not possible. The message says in one sentence what and where, for the plan's author. */
public final class EditRefusedException extends Exception {
    private final String reason;

    /** A refusal. */
    public EditRefusedException(String message) {
        super(message);
        reason = message;
    }

    /** What and where, in one sentence. */
    public String reason() {
        return reason;
    }
}
