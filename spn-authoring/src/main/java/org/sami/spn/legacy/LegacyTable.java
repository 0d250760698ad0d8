package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;

/**
 * What the classes of the earlier system are called in a domain: its events, markups, types and tasks. A file of the domain
 * (docs/import-legacy.md), read by {@link LegacyTableReader}.
 *
 * @param events by the full name of their class
 * @param markups by the full name of their class
 * @param types of values, by the full name of their class
 * @param records which member of a value's class fills which field of a record, by the simple name of the class
 * @param taskClasses by the full name of their class
 * @param unknown what keeps events that are in no table
 */
public record LegacyTable(
        Map<String, EventRule> events,
        Map<String, MarkupRule> markups,
        Map<String, ValueType> types,
        Map<String, Map<String, String>> records,
        Map<String, String> taskClasses,
        Unknown unknown) {

    /**
     * An event of this language for an event class.
     *
     * @param fields by the name that the class gives them; those not named keep their name
     * @param set fields that the class lacks, as JSON of plan files
     */
    public record EventRule(String event, Map<String, FieldRule> fields, Map<String, JsonNode> set) {
        FieldRule field(String name) {
            return fields.getOrDefault(name, FieldRule.same(name));
        }
    }

    /**
     * A markup of this language for a markup class.
     *
     * @param options by the name that the class gives them; parameters are named {@code parameter.member}. The first rule of
     *     a name whose option takes the value is used: a field had other constants in other years
     * @param set options where the class leaves them open, as JSON of plan files
     */
    public record MarkupRule(String markup, Map<String, List<FieldRule>> options, Map<String, JsonNode> set) {
        /** The rules for a field: those of the table, else one for the option that its name means. */
        List<FieldRule> option(String name, MarkupType type) {
            return OptionNames.find(options, name)
                    .orElseGet(() -> List.of(FieldRule.same(OptionNames.meant(
                                    type.options().stream().map(FieldType::name).toList(), name)
                            .orElse(name))));
        }
    }

    /**
     * What becomes of a field.
     *
     * @param to the field here; empty text where there is none
     * @param unitMillis of durations: how many milliseconds one is
     * @param values other names of constants, as JSON of plan files, by the constant
     * @param waitForAll whether the field says that the transition waits for all, instead of being one
     * @param reason why there is no such field here; empty text where there is one
     * @param only the constants that the rule is for; empty where it is for all
     */
    public record FieldRule(
            String to,
            double unitMillis,
            Map<String, JsonNode> values,
            boolean waitForAll,
            String reason,
            Set<String> only) {
        static FieldRule same(String name) {
            return new FieldRule(name, 1, Map.of(), false, "", Set.of());
        }

        boolean isFor(Optional<String> constant) {
            return only.isEmpty() || constant.filter(only::contains).isPresent();
        }

        boolean drops() {
            return !reason.isEmpty();
        }
    }

    /**
     * Events that keep what no event of this language says.
     *
     * @param output the output event; empty text where unknown ones cannot be kept
     * @param input the input event
     * @param classField field for the name of the class
     * @param contentField field for the whole event, as JSON text
     */
    public record Unknown(String output, String input, String classField, String contentField) {}

    /** The rule of a class, by its full name, else by its name without the package. */
    static <R> Optional<R> find(Map<String, R> rules, String className) {
        R exact = rules.get(className);
        if (exact != null) {
            return Optional.of(exact);
        }
        String simple = LegacyPlan.simpleName(className);
        return rules.entrySet().stream()
                .filter(e -> LegacyPlan.simpleName(e.getKey()).equals(simple))
                .map(Map.Entry::getValue)
                .findFirst();
    }

    /** A table that knows no class: everything is found by its name. */
    public static LegacyTable empty() {
        return new LegacyTable(
                new LinkedHashMap<>(),
                new LinkedHashMap<>(),
                new LinkedHashMap<>(),
                new LinkedHashMap<>(),
                new LinkedHashMap<>(),
                new Unknown("", "", "", ""));
    }
}
