package org.sami.crw.judgement;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.session.api.DraftAnswer;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * An output event of the asking plan with what is known of its fields. Immutable.
 *
 * @param type of the event
 * @param known values of fields, as they stand
 * @param asked the keys of the question's items that give fields, by field
 */
record JudgedRequest(String type, Map<String, Value> known, Map<String, String> asked) {
    static final String WITHIN = "within";
    static final String AVOID = "avoid";

    JudgedRequest {
        Objects.requireNonNull(type, "type");
        known = Map.copyOf(known);
        asked = Map.copyOf(asked);
    }

    /** The values that fields of an event have where a plan says nothing; changeable, in the vocabulary's order. */
    static Map<String, Value> defaults(Vocabulary vocabulary, String type) {
        Map<String, Value> defaults = new LinkedHashMap<>();
        vocabulary
                .event(type)
                .ifPresent(known -> known.fields()
                        .forEach(field -> field.defaultValue().ifPresent(value -> defaults.put(field.name(), value))));
        return defaults;
    }

    /** The fields that an item gives. */
    List<String> fieldsOf(String item) {
        return asked.entrySet().stream()
                .filter(one -> one.getValue().equals(item))
                .map(Map.Entry::getKey)
                .toList();
    }

    /** The values that its fields would have, as far as they are known. */
    Map<String, Value> values(DraftAnswer draft) {
        Map<String, Value> values = new LinkedHashMap<>(known);
        asked.forEach((field, item) -> {
            values.remove(field);
            Optional.ofNullable(draft.values().get(item)).ifPresent(value -> values.put(field, value));
        });
        return values;
    }
}
