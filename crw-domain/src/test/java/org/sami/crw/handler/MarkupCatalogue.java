package org.sami.crw.handler;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.crw.handler.EventCatalogue.Check;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;

/**
 * For each option of the vocabulary's markups the effect by which one sees that it acts, and the scene that shows it on a model. To add
 * an option: {@code shows} it in the cases that it belongs to; a new class of cases is a line of {@link #CASES}. An option of an
 * enumeration has a row for each constant ({@code Sort.order=INCREASING}), any other one row ({@code Keyword.source}).
 */
final class MarkupCatalogue {
    /** One option's row. */
    record Row(String option, String effect, Check check) {}

    private static final List<Consumer<MarkupCatalogue>> CASES = List.of(
            DecisionMarkupCases::add,
            MessageMarkupCases::add,
            ServiceMarkupCases::add,
            PhaseMarkupCases::add,
            MapMarkupCases::add,
            StatusMarkupCases::add);

    private final Set<String> declared = declared();
    private final Map<String, Row> rows = new LinkedHashMap<>();

    /** The whole catalogue. */
    static MarkupCatalogue whole() {
        MarkupCatalogue catalogue = new MarkupCatalogue();
        CASES.forEach(cases -> cases.accept(catalogue));
        return catalogue;
    }

    /** What rows are wanted for, in the vocabulary's order. */
    static Set<String> declared() {
        Set<String> options = new LinkedHashSet<>();
        for (MarkupType markup : TestWorld.VOCABULARY.markups().values()) {
            markup.options().forEach(option -> options.addAll(choices(markup.name() + "." + option.name(), option)));
        }
        return options;
    }

    private static List<String> choices(String name, FieldType option) {
        return option.type() instanceof ValueType.Named named
                        && TestWorld.VOCABULARY.types().get(named.name()) instanceof NamedType.Enumeration enumeration
                ? enumeration.constants().stream()
                        .map(constant -> name + "=" + constant)
                        .toList()
                : List.of(name);
    }

    /** Adds an option; one that has a row already, or that no vocabulary declares, is a mistake. */
    MarkupCatalogue shows(String option, String effect, Check check) {
        if (!declared.contains(option)) {
            throw new IllegalArgumentException("No markup has the option " + option + "; there are " + declared);
        }
        if (rows.put(option, new Row(option, effect, check)) != null) {
            throw new IllegalArgumentException(option + " is in the catalogue twice");
        }
        return this;
    }

    /** The rows by option. */
    Map<String, Row> rows() {
        return rows;
    }
}
