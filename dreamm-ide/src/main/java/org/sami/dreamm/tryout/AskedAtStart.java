package org.sami.dreamm.tryout;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * A field that a plan asks for when a mission starts, and that may be given.
 *
 * @param key {@code eventId.field}
 * @param defaultValue what it is where nothing is given
 */
record AskedAtStart(String key, FieldType field, Optional<Value> defaultValue) {
    AskedAtStart {
        Objects.requireNonNull(key, "key");
        Objects.requireNonNull(field, "field");
        Objects.requireNonNull(defaultValue, "defaultValue");
    }

    /** All that a plan asks, in the order of its places; what is locked is not asked. */
    static List<AskedAtStart> of(Plan plan, Vocabulary vocabulary) {
        List<AskedAtStart> asked = new ArrayList<>();
        for (Place place : plan.places()) {
            for (OutputEventSpec event : place.outputs()) {
                for (Map.Entry<String, FieldSource> each : event.fields().entrySet()) {
                    Optional<FieldType> field =
                            vocabulary.event(event.type()).flatMap((EventType type) -> type.field(each.getKey()));
                    if (field.isPresent() && each.getValue() instanceof FieldSource.Asked source && source.editable()) {
                        asked.add(
                                new AskedAtStart(event.id() + "." + each.getKey(), field.get(), source.defaultValue()));
                    }
                }
            }
        }
        return asked;
    }
}
