package org.sami.spn.component;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;

/**
 * What one component or widget says that it can do (thesis 5.2.4, Component capabilities).
 *
 * @param creates types of values that the operator can give with it (SCC, MCC, HCC)
 * @param selects types of values that it can show and let the operator choose from (SSC, MSC, HSC)
 * @param markups choices of markups on which it acts (MO)
 */
public record Capabilities(List<TypePattern> creates, List<TypePattern> selects, List<MarkupOption> markups) {
    public Capabilities {
        creates = List.copyOf(creates);
        selects = List.copyOf(selects);
        markups = List.copyOf(markups);
    }

    /**
     * Whether values of a type can be given, or chosen and shown.
     *
     * @param declarations the named types of the vocabulary, by name
     */
    public boolean supports(Purpose purpose, ValueType type, Map<String, NamedType> declarations) {
        Objects.requireNonNull(type, "type");
        List<TypePattern> patterns = purpose == Purpose.CREATE ? creates : selects;
        return patterns.stream().anyMatch(pattern -> pattern.matches(type, declarations));
    }

    /** Whether it acts on a choice of a markup. */
    public boolean actsOn(MarkupOption wanted) {
        return markups.stream().anyMatch(option -> option.covers(wanted));
    }
}
