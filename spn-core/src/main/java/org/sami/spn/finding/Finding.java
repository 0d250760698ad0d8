package org.sami.spn.finding;

import java.util.List;
import java.util.Objects;
import java.util.Optional;

/**
 * One problem of a file or a plan.
 *
 * @param code a stable code, such as {@code E-TWO-STARTS}
 * @param pointer where in the document, as a JSON pointer (RFC 6901); empty text where there is no document
 * @param message one sentence that names the element, for the plan's author
 * @param elements ids of the elements concerned, for highlighting
 * @param location where in the file the pointer's value begins; readers set it, checks of plans in memory do not
 */
public record Finding(
        Severity severity,
        String code,
        String pointer,
        String message,
        List<String> elements,
        Optional<SourceLocation> location) {
    public Finding {
        Objects.requireNonNull(severity, "severity");
        Objects.requireNonNull(code, "code");
        Objects.requireNonNull(pointer, "pointer");
        Objects.requireNonNull(message, "message");
        elements = List.copyOf(elements);
        Objects.requireNonNull(location, "location");
    }

    /** A finding whose place in a file is not known yet. */
    public Finding(Severity severity, String code, String pointer, String message, List<String> elements) {
        this(severity, code, pointer, message, elements, Optional.empty());
    }

    /** An error at a place in a document. */
    public static Finding error(String code, String pointer, String message, String... elements) {
        return new Finding(Severity.ERROR, code, pointer, message, List.of(elements));
    }

    /** A warning at a place in a document. */
    public static Finding warning(String code, String pointer, String message, String... elements) {
        return new Finding(Severity.WARNING, code, pointer, message, List.of(elements));
    }

    /** The same finding of a document that stands at a place of another, or has a name. */
    public Finding within(String prefix) {
        return new Finding(severity, code, prefix + pointer, message, elements, location);
    }

    /** The same finding with its place in a file. */
    public Finding at(SourceLocation place) {
        return new Finding(severity, code, pointer, message, elements, Optional.of(place));
    }

    /** The same finding about other elements. */
    public Finding about(List<String> others) {
        return new Finding(severity, code, pointer, message, others, location);
    }

    /** Whether this finding keeps a plan from being started. */
    public boolean isError() {
        return severity == Severity.ERROR;
    }
}
