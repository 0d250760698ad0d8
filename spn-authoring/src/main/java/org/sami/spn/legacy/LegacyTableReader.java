package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;

/** Reads a domain's {@link LegacyTable} and holds it against the domain's vocabulary. */
public final class LegacyTableReader {
    private static final Map<String, Double> UNITS = Map.of("ms", 1.0, "s", 1000.0, "min", 60_000.0);

    private final Vocabulary vocabulary;
    private final Findings findings = new Findings();

    private LegacyTableReader(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    /**
     * Reads the table of a domain from the class path.
     *
     * @param resource absolute, such as {@code /org/sami/domain/NAME/legacy.json}
     */
    public static Reading<LegacyTable> fromClassPath(String resource, Vocabulary vocabulary) {
        try (InputStream in = LegacyTableReader.class.getResourceAsStream(resource)) {
            if (in == null) {
                Findings none = new Findings();
                none.error(LegacyCodes.FILE, "", "There is no table " + resource);
                return new Reading<>(Optional.empty(), none.list());
            }
            return read(new String(in.readAllBytes(), StandardCharsets.UTF_8), vocabulary);
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    /** Reads a table; with an error there is none. */
    public static Reading<LegacyTable> read(String text, Vocabulary vocabulary) {
        LegacyTableReader reader = new LegacyTableReader(vocabulary);
        Optional<LegacyTable> table = new LegacyReader(reader.findings)
                .parse(text)
                .flatMap(node -> JsonObjectReader.of(node, "", reader.findings))
                .map(reader::table);
        return new Reading<>(reader.findings.hasErrors() ? Optional.empty() : table, reader.findings.list());
    }

    private LegacyTable table(JsonObjectReader root) {
        if (root.integer("formatVersion", 0) != 1) {
            root.problem(LegacyCodes.VERSION, "", "A table of classes has \"formatVersion\": 1");
        }
        Map<String, LegacyTable.EventRule> events = new LinkedHashMap<>();
        root.objects("events").forEach(e -> put(events, e, eventRule(e)));
        Map<String, LegacyTable.MarkupRule> markups = new LinkedHashMap<>();
        root.objects("markups").forEach(m -> put(markups, m, markupRule(m)));
        Map<String, ValueType> types = new LinkedHashMap<>();
        root.textMap("types").forEach((name, type) -> type(root, type).ifPresent(t -> types.put(name, t)));
        Map<String, Map<String, String>> records = new LinkedHashMap<>();
        root.map("records")
                .keySet()
                .forEach(name -> root.object("records").ifPresent(r -> records.put(name, r.textMap(name))));
        Map<String, String> taskClasses = root.textMap("taskClasses");
        LegacyTable.Unknown unknown = root.object("unknown")
                .map(this::unknown)
                .orElse(LegacyTable.empty().unknown());
        return new LegacyTable(events, markups, types, records, taskClasses, unknown);
    }

    private static <R> void put(Map<String, R> rules, JsonObjectReader c, R rule) {
        String name = c.text("class");
        if (rules.put(name, rule) != null) {
            c.problem(LegacyCodes.DUPLICATE, "class", "The class " + name + " is there twice", name);
        }
    }

    private Optional<ValueType> type(JsonObjectReader root, String text) {
        Optional<ValueType> type = TypeNames.parse(text);
        if (type.isEmpty()
                || (type.get() instanceof ValueType.Named named
                        && !vocabulary.types().containsKey(named.name()))) {
            root.problem(LegacyCodes.TABLE, "types", "\"" + text + "\" is no type of the domain");
            return Optional.empty();
        }
        return type;
    }

    private LegacyTable.EventRule eventRule(JsonObjectReader e) {
        String name = e.text("event");
        Optional<EventType> type = vocabulary.event(name);
        if (type.isEmpty() && !name.isEmpty()) {
            e.problem(LegacyCodes.TABLE, "event", "The domain has no event " + name, name);
        }
        Map<String, LegacyTable.FieldRule> fields = rules(e, "fields");
        Map<String, JsonNode> set = new LinkedHashMap<>();
        e.map("set").forEach((field, element) -> set.put(field, element.node()));
        type.ifPresent(t -> {
            fields.forEach((legacy, rule) -> checkField(e, t, rule.to()));
            set.keySet().forEach(field -> checkField(e, t, field));
        });
        return new LegacyTable.EventRule(name, fields, set);
    }

    private static void checkField(JsonObjectReader e, EventType type, String field) {
        if (!field.isEmpty() && type.field(field).isEmpty()) {
            e.problem(
                    LegacyCodes.TABLE,
                    "fields",
                    type.name() + " has no field " + field + "; it has "
                            + type.fields().stream().map(FieldType::name).toList(),
                    type.name());
        }
    }

    private LegacyTable.MarkupRule markupRule(JsonObjectReader m) {
        String name = m.text("markup");
        Optional<MarkupType> type = vocabulary.markup(name);
        if (type.isEmpty() && !name.isEmpty()) {
            m.problem(LegacyCodes.TABLE, "markup", "The domain has no markup " + name, name);
        }
        Map<String, List<LegacyTable.FieldRule>> options = alternatives(m, "options");
        type.ifPresent(t -> options.values().stream().flatMap(List::stream).forEach(rule -> {
            if (!rule.to().isEmpty()
                    && t.options().stream().noneMatch(o -> o.name().equals(rule.to()))) {
                m.problem(LegacyCodes.TABLE, "options", t.name() + " has no option " + rule.to(), t.name());
            }
        }));
        Map<String, JsonNode> set = new LinkedHashMap<>();
        m.map("set").forEach((option, element) -> set.put(option, element.node()));
        return new LegacyTable.MarkupRule(name, options, set);
    }

    private static Map<String, LegacyTable.FieldRule> rules(JsonObjectReader c, String member) {
        Map<String, LegacyTable.FieldRule> rules = new LinkedHashMap<>();
        c.object(member)
                .ifPresent(all -> c.map(member)
                        .keySet()
                        .forEach(name -> all.object(name).ifPresent(rule -> rules.put(name, rule(name, rule)))));
        return rules;
    }

    /** Rules of which each name has one, or a list of some. */
    private static Map<String, List<LegacyTable.FieldRule>> alternatives(JsonObjectReader c, String member) {
        Map<String, List<LegacyTable.FieldRule>> rules = new LinkedHashMap<>();
        c.object(member)
                .ifPresent(all -> c.map(member).forEach((name, element) -> {
                    List<JsonObjectReader> listed = element.node().isArray()
                            ? all.objects(name)
                            : all.object(name).stream().toList();
                    rules.put(name, listed.stream().map(r -> rule(name, r)).toList());
                }));
        return rules;
    }

    private static LegacyTable.FieldRule rule(String name, JsonObjectReader r) {
        String reason = r.text("drop", "");
        boolean waitForAll = r.flag("waitForAll");
        String unit = r.text("unit", "ms");
        if (!UNITS.containsKey(unit)) {
            r.problem(LegacyCodes.TABLE, "unit", "\"" + unit + "\" is none of: ms, s, min");
        }
        Map<String, JsonNode> values = new LinkedHashMap<>();
        r.map("values").forEach((constant, e) -> values.put(constant, e.node()));
        String to = reason.isEmpty() && !waitForAll ? r.text("to", name) : "";
        return new LegacyTable.FieldRule(
                to, UNITS.getOrDefault(unit, 1.0), values, waitForAll, reason, Set.copyOf(r.texts("only")));
    }

    private LegacyTable.Unknown unknown(JsonObjectReader u) {
        LegacyTable.Unknown unknown = new LegacyTable.Unknown(
                u.text("output"), u.text("input"), u.text("classField"), u.text("contentField"));
        checkUnknown(u, unknown.output(), Direction.OUTPUT, unknown);
        checkUnknown(u, unknown.input(), Direction.INPUT, unknown);
        return unknown;
    }

    private void checkUnknown(JsonObjectReader u, String event, Direction side, LegacyTable.Unknown unknown) {
        Optional<EventType> type = vocabulary.event(event).filter(t -> t.direction() == side);
        if (type.isEmpty()) {
            u.problem(LegacyCodes.TABLE, "", "The domain has no such event for unknown ones: " + event, event);
        } else {
            checkField(u, type.get(), unknown.classField());
            checkField(u, type.get(), unknown.contentField());
        }
    }
}
