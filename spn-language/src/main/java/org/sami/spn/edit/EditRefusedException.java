package org.sami.spn.edit;

/** An edit is not possible. The message says in one sentence what and where, for the plan's author. */
public final class EditRefusedException extends Exception {
    /** A refusal. */
    public EditRefusedException(String message) {
        super(message);
    }
}
