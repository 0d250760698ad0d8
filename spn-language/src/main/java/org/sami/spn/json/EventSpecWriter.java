package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.TaskClass;
import org.sami.spn.vocabulary.Vocabulary;

/** Writes the events on places and transitions, their markups, and the fields of tasks. */
final class EventSpecWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final Vocabulary vocabulary;
    private final ValueWriter values;

    EventSpecWriter(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
        this.values = new ValueWriter(vocabulary.types());
    }

    ObjectNode output(OutputEventSpec spec) {
        EventType type = type(spec.type());
        ObjectNode node = NODES.objectNode().put("id", spec.id()).put("type", spec.type());
        if (!spec.fields().isEmpty()) {
            ObjectNode fields = node.putObject("fields");
            spec.fields().forEach((name, source) -> fields.set(name, source(source, fieldType(type, name))));
        }
        OptionalMembers.putTextMap(node, "writes", spec.writes());
        OptionalMembers.put(node, "markups", spec.markups(), this::markup);
        return node;
    }

    ObjectNode input(InputEventSpec spec) {
        EventType type = type(spec.type());
        ObjectNode node = NODES.objectNode().put("id", spec.id()).put("type", spec.type());
        if (!spec.fields().isEmpty()) {
            node.set("fields", fields(spec.fields(), type.fields(), type.name()));
        }
        OptionalMembers.putTextMap(node, "writes", spec.writes());
        OptionalMembers.put(node, "markups", spec.markups(), this::markup);
        return node;
    }

    ObjectNode taskFields(TaskSpec task) {
        TaskClass taskClass = vocabulary.taskClasses().get(task.taskClass());
        if (taskClass == null) {
            throw new IllegalArgumentException("The vocabulary has no task class " + task.taskClass());
        }
        return fields(task.fields(), taskClass.fields(), taskClass.name());
    }

    ObjectNode fields(Map<String, Value> fields, List<FieldType> declared, String owner) {
        ObjectNode node = NODES.objectNode();
        fields.forEach((name, value) -> node.set(name, values.write(value, declaredType(declared, name, owner))));
        return node;
    }

    EventType type(String name) {
        return vocabulary
                .event(name)
                .orElseThrow(() -> new IllegalArgumentException("The vocabulary has no event " + name));
    }

    private ObjectNode source(FieldSource source, ValueType type) {
        ObjectNode node = NODES.objectNode();
        if (source instanceof FieldSource.Fixed s) {
            node.set("value", values.write(s.value(), type));
        } else if (source instanceof FieldSource.Asked s) {
            EventSpecReader.Ask ask = s.editable() ? EventSpecReader.Ask.EDITABLE : EventSpecReader.Ask.LOCKED;
            node.put("ask", Words.of(ask));
            s.defaultValue().ifPresent(v -> node.set("default", values.write(v, type)));
        } else if (source instanceof FieldSource.FromVariable s) {
            node.put("variable", s.variable());
        } else {
            node.put("variable", Reserved.TASK_VARIABLE);
        }
        return node;
    }

    private ObjectNode markup(MarkupSpec markup) {
        ObjectNode node = NODES.objectNode().put("type", markup.type());
        if (!markup.options().isEmpty()) {
            MarkupType type = vocabulary
                    .markup(markup.type())
                    .orElseThrow(() -> new IllegalArgumentException("The vocabulary has no markup " + markup.type()));
            JsonNode options = fields(markup.options(), type.options(), type.name());
            node.set("options", options);
        }
        return node;
    }

    private static ValueType fieldType(EventType type, String field) {
        return declaredType(type.fields(), field, type.name());
    }

    private static ValueType declaredType(List<FieldType> declared, String name, String owner) {
        return declared.stream()
                .filter(f -> f.name().equals(name))
                .map(FieldType::type)
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(owner + " has no field " + name));
    }
}
