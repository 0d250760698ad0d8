package org.sami.petri.pnml;

/** A file cannot be read any further; the finding says why. */
final class RefusedPnmlException extends Exception {
    private final String code;
    private final int line;

    RefusedPnmlException(String code, int line, String message) {
        super(message);
        this.code = code;
        this.line = line;
    }

    String code() {
        return code;
    }

    int line() {
        return line;
    }

    String words() {
        return String.valueOf(getMessage());
    }
}
