package org.sami.spn.component;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * One choice that a markup makes, such as {@code Sort.method=ALPHABETICAL}; an element of the thesis's list MO (5.2.4).
 *
 * @param markup the markup's name
 * @param option its option; empty text = the markup as a whole
 * @param value the constant of an enumeration, or true or false; empty text = whatever the value is
 */
public record MarkupOption(String markup, String option, String value) {
    private static final Pattern TEXT = Pattern.compile("(\\w+)(?:\\.(\\w+)(?:=(\\w+))?)?");

    public MarkupOption {
        Objects.requireNonNull(markup, "markup");
        Objects.requireNonNull(option, "option");
        Objects.requireNonNull(value, "value");
        if (option.isEmpty() && !value.isEmpty()) {
            throw new IllegalArgumentException("The value " + value + " of markup " + markup + " has no option");
        }
    }

    /** The choice of a text such as {@code Sort}, {@code Sort.method} or {@code Sort.method=ALPHABETICAL}; empty where it is none. */
    public static Optional<MarkupOption> parse(String text) {
        Matcher parts = TEXT.matcher(text);
        return parts.matches()
                ? Optional.of(new MarkupOption(parts.group(1), orEmpty(parts.group(2)), orEmpty(parts.group(3))))
                : Optional.empty();
    }

    private static String orEmpty(String group) {
        return group == null ? "" : group;
    }

    /**
     * What markups on an event choose, each once, in their order. Only what is written there counts, no default: a plan that says
     * nothing asks no component for anything.
     */
    public static List<MarkupOption> of(List<MarkupSpec> markups, Vocabulary vocabulary) {
        List<MarkupOption> all = new ArrayList<>();
        for (MarkupSpec spec : markups) {
            String name = vocabulary.markup(spec.type()).map(MarkupType::name).orElse(spec.type());
            if (spec.options().isEmpty()) {
                all.add(new MarkupOption(name, "", ""));
            }
            spec.options().forEach((option, value) -> all.add(new MarkupOption(name, option, constant(value))));
        }
        return all.stream().distinct().toList();
    }

    private static String constant(Value value) {
        if (value instanceof EnumValue constant) {
            return constant.constant();
        }
        return value instanceof BooleanValue flag ? String.valueOf(flag.value()) : "";
    }

    /** Says in a sentence what of this a vocabulary does not have, and what may have been meant; empty where it has all. */
    public Optional<String> unknownIn(Vocabulary vocabulary) {
        MarkupType type = vocabulary.markups().get(markup);
        if (type == null) {
            return Optional.of("There is no markup " + markup
                    + Suggestions.meant(vocabulary.markups().keySet(), markup));
        }
        if (option.isEmpty()) {
            return Optional.empty();
        }
        Optional<FieldType> field =
                type.options().stream().filter(one -> one.name().equals(option)).findFirst();
        if (field.isEmpty()) {
            List<String> names = type.options().stream().map(FieldType::name).toList();
            return Optional.of("The markup " + markup + " has no option " + option + ", it has "
                    + String.join(", ", names) + Suggestions.meant(names, option));
        }
        List<String> constants = constants(field.get().type(), vocabulary);
        return value.isEmpty() || constants.contains(value)
                ? Optional.empty()
                : Optional.of("The option " + option + " of markup " + markup + " is never " + value
                        + (constants.isEmpty() ? "" : ", it is " + String.join(" or ", constants))
                        + Suggestions.meant(constants, value));
    }

    private static List<String> constants(ValueType type, Vocabulary vocabulary) {
        if (type == ValueType.Simple.BOOLEAN) {
            return List.of("true", "false");
        }
        return type instanceof ValueType.Named named
                        && vocabulary.types().get(named.name()) instanceof NamedType.Enumeration enumeration
                ? enumeration.constants()
                : List.of();
    }

    /** Whether who acts on this one acts on the other one too. */
    public boolean covers(MarkupOption wanted) {
        return markup.equals(wanted.markup)
                && (option.isEmpty()
                        || (option.equals(wanted.option) && (value.isEmpty() || value.equals(wanted.value))));
    }

    @Override
    public String toString() {
        return markup + (option.isEmpty() ? "" : "." + option) + (value.isEmpty() ? "" : "=" + value);
    }
}
