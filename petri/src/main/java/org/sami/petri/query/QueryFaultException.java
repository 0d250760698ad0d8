package org.sami.petri.query;

/** The text of a query makes no sense; the message says why, and the column where. */
public final class QueryFaultException extends Exception {
    private final int column;

    QueryFaultException(int column, String message) {
        super(message);
        this.column = column;
    }

    /** The column of the text, from 1, at which it stops making sense. */
    public int column() {
        return column;
    }

    /** Place and message. */
    public String words() {
        return "column " + column + ": " + getMessage();
    }
}
