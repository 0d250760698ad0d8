package org.sami.spn.component;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;

/**
 * Chooses the components of an interaction (thesis 5.2.4, Algorithms 4 and 6; {@link DirectChoice} is Algorithm 5). A function of
 * the library, the types and the requested options; equal questions have equal answers. Immutable.
 *
 * <p>Where the thesis's pseudocode slips, this is what is done (docs/components.md): an element of a list and an entry of a map are
 * chosen for the same purpose as the whole; key and value are looked at each by itself; a part of a record may be a list or a map; and
 * the score of a whole is the least score of its parts.
 */
public final class ComponentChoice {
    /** How many records within records are opened, as in Algorithm 4. */
    public static final int STANDARD_LIMIT = 3;

    private final DirectChoice direct;
    private final Map<String, NamedType> declarations;
    private final int limit;

    /**
     * A choice among the components of a library.
     *
     * @param declarations the named types of the vocabulary, by name
     * @param limit how many records within records are opened, from 0
     */
    public ComponentChoice(ComponentLibrary library, Map<String, NamedType> declarations, int limit) {
        if (limit < 0) {
            throw new IllegalArgumentException("A limit of " + limit);
        }
        this.direct = new DirectChoice(library, declarations);
        this.declarations = Map.copyOf(declarations);
        this.limit = limit;
    }

    /** A choice with the thesis's limit. */
    public ComponentChoice(ComponentLibrary library, Map<String, NamedType> declarations) {
        this(library, declarations, STANDARD_LIMIT);
    }

    /** The components of an interaction; where one of its values has none, a warning in the place of all. */
    public ChosenComponent choose(Interaction interaction) {
        if (interaction.values().size() == 1) {
            ValueType type = interaction.values().values().iterator().next();
            return choose(interaction.purpose(), type, interaction.wanted());
        }
        return form(interaction.purpose(), interaction.values(), interaction.wanted(), limit);
    }

    /** The components of one value (Algorithm 4). */
    public ChosenComponent choose(Purpose purpose, ValueType type, List<MarkupOption> wanted) {
        Objects.requireNonNull(type, "type");
        return choose(purpose, type, wanted, limit);
    }

    /** How each component does by itself with a value of a type, in the order of the domain. */
    public List<Candidate> candidates(Purpose purpose, ValueType type, List<MarkupOption> wanted) {
        return direct.candidates(purpose, type, wanted);
    }

    private ChosenComponent choose(Purpose purpose, ValueType type, List<MarkupOption> wanted, int left) {
        Optional<ChosenComponent.Direct> best = direct.best(purpose, type, wanted);
        if (best.isPresent()) {
            return best.get();
        }
        if (type instanceof ValueType.ListOf list) {
            ChosenComponent element = choose(purpose, list.element(), wanted, left);
            return element instanceof ChosenComponent.Warning ? element : new ChosenComponent.Repeated(element);
        }
        if (type instanceof ValueType.MapOf map) {
            ChosenComponent key = choose(purpose, map.key(), wanted, left);
            ChosenComponent value = choose(purpose, map.value(), wanted, left);
            if (key instanceof ChosenComponent.Warning) {
                return key;
            }
            return value instanceof ChosenComponent.Warning ? value : new ChosenComponent.Entries(key, value);
        }
        if (type instanceof ValueType.Named named
                && declarations.get(named.name()) instanceof NamedType.RecordType declared) {
            return left == 0
                    ? new ChosenComponent.Warning("No component is found for " + named.name()
                            + ": it lies in more than " + limit + " records, one in the other")
                    : form(purpose, declared.fields(), wanted, left - 1);
        }
        return new ChosenComponent.Warning("No component can " + (purpose == Purpose.CREATE ? "ask for" : "show")
                + " a value of type " + TypeNames.of(type));
    }

    private ChosenComponent form(Purpose purpose, Map<String, ValueType> values, List<MarkupOption> wanted, int left) {
        Map<String, ChosenComponent> fields = new LinkedHashMap<>();
        for (Map.Entry<String, ValueType> value : values.entrySet()) {
            ChosenComponent field = choose(purpose, value.getValue(), wanted, left);
            if (field instanceof ChosenComponent.Warning) {
                return field;
            }
            fields.put(value.getKey(), field);
        }
        return new ChosenComponent.Form(fields);
    }
}
