package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.json.ValueJson;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes events of this language of the export's, by the table of classes; what is in no table is kept as unknown. */
final class EventConverter {
    private final Vocabulary vocabulary;
    private final LegacyTable table;
    private final LegacyValues values;
    private final MarkupConverter markups;
    private final Findings findings;
    private final Counts.Tally explained;
    private final Set<String> told = new HashSet<>();
    private final Map<String, Double> units = new HashMap<>();

    EventConverter(
            Vocabulary vocabulary,
            LegacyTable table,
            LegacyValues values,
            MarkupConverter markups,
            Findings findings,
            Counts.Tally explained) {
        this.vocabulary = vocabulary;
        this.table = table;
        this.values = values;
        this.markups = markups;
        this.findings = findings;
        this.explained = explained;
    }

    /** How many milliseconds one is, of numbers in variables that durations are read from. */
    Map<String, Double> units() {
        return units;
    }

    /** The events of a place; those that belong on transitions stay behind, with a finding. */
    List<OutputEventSpec> outputs(LegacyPlan.Vertex place, List<String> notes) {
        return place.events().stream()
                .map(e -> rule(e, Direction.OUTPUT).flatMap(r -> output(place, e, r, notes)))
                .flatMap(Optional::stream)
                .toList();
    }

    /** The events of a transition; those that belong on places stay behind, with a finding. */
    List<InputEventSpec> inputs(LegacyPlan.Vertex transition, List<String> notes) {
        return transition.events().stream()
                .map(e -> rule(e, Direction.INPUT).flatMap(r -> input(transition, e, r, notes)))
                .flatMap(Optional::stream)
                .toList();
    }

    /** Whether an event says that its transition waits for all. */
    boolean waitsForAll(LegacyPlan.Vertex transition) {
        return transition.events().stream()
                .anyMatch(e -> e.values().entrySet().stream()
                        .anyMatch(v -> LegacyTable.find(table.events(), e.className())
                                        .map(r -> r.field(v.getKey()).waitForAll())
                                        .orElse(false)
                                && v.getValue().node().path("value").asBoolean(false)));
    }

    private Optional<LegacyTable.EventRule> rule(LegacyPlan.Event e, Direction side) {
        LegacyTable.EventRule exact = table.events().get(e.className());
        if (exact != null) {
            return Optional.of(exact);
        }
        Optional<LegacyTable.EventRule> found = LegacyTable.find(table.events(), e.className());
        Optional<EventType> named = vocabulary.event(e.simpleName()).filter(t -> t.direction() == side);
        if (found.isEmpty() && named.isPresent()) {
            found = Optional.of(new LegacyTable.EventRule(named.get().name(), Map.of(), Map.of()));
        }
        if (found.isPresent()) {
            tellOnce(
                    e.className(),
                    () -> findings.note(
                            LegacyCodes.BY_NAME,
                            JsonObjectReader.at(e.pointer(), "class"),
                            "The class " + e.className() + " is in no table; it is taken for its namesake here",
                            e.key()));
            return found;
        }
        return unknown(e, side);
    }

    private Optional<LegacyTable.EventRule> unknown(LegacyPlan.Event e, Direction side) {
        LegacyTable.Unknown unknown = table.unknown();
        String event = side == Direction.OUTPUT ? unknown.output() : unknown.input();
        findings.warning(
                LegacyCodes.UNKNOWN_EVENT,
                JsonObjectReader.at(e.pointer(), "class"),
                "The event " + e.key() + " is of the class " + e.className() + ", which this system does not know; "
                        + (event.isEmpty()
                                ? "it is not imported"
                                : "it is kept as " + event + " and nothing answers it"),
                e.key());
        if (event.isEmpty()) {
            lose(e, side == Direction.OUTPUT);
            return Optional.empty();
        }
        return Optional.of(new LegacyTable.EventRule(event, Map.of(), Map.of()));
    }

    private boolean isUnknown(String event) {
        return event.equals(table.unknown().output())
                || event.equals(table.unknown().input());
    }

    private void lose(LegacyPlan.Event e, boolean onPlace) {
        explained.add(onPlace ? CountedKind.PLACE_EVENTS : CountedKind.TRANSITION_EVENTS, 1);
        explained.add(CountedKind.MARKUPS, e.markups().size());
    }

