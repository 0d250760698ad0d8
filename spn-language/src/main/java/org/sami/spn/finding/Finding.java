package org.sami.spn.finding;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.Fix;

/**
 * One problem of a file or a plan.
 *
 * @param code a stable code, such as {@code E-TWO-STARTS}
 * @param pointer where in the document, as a JSON pointer (RFC 6901); empty text where there is no document
 * @param message one sentence that names the element, for the plan's author
 * @param plan id of the plan that it is about; empty text where it is about the project, or no plan could be determined
 * @param elements what is concerned, for highlighting: ids of vertices, edges, events and sub-missions of the plan, names of variables
 *     (with {@code @}) and tasks
 * @param fixes edits that mend it where that is mechanical, the likeliest first; none adds an error
 * @param location where in the file the pointer's value begins; readers set it, checks of plans in memory do not
 */
public record Finding(
        Severity severity,
        String code,
        String pointer,
        String message,
        String plan,
        List<String> elements,
        List<Fix> fixes,
        Optional<SourceLocation> location) {
    private static final Pattern FIELD = Pattern.compile("/(?:fields|writes|options)/([^/]+)");

    public Finding {
        Objects.requireNonNull(severity, "severity");
        Objects.requireNonNull(code, "code");
        Objects.requireNonNull(pointer, "pointer");
        Objects.requireNonNull(message, "message");
        Objects.requireNonNull(plan, "plan");
        elements = List.copyOf(elements);
        fixes = List.copyOf(fixes);
        Objects.requireNonNull(location, "location");
    }

    /** A finding whose place in a file is not known yet. */
    public Finding(Severity severity, String code, String pointer, String message, List<String> elements) {
        this(severity, code, pointer, message, "", elements, List.of(), Optional.empty());
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
        return new Finding(severity, code, prefix + pointer, message, plan, elements, fixes, location);
    }

    /** The same finding with its place in a file. */
    public Finding at(SourceLocation place) {
        return new Finding(severity, code, pointer, message, plan, elements, fixes, Optional.of(place));
    }

    /** The same finding about other elements. */
    public Finding about(List<String> others) {
        return new Finding(severity, code, pointer, message, plan, others, fixes, location);
    }

    /** The same finding about a plan. */
    public Finding inPlan(String planId) {
        return new Finding(severity, code, pointer, message, planId, elements, fixes, location);
    }

    /** The same finding with one more edit that mends it. */
    public Finding fixedBy(String label, Edit edit) {
        List<Fix> more = new ArrayList<>(fixes);
        more.add(new Fix(label, edit));
        return new Finding(severity, code, pointer, message, plan, elements, more, location);
    }

    /** The field of an event, task or markup that it is about; empty where it is about none. */
    public Optional<String> field() {
        Matcher matcher = FIELD.matcher(pointer);
        return matcher.find() ? Optional.of(matcher.group(1)) : Optional.empty();
    }

    /** Whether this finding keeps a plan from being started. */
    public boolean isError() {
        return severity == Severity.ERROR;
    }
}
