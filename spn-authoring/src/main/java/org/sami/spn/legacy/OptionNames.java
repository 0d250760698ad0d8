package org.sami.spn.legacy;

import java.util.Collection;
import java.util.Comparator;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/**
 * Finds options of markups by the names that classes of the earlier system gave their fields. One option was spelled in several
 * ways over the years: {@code showPlanName}, {@code showPlanNameEnum}, {@code showPlanNames}; and often with the subject before
 * it: {@code proxyStatus} for {@code status}, {@code sortMethodEnum} for {@code method}.
 */
final class OptionNames {
    private OptionNames() {}

    /** The entry of a table for a field: the one of exactly that name, else the one whose name differs in spelling only. */
    static <V> Optional<V> find(Map<String, V> table, String field) {
        if (table.containsKey(field)) {
            return Optional.of(table.get(field));
        }
        return table.entrySet().stream()
                .filter(e -> plain(e.getKey()).equals(plain(field)))
                .map(Map.Entry::getValue)
                .findFirst();
    }

    /** The option that a field means: the one of its name, else the longest whose name the field's ends with. */
    static Optional<String> meant(Collection<String> options, String field) {
        String name = plain(field);
        Optional<String> same =
                options.stream().filter(o -> plain(o).equals(name)).findFirst();
        return same.isPresent()
                ? same
                : options.stream().filter(o -> name.endsWith(plain(o))).max(Comparator.comparingInt(String::length));
    }

    /** A name without what its spelling adds: capital letters, the ending Enum, the plural. A parameter's member stays apart. */
    private static String plain(String name) {
        String plain = name.toLowerCase(Locale.ROOT).replace("_", "");
        if (plain.length() > 4 && plain.endsWith("enum")) {
            plain = plain.substring(0, plain.length() - 4);
        }
        if (plain.endsWith("ies")) {
            return plain.substring(0, plain.length() - 3) + "y";
        }
        boolean plural = plain.endsWith("s") && !plain.endsWith("ss") && !plain.endsWith("us");
        return plural ? plain.substring(0, plain.length() - 1) : plain;
    }
}
