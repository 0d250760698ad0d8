package org.sami.crw.console;

/** A command was not carried out; the message says why, in one line for the operator. */
public final class ConsoleFault extends RuntimeException {
    private static final long serialVersionUID = 1;

    ConsoleFault(String message) {
        super(message);
    }
}
