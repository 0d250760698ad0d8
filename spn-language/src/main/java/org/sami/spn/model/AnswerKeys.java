package org.sami.spn.model;

import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/** The types of the values that an operator gives, by the keys under which a decision asks for them. */
public final class AnswerKeys {
    private AnswerKeys() {}

    /**
     * The type under a key: a field of the answering event, a parameter {@code eventId.field}, or a variable's name.
     *
     * @param event id of the asking output event, empty for the parameters of the mission
     */
    public static Optional<ValueType> type(
            Vocabulary vocabulary,
            Map<String, OutputEventSpec> outputs,
            Map<String, ValueType> variables,
            String event,
            String key) {
        if (key.startsWith("@")) {
            return Optional.ofNullable(variables.get(key));
        }
        if (event.isEmpty()) {
            int dot = key.lastIndexOf('.');
            return dot < 0
                    ? Optional.empty()
                    : asking(vocabulary, outputs, key.substring(0, dot))
                            .flatMap(t -> t.field(key.substring(dot + 1)))
                            .map(FieldType::type);
        }
        return asking(vocabulary, outputs, event)
                .flatMap(EventType::decision)
                .map(DecisionType::accepted)
                .flatMap(vocabulary::event)
                .flatMap(t -> t.field(key))
                .map(FieldType::type);
    }

    private static Optional<EventType> asking(
            Vocabulary vocabulary, Map<String, OutputEventSpec> outputs, String event) {
        return Optional.ofNullable(outputs.get(event))
                .map(OutputEventSpec::type)
                .flatMap(vocabulary::event);
    }
}
