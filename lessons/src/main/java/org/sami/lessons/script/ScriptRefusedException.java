package org.sami.lessons.script;

/** An element of a script cannot be done in the project as it is. */
final class ScriptRefusedException extends Exception {
    private final String pointer;

    /**
     * A refusal.
     *
     * @param pointer what of the element is in the way; empty for the whole of it
     */
    ScriptRefusedException(String pointer, String reason) {
        super(reason);
        this.pointer = pointer;
    }

    String pointer() {
        return pointer;
    }

    String reason() {
        return String.valueOf(getMessage());
    }
}
