package org.sami.crw.cli.output;

/** What the user asked for cannot be done as it was asked; the message says what is allowed. Exit code 2. */
public final class UsageFault extends RuntimeException {
    public UsageFault(String message) {
        super(message);
    }
}
