package org.sami.spn.json;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;

/** Reads declarations of enumerations and records. */
final class NamedTypeReader {
    private final Problems problems;
    private final Map<String, ValueType> references = new LinkedHashMap<>();

    NamedTypeReader(Problems problems) {
        this.problems = problems;
    }

    Optional<NamedType> read(JsonObjectReader m, Names taken) {
        boolean isEnum = m.has("enum");
        String name = m.text(isEnum ? "enum" : "record");
        if (!name.isEmpty() && !name.matches("[A-Z][A-Za-z0-9]*")) {
            m.problem(Codes.BAD_VALUE, isEnum ? "enum" : "record", "A type's name is like Allocation: " + name);
        }
        taken.take(name, m.pointer());
        return isEnum ? readEnum(m, name) : readRecord(m, name);
    }

    private Optional<NamedType> readEnum(JsonObjectReader m, String name) {
        List<String> constants = m.texts("constants");
        if (constants.isEmpty()) {
            m.problem(Codes.MISSING, "", "The enumeration " + name + " has no \"constants\"");
        }
        Names seen = new Names(problems);
        constants.forEach(c -> seen.take(c, m.at("constants")));
        return Optional.of(new NamedType.Enumeration(name, constants));
    }

    private Optional<NamedType> readRecord(JsonObjectReader m, String name) {
        Map<String, ValueType> fields = new LinkedHashMap<>();
        m.textMap("fields").forEach((field, text) -> {
            String where = Problems.at(m.at("fields"), field);
            Optional<ValueType> type = TypeNames.parse(text);
            if (type.isEmpty()) {
                problems.add(Codes.UNKNOWN_TYPE, where, "\"" + text + "\" is no type");
            }
            type.ifPresent(t -> {
                fields.put(field, t);
                references.put(where, t);
            });
        });
        if (fields.isEmpty()) {
            m.problem(Codes.MISSING, "", "The record " + name + " has no \"fields\"");
        }
        return Optional.of(new NamedType.RecordType(name, fields));
    }

    /** Reports names of types that none of the declarations, all read by now, declares. */
    void checkReferences(Map<String, NamedType> types) {
        references.forEach((where, type) -> check(type, types, where, problems));
    }

    static boolean check(ValueType type, Map<String, NamedType> types, String where, Problems problems) {
        if (type instanceof ValueType.ListOf list) {
            return check(list.element(), types, where, problems);
        }
        if (type instanceof ValueType.MapOf map) {
            return check(map.key(), types, where, problems) && check(map.value(), types, where, problems);
        }
        if (type instanceof ValueType.Named named && !types.containsKey(named.name())) {
            problems.add(
                    Codes.UNKNOWN_TYPE,
                    where,
                    "The type " + named.name() + " is not declared" + NearMatches.meant(types.keySet(), named.name()));
            return false;
        }
        return true;
    }
}