    private boolean isOnWrongSide(LegacyPlan.Vertex vertex, LegacyPlan.Event e, EventType type, List<String> notes) {
        boolean wrong = (type.direction() == Direction.OUTPUT) != vertex.place();
        if (wrong) {
            String message = "The " + (vertex.place() ? "place " : "transition ") + vertex.title() + " carries "
                    + type.name() + ", which belongs on " + (vertex.place() ? "transitions" : "places")
                    + "; the earlier system ignored it there, and it is not imported";
            findings.warning(LegacyCodes.EVENT_SIDE, e.pointer(), message, vertex.key());
            notes.add(message);
            lose(e, vertex.place());
        }
        return wrong;
    }

    private Optional<OutputEventSpec> output(
            LegacyPlan.Vertex place, LegacyPlan.Event e, LegacyTable.EventRule rule, List<String> notes) {
        EventType type = vocabulary.event(rule.event()).orElseThrow();
        if (isOnWrongSide(place, e, type, notes)) {
            return Optional.empty();
        }
        if (isUnknown(type.name())) {
            Map<String, FieldSource> fields = new LinkedHashMap<>();
            unknownFields(e).forEach((field, value) -> fields.put(field, new FieldSource.Fixed(value)));
            return Optional.of(new OutputEventSpec(e.key(), type.name(), fields, Map.of(), markups.convert(e)));
        }
        Map<String, FieldSource> fields = new LinkedHashMap<>();
        for (String name : fieldNames(e)) {
            field(e, type, rule.field(name), name)
                    .flatMap(f -> source(e, f, rule.field(name), name).map(s -> Map.entry(f, s)))
                    .ifPresent(entry -> fields.put(entry.getKey().name(), entry.getValue()));
        }
        constants(type, rule).forEach((field, value) -> fields.putIfAbsent(field, new FieldSource.Fixed(value)));
        for (FieldType field : type.fields()) {
            if (field.required()) {
                fields.putIfAbsent(field.name(), new FieldSource.Asked(Optional.empty(), true));
            }
        }
        return Optional.of(
                new OutputEventSpec(e.key(), type.name(), fields, writes(e, type, rule), markups.convert(e)));
    }

    private Optional<InputEventSpec> input(
            LegacyPlan.Vertex transition, LegacyPlan.Event e, LegacyTable.EventRule rule, List<String> notes) {
        EventType type = vocabulary.event(rule.event()).orElseThrow();
        if (isOnWrongSide(transition, e, type, notes)) {
            return Optional.empty();
        }
        if (isUnknown(type.name())) {
            return Optional.of(
                    new InputEventSpec(e.key(), type.name(), unknownFields(e), Map.of(), markups.convert(e)));
        }
        Map<String, Value> fields = new LinkedHashMap<>();
        e.values().forEach((name, value) -> {
            LegacyTable.FieldRule fieldRule = rule.field(name);
            if (fieldRule.waitForAll()) {
                return;
            }
            field(e, type, fieldRule, name)
                    .flatMap(f -> converted(e, f, fieldRule, value))
                    .ifPresent(v -> fields.put(fieldRule.to(), v));
        });
        e.reads().forEach((name, variable) -> {
            findings.warning(
                    LegacyCodes.UNKNOWN_FIELD,
                    JsonObjectReader.at(JsonObjectReader.at(e.pointer(), "readVariables"), name),
                    "The input event " + e.key() + " reads its field " + name + " from " + variable
                            + ", which it cannot here",
                    e.key());
        });
        constants(type, rule).forEach(fields::putIfAbsent);
        return Optional.of(new InputEventSpec(e.key(), type.name(), fields, writes(e, type, rule), markups.convert(e)));
    }

    private Map<String, Value> unknownFields(LegacyPlan.Event e) {
        Map<String, Value> fields = new LinkedHashMap<>();
        fields.put(table.unknown().classField(), new TextValue(e.className()));
        fields.put(
                table.unknown().contentField(), new TextValue(e.whole().node().toString()));
        return fields;
    }

