package org.sami.spn.json;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;

/** Reads the events on places and transitions. */
final class EventSpecReader {
    private static final List<String> SOURCE = List.of("value", "ask", "variable", "default");

    private final PlanParts parts;
    private final Names ids;
    private final Set<String> refused = new HashSet<>();

    EventSpecReader(PlanParts parts, Names ids) {
        this.parts = parts;
        this.ids = ids;
    }

    Optional<OutputEventSpec> output(JsonObjectReader m) {
        String id = id(m);
        Optional<EventType> type = type(m, Direction.OUTPUT);
        Map<String, FieldSource> fields = new LinkedHashMap<>();
        m.map("fields")
                .forEach((name, element) -> type.flatMap(
                                t -> parts.field(name, t.fields(), "event " + t.name(), element.pointer()))
                        .flatMap(field -> source(element, field))
                        .ifPresent(source -> fields.put(name, source)));
        Map<String, String> writes = writes(m, type);
        var markups = parts.markups(m);
        m.done();
        if (type.isEmpty()) {
            refused.add(id);
        }
        return type.map(t -> new OutputEventSpec(id, t.name(), fields, writes, markups));
    }

    Optional<InputEventSpec> input(JsonObjectReader m) {
        String id = id(m);
        Optional<EventType> type = type(m, Direction.INPUT);
        Map<String, JsonObjectReader.Element> given = m.map("fields");
        Map<String, Value> fields = type.map(t -> parts.fields(given, t.fields(), "event " + t.name()))
                .orElse(Map.of());
        Map<String, String> writes = writes(m, type);
        var markups = parts.markups(m);
        m.done();
        return type.map(t -> new InputEventSpec(id, t.name(), fields, writes, markups));
    }

    /** Ids of output events that stand in the document and could not be read: what refers to them is no problem of its own. */
    Set<String> refused() {
        return refused;
    }

    private String id(JsonObjectReader m) {
        String id = m.text("id");
        ids.take(id, m.at("id"));
        return id;
    }

    private Optional<EventType> type(JsonObjectReader m, Direction side) {
        String name = m.text("type");
        Optional<EventType> type = parts.vocabulary().event(name);
        if (type.isEmpty() && !name.isEmpty()) {
            m.problem(
                    Codes.UNKNOWN_EVENT,
                    "type",
                    "There is no event \"" + name + "\"" + NearMatches.guess(parts.vocabulary(), side, name));
        }
        if (type.isPresent() && type.get().direction() != side) {
            m.problem(
                    Codes.EVENT_SIDE,
                    "type",
                    type.get().name() + " is an " + Words.of(type.get().direction()) + " event: it stands on "
                            + (side == Direction.INPUT ? "places" : "transitions"));
            return Optional.empty();
        }
        return type;
    }

    private Map<String, String> writes(JsonObjectReader m, Optional<EventType> type) {
        Map<String, String> writes = new LinkedHashMap<>();
        m.textMap("writes").forEach((field, variable) -> {
            String pointer = Problems.at(m.at("writes"), field);
            type.ifPresent(t -> parts.field(field, t.fields(), "event " + t.name(), pointer));
            if (parts.checkVariable(variable, pointer)) {
                writes.put(field, variable);
            }
        });
        return writes;
    }

    /** Exactly one of value, ask, variable says where a field comes from. */
    Optional<FieldSource> source(JsonObjectReader.Element element, FieldType field) {
        Optional<JsonObjectReader> found = JsonObjectReader.of(element.node(), element.pointer(), parts.problems());
        if (found.isEmpty()) {
            return Optional.empty();
        }
        JsonObjectReader m = found.get();
        int kinds = (m.has("value") ? 1 : 0) + (m.has("ask") ? 1 : 0) + (m.has("variable") ? 1 : 0);
        if (kinds == 0 && reportsUnknown(m)) {
            return Optional.empty();
        }
        if (kinds != 1) {
            m.problem(
                    Codes.MISSING,
                    "",
                    "The field " + field.name() + " comes from exactly one of \"value\", \"ask\", \"variable\"");
            return Optional.empty();
        }
        Optional<FieldSource> source = m.has("ask") ? asked(m, field) : m.has("value") ? fixed(m, field) : variable(m);
        m.done();
        return source;
    }

    /** Reports members that none of the sources of a field has; one of them may be a misspelt source. */
    private boolean reportsUnknown(JsonObjectReader m) {
        int before = parts.problems().count();
        for (String known : SOURCE) {
            m.node(known);
        }
        m.done();
        return parts.problems().count() > before;
    }

    private Optional<FieldSource> fixed(JsonObjectReader m, FieldType field) {
        return m.node("value")
                .flatMap(n -> parts.value(new JsonObjectReader.Element(n, m.at("value")), field.type()))
                .map(FieldSource.Fixed::new);
    }

    private Optional<FieldSource> asked(JsonObjectReader m, FieldType field) {
        int before = parts.problems().count();
        Optional<Ask> ask = m.word("ask", Ask.class);
        Optional<Value> value = m.node("default")
                .flatMap(n -> parts.value(new JsonObjectReader.Element(n, m.at("default")), field.type()));
        if (ask.isPresent() && ask.get() == Ask.LOCKED && !m.has("default")) {
            m.problem(Codes.MISSING, "", "The locked field " + field.name() + " needs a \"default\"");
        }
        return parts.problems().count() > before
                ? Optional.empty()
                : ask.map(a -> new FieldSource.Asked(value, a == Ask.EDITABLE));
    }

    private Optional<FieldSource> variable(JsonObjectReader m) {
        String name = m.text("variable");
        if (name.equals(Reserved.TASK_VARIABLE)) {
            return Optional.of(new FieldSource.FromTask());
        }
        return parts.checkVariable(name, m.at("variable"))
                ? Optional.of(new FieldSource.FromVariable(name))
                : Optional.empty();
    }

    /** How a field that is asked at the start is shown. */
    enum Ask {
        EDITABLE,
        LOCKED
    }
}
