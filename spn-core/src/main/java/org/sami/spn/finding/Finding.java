package org.sami.spn.finding;

import java.util.List;
import java.util.Objects;

/**
 * One problem of a file or a plan.
 *
 * @param code a stable code, such as {@code E-TWO-STARTS}
 * @param pointer where in the document, as a JSON pointer (RFC 6901); empty text where there is no document
 * @param message one sentence that names the element, for the plan's author
 * @param elements ids of the elements concerned, for highlighting
 */
public record Finding(Severity severity, String code, String pointer, String message, List<String> elements) {
    public Finding {
        Objects.requireNonNull(severity, "severity");
        Objects.requireNonNull(code, "code");
        Objects.requireNonNull(pointer, "pointer");
        Objects.requireNonNull(message, "message");
        elements = List.copyOf(elements);
    }

    /** An error at a place in a document. */
    public static Finding error(String code, String pointer, String message, String... elements) {
        return new Finding(Severity.ERROR, code, pointer, message, List.of(elements));
    }

    /** A warning at a place in a document. */
    public static Finding warning(String code, String pointer, String message, String... elements) {
        return new Finding(Severity.WARNING, code, pointer, message, List.of(elements));
    }

    /** Whether this finding keeps a plan from being started. */
    public boolean isError() {
        return severity == Severity.ERROR;
    }
}