    private Map<String, Value> constants(EventType type, LegacyTable.EventRule rule) {
        Map<String, Value> constants = new LinkedHashMap<>();
        rule.set()
                .forEach((name, json) -> type.field(name)
                        .flatMap(f -> ValueJson.read(json, f.type(), vocabulary.types())
                                .result())
                        .ifPresent(v -> constants.put(name, v)));
        return constants;
    }

    private static Set<String> fieldNames(LegacyPlan.Event e) {
        Set<String> names = new LinkedHashSet<>(e.declared());
        names.addAll(e.values().keySet());
        names.addAll(e.reads().keySet());
        return names;
    }

    /** The field here; empty, with a finding where something is lost by it, if there is none. */
    private Optional<FieldType> field(LegacyPlan.Event e, EventType type, LegacyTable.FieldRule rule, String name) {
        Optional<FieldType> field = rule.to().isEmpty() ? Optional.empty() : type.field(rule.to());
        boolean set = e.values().containsKey(name) || e.reads().containsKey(name);
        if (field.isEmpty() && set && !rule.reason().isEmpty()) {
            tellOnce(
                    e.className() + "." + name,
                    () -> findings.note(
                            LegacyCodes.DROPPED,
                            JsonObjectReader.at(JsonObjectReader.at(e.pointer(), "fieldValues"), name),
                            "The field " + name + " of " + e.simpleName() + " is not kept, here and elsewhere: "
                                    + rule.reason(),
                            e.key()));
        } else if (field.isEmpty() && set) {
            findings.warning(
                    LegacyCodes.UNKNOWN_FIELD,
                    JsonObjectReader.at(JsonObjectReader.at(e.pointer(), "fieldValues"), name),
                    "The event " + e.key() + " (" + type.name() + ") has no field for " + name + "; it is not imported",
                    e.key());
        }
        return field;
    }

    private void tellOnce(String what, Runnable telling) {
        if (told.add(what)) {
            telling.run();
        }
    }

    private Optional<FieldSource> source(LegacyPlan.Event e, FieldType field, LegacyTable.FieldRule rule, String name) {
        String variable = e.reads().get(name);
        if (variable != null && !variable.isEmpty()) {
            units.put(variable, rule.unitMillis());
            return Optional.of(
                    variable.equals(Reserved.TASK_VARIABLE)
                            ? new FieldSource.FromTask()
                            : new FieldSource.FromVariable(variable));
        }
        LegacyValue given = e.values().get(name);
        Optional<Value> value = given == null || given.isNull() ? Optional.empty() : converted(e, field, rule, given);
        if (value.isEmpty()) {
            return field.required() || e.editable().getOrDefault(name, false)
                    ? Optional.of(new FieldSource.Asked(Optional.empty(), true))
                    : Optional.empty();
        }
        return Optional.of(
                e.editable().getOrDefault(name, false)
                        ? new FieldSource.Asked(value, true)
                        : new FieldSource.Fixed(value.get()));
    }

    private Optional<Value> converted(
            LegacyPlan.Event e, FieldType field, LegacyTable.FieldRule rule, LegacyValue value) {
        Optional<Value> converted = values.convert(value, field.type(), rule);
        if (converted.isEmpty()) {
            JsonNode node = value.node();
            findings.warning(
                    LegacyCodes.VALUE,
                    value.pointer(),
                    "The value of " + field.name() + " of " + e.key() + " (" + e.simpleName() + ") cannot be one here: "
                            + shorten(node.toString()),
                    e.key());
        }
        return converted;
    }

    private static String shorten(String text) {
        return text.length() <= 80 ? text : text.substring(0, 77) + "...";
    }

    private Map<String, String> writes(LegacyPlan.Event e, EventType type, LegacyTable.EventRule rule) {
        Map<String, String> writes = new LinkedHashMap<>();
        e.writes().forEach((name, variable) -> {
            String to = rule.field(name).to();
            if (type.field(to).isPresent()) {
                writes.put(to, variable);
                units.putIfAbsent(variable, rule.field(name).unitMillis());
            } else {
                findings.warning(
                        LegacyCodes.UNKNOWN_FIELD,
                        JsonObjectReader.at(JsonObjectReader.at(e.pointer(), "writeVariables"), name),
                        "The event " + e.key() + " (" + type.name() + ") has no field " + name + " to write to "
                                + variable,
                        e.key());
            }
        });
        return writes;
    }
}
