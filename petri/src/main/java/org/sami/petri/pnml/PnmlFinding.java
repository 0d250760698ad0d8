package org.sami.petri.pnml;

/**
 * Something in a PNML file that is wrong or that is left out.
 *
 * @param severity whether the file can be used
 * @param code stable, such as {@code E-NUMBER}
 * @param line from 1; 0 where it concerns the whole file
 * @param element the kind of element and its id, such as {@code place p1}; empty where it concerns the whole file
 * @param message what is wrong, and where it helps what would be right
 */
public record PnmlFinding(Severity severity, String code, int line, String element, String message) {
    /** How bad a finding is. */
    public enum Severity {
        /** The file gives no net. */
        ERROR,
        /** The net may mean something else than its author thinks. */
        WARNING,
        /** Something that changes no behaviour was left out. */
        NOTE
    }

    public boolean isError() {
        return severity == Severity.ERROR;
    }
}
