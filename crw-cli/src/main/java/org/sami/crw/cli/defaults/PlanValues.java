package org.sami.crw.cli.defaults;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.spn.json.ValueJson;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/** What fields of events and options of markups are where a plan does not give them; of times and measures also those that a plan has to give. */
final class PlanValues {
    private static final Set<ValueType> MEASURES = Set.of(ValueType.Simple.REAL, ValueType.Simple.DURATION);

    private PlanValues() {}

    static List<DefaultValue> of(Vocabulary vocabulary) {
        Stream<DefaultValue> events = vocabulary.events().values().stream()
                .filter(event -> event.direction() == Direction.OUTPUT)
                .flatMap(event -> event.fields().stream()
                        .filter(field -> field.required()
                                ? isMeasure(field)
                                : field.defaultValue().isPresent())
                        .map(field -> value("Plans: fields of events", event.name(), field, vocabulary)));
        Stream<DefaultValue> markups = vocabulary.markups().values().stream()
                .flatMap(markup -> markup.options().stream()
                        .filter(option -> option.defaultValue().isPresent() || isMeasure(option))
                        .map(option -> value("Plans: options of markups", markup.name(), option, vocabulary)));
        return Stream.concat(events, markups).toList();
    }

    private static boolean isMeasure(FieldType field) {
        return MEASURES.contains(field.type());
    }

    private static DefaultValue value(String subject, String owner, FieldType field, Vocabulary vocabulary) {
        String value = field.defaultValue()
                .map(given -> text(ValueJson.write(given, field.type(), vocabulary.types())))
                .orElse("");
        return new DefaultValue(subject, owner + "." + field.name(), value, field.unit(), field.help(), "plan");
    }

    private static String text(JsonNode value) {
        return value.isTextual() && !value.textValue().isEmpty() ? value.textValue() : value.toString();
    }
}
