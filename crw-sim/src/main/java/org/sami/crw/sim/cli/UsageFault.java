package org.sami.crw.sim.cli;

/** What the user asked for cannot be done as it was asked; the message says what is allowed. Exit code 2. */
final class UsageFault extends RuntimeException {
    UsageFault(String message) {
        super(message);
    }
}
