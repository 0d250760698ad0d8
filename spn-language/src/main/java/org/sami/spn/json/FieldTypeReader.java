package org.sami.spn.json;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldLimits;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.GeographyMark;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.TaskClass;

/** Reads declarations of fields, and of markups and task classes, which are little more than fields. */
final class FieldTypeReader {
    private final Map<String, NamedType> types;
    private final Problems problems;

    FieldTypeReader(Map<String, NamedType> types, Problems problems) {
        this.types = types;
        this.problems = problems;
    }

    List<FieldType> fields(JsonObjectReader m, String member) {
        Names taken = new Names(problems);
        List<FieldType> fields = m.objects(member).stream()
                .map(f -> field(f, taken))
                .flatMap(Optional::stream)
                .toList();
        FieldLimitsReader.checkOrder(fields, m.at(member), problems);
        return fields;
    }

    private Optional<FieldType> field(JsonObjectReader m, Names taken) {
        String name = m.text("name");
        taken.take(name, m.pointer());
        Optional<ValueType> type = type(m, "type");
        String unit = m.text("unit", "");
        Optional<Value> defaultValue = type.isPresent()
                ? m.node("default").flatMap(n -> new ValueReader(types, problems).read(n, type.get(), m.at("default")))
                : Optional.empty();
        boolean required = m.flag("required", !m.has("default"));
        if (required && m.has("default")) {
            m.problem(Codes.BAD_VALUE, "required", "A field with a default is not required");
        }
        String help = m.text("help", "");
        Optional<GeographyMark> mark = m.has("geography") ? m.word("geography", GeographyMark.class) : Optional.empty();
        FieldLimits limits = FieldLimitsReader.read(m, type, problems);
        m.done();
        if (mark.isPresent() && type.isPresent() && !type.get().equals(type(mark.get()))) {
            m.problem(
                    Codes.BAD_VALUE,
                    "geography",
                    "The mark " + Words.of(mark.get()) + " is for fields of type " + TypeNames.of(type(mark.get())));
        }
        return type.map(t -> new FieldType(name, t, unit, required, defaultValue, help, mark, limits));
    }

    private static ValueType type(GeographyMark mark) {
        return switch (mark) {
            case AVOID -> new ValueType.ListOf(ValueType.Simple.AREA);
            case WITHIN, LANES -> ValueType.Simple.AREA;
            case LANE_SPACING -> ValueType.Simple.REAL;
        };
    }

    /** A type that must be there and whose names must be declared. */
    Optional<ValueType> type(JsonObjectReader m, String member) {
        String text = m.text(member);
        Optional<ValueType> type = TypeNames.parse(text);
        if (type.isEmpty() && !text.isEmpty()) {
            m.problem(
                    Codes.UNKNOWN_TYPE,
                    member,
                    "\"" + text + "\" is no type, such as real, list<point>, Allocation" + guess(text));
        }
        return type.filter(t -> NamedTypeReader.check(t, types, m.at(member), problems));
    }

    /** For each word that names no type: which may have been meant. */
    private String guess(String text) {
        List<String> known = new ArrayList<>(TypeNames.builtIn());
        known.addAll(types.keySet());
        StringBuilder guess = new StringBuilder();
        for (String word : text.split("[<>, ]+", -1)) {
            if (!word.isEmpty() && !known.contains(word)) {
                guess.append(Suggestions.meant(known, word));
            }
        }
        return guess.toString();
    }

    Optional<MarkupType> markup(JsonObjectReader m, Names taken) {
        String name = m.text("name");
        taken.take(name, m.pointer());
        List<String> aliases = m.texts("aliases");
        aliases.forEach(alias -> taken.take(alias, m.at("aliases")));
        return Optional.of(new MarkupType(name, aliases, fields(m, "options"), m.text("label"), m.text("help")));
    }

    Optional<TaskClass> taskClass(JsonObjectReader m, Names taken) {
        String name = m.text("name");
        taken.take(name, m.pointer());
        return Optional.of(new TaskClass(name, fields(m, "fields"), m.text("help")));
    }
}
