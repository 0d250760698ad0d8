package org.sami.spn.legacy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.json.ValueJson;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes markups of this language of the export's, by the table of classes. */
final class MarkupConverter {
    private static final Set<String> YES = Set.of("yes", "true");
    private static final Set<String> NO = Set.of("no", "false");
    private static final Set<String> NAMES_OF_THE_CLASS = Set.of("type", "class");

    private final Vocabulary vocabulary;
    private final LegacyTable table;
    private final LegacyValues values;
    private final Findings findings;
    private final Counts.Tally explained;

    MarkupConverter(
            Vocabulary vocabulary, LegacyTable table, LegacyValues values, Findings findings, Counts.Tally explained) {
        this.vocabulary = vocabulary;
        this.table = table;
        this.values = values;
        this.findings = findings;
        this.explained = explained;
    }

    List<MarkupSpec> convert(LegacyPlan.Event event) {
        List<MarkupSpec> specs = new ArrayList<>();
        for (LegacyPlan.Markup m : event.markups()) {
            Optional<LegacyTable.MarkupRule> rule = rule(m);
            Optional<MarkupSpec> spec = rule.map(r -> convert(event, m, r));
            if (spec.isEmpty()) {
                lose(event, m, "is not known here");
            } else if (!missing(spec.get()).isEmpty()) {
                lose(event, m, "does not say " + missing(spec.get()));
            } else {
                specs.add(spec.get());
            }
        }
        return specs;
    }

    private void lose(LegacyPlan.Event event, LegacyPlan.Markup m, String why) {
        explained.add(CountedKind.MARKUPS, 1);
        findings.warning(
                LegacyCodes.UNKNOWN_MARKUP,
                m.pointer(),
                "The markup " + m.className() + " of " + event.key() + " " + why + "; it is not imported",
                event.key());
    }

    /** Options that the markup must have and does not. */
    private List<String> missing(MarkupSpec spec) {
        return vocabulary.markup(spec.type()).orElseThrow().options().stream()
                .filter(o -> o.required() && spec.option(o.name()).isEmpty())
                .map(FieldType::name)
                .toList();
    }

    private Optional<LegacyTable.MarkupRule> rule(LegacyPlan.Markup m) {
        return LegacyTable.find(table.markups(), m.className())
                .or(() ->
                        vocabulary.markup(LegacyPlan.simpleName(m.className())).map(this::ruleOf));
    }

    /** The rule of a class that is called as the markup is here; classes of other years may spell fields as it does. */
    private LegacyTable.MarkupRule ruleOf(MarkupType type) {
        return table.markups().values().stream()
                .filter(rule -> rule.markup().equals(type.name()))
                .findFirst()
                .orElse(new LegacyTable.MarkupRule(type.name(), Map.of(), Map.of()));
    }

    private MarkupSpec convert(LegacyPlan.Event event, LegacyPlan.Markup m, LegacyTable.MarkupRule rule) {
        MarkupType type = vocabulary.markup(rule.markup()).orElseThrow();
        Map<String, Value> options = new LinkedHashMap<>();
        given(m).forEach((name, value) -> put(event, type, rule, name, value, options));
        rule.set()
                .forEach((name, json) -> type.options().stream()
                        .filter(o -> o.name().equals(name))
                        .findFirst()
                        .flatMap(o -> ValueJson.read(json, o.type(), vocabulary.types())
                                .result())
                        .ifPresent(v -> options.putIfAbsent(name, v)));
        return new MarkupSpec(type.name(), options);
    }

    /** Puts what a field says into the first option of its rules that takes it. */
    private void put(
            LegacyPlan.Event event,
            MarkupType type,
            LegacyTable.MarkupRule rule,
            String name,
            LegacyValue value,
            Map<String, Value> options) {
        List<LegacyTable.FieldRule> rules = rule.option(name, type);
        Optional<String> constant = LegacyValues.constant(value);
        for (LegacyTable.FieldRule optionRule : rules) {
            if (!optionRule.isFor(constant)) {
                continue;
            }
            if (optionRule.drops()) {
                return;
            }
            Optional<Value> converted = option(type, optionRule.to())
                    .flatMap(o -> values.convert(value, o.type(), optionRule).or(() -> word(value, o.type())));
            if (converted.isPresent()) {
                options.put(optionRule.to(), converted.get());
                return;
            }
        }
        findings.warning(
                LegacyCodes.UNKNOWN_OPTION,
                value.pointer(),
                "The option " + name + " of the markup " + type.name() + " of " + event.key() + " cannot be kept: "
                        + value.node(),
                event.key());
    }

    private static Optional<FieldType> option(MarkupType type, String name) {
        return type.options().stream().filter(o -> o.name().equals(name)).findFirst();
    }

    /** A constant or a yes, spelled otherwise than here. */
    private Optional<Value> word(LegacyValue value, ValueType type) {
        Optional<String> word = LegacyValues.constant(value).map(MarkupConverter::plain);
        if (type == ValueType.Simple.BOOLEAN) {
            return word.filter(w -> YES.contains(w) || NO.contains(w)).map(w -> new BooleanValue(YES.contains(w)));
        }
        if (type instanceof ValueType.Named named
                && vocabulary.types().get(named.name()) instanceof NamedType.Enumeration words) {
            return word.flatMap(w -> words.constants().stream()
                    .filter(c -> plain(c).equals(w))
                    .findFirst()
                    .map(c -> new EnumValue(named.name(), c)));
        }
        return Optional.empty();
    }

    private static String plain(String word) {
        return word.toLowerCase(Locale.ROOT).replaceAll("[ _-]", "");
    }

    /** Chosen constants by their name, and what parameters hold by {@code parameter.member}. */
    private static Map<String, LegacyValue> given(LegacyPlan.Markup m) {
        Map<String, LegacyValue> given = new LinkedHashMap<>(m.options());
        m.parameters().forEach((name, value) -> {
            if (!value.type().isEmpty() && !value.type().equals("option")) {
                given.put(name, value);
                return;
            }
            value.node().properties().forEach(member -> {
                if (!NAMES_OF_THE_CLASS.contains(member.getKey())
                        && !member.getValue().isNull()) {
                    given.put(name + "." + member.getKey(), value.member(member.getKey()));
                }
            });
        });
        return given;
    }
}
