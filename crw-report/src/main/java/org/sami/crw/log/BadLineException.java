package org.sami.crw.log;

/** A line that cannot be understood; the message says why. */
final class BadLineException extends Exception {
    private final LineFault fault;

    BadLineException(LineFault fault, String message) {
        super(message, null, false, false); // a damaged log has very many
        this.fault = fault;
    }

    LineFault fault() {
        return fault;
    }
}
