package org.sami.spn.value;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Types as text: {@code real}, {@code list<point>}, {@code map<proxy,path>}, or the name of a declared type. Declared names
 * begin with a capital letter, the others do not.
 */
public final class TypeNames {
    private static final int DEEPEST = 8;

    private TypeNames() {}

    /** The names of the types that need no declaration and hold no others, and the words by which those that do begin. */
    public static List<String> builtIn() {
        List<String> names = new ArrayList<>(List.of("list", "map"));
        for (ValueType.Simple simple : ValueType.Simple.values()) {
            names.add(of(simple));
        }
        return names;
    }

    /** The type as text. */
    public static String of(ValueType type) {
        if (type instanceof ValueType.ListOf list) {
            return "list<" + of(list.element()) + ">";
        }
        if (type instanceof ValueType.MapOf map) {
            return "map<" + of(map.key()) + "," + of(map.value()) + ">";
        }
        if (type instanceof ValueType.Named named) {
            return named.name();
        }
        return ((ValueType.Simple) type).name().toLowerCase(Locale.ROOT);
    }

    /** The type of a text, empty where the text is none. Whether a declared name exists is not looked at. */
    public static Optional<ValueType> parse(String text) {
        return parse(text.strip(), 0);
    }

    private static Optional<ValueType> parse(String text, int depth) {
        if (depth > DEEPEST) {
            return Optional.empty();
        }
        if (text.startsWith("list<") && text.endsWith(">")) {
            return parse(inner(text, 5), depth + 1).map(ValueType.ListOf::new);
        }
        if (text.startsWith("map<") && text.endsWith(">")) {
            return parseMap(inner(text, 4), depth + 1);
        }
        if (text.matches("[A-Z][A-Za-z0-9]*")) {
            return Optional.of(new ValueType.Named(text));
        }
        for (ValueType.Simple simple : ValueType.Simple.values()) {
            if (of(simple).equals(text)) {
                return Optional.of(simple);
            }
        }
        return Optional.empty();
    }

    private static Optional<ValueType> parseMap(String text, int depth) {
        int nesting = 0;
        for (int i = 0; i < text.length(); i++) {
            char c = text.charAt(i);
            nesting += c == '<' ? 1 : c == '>' ? -1 : 0;
            if (c == ',' && nesting == 0) {
                String value = text.substring(i + 1).strip();
                return parse(text.substring(0, i).strip(), depth)
                        .flatMap(k -> parse(value, depth).map(v -> new ValueType.MapOf(k, v)));
            }
        }
        return Optional.empty();
    }

    private static String inner(String text, int from) {
        return text.substring(from, text.length() - 1).strip();
    }
}
