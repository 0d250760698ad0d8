package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.node.TextNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.json.ValueJson;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes markups of this language of the export's, by the table of classes. */
final class MarkupConverter {
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
                .or(() -> vocabulary
                        .markup(LegacyPlan.simpleName(m.className()))
                        .map(t -> new LegacyTable.MarkupRule(t.name(), Map.of(), Map.of())));
    }

    private MarkupSpec convert(LegacyPlan.Event event, LegacyPlan.Markup m, LegacyTable.MarkupRule rule) {
        MarkupType type = vocabulary.markup(rule.markup()).orElseThrow();
        Map<String, Value> options = new LinkedHashMap<>();
        given(m).forEach((name, value) -> {
            LegacyTable.FieldRule optionRule = rule.option(name);
            Optional<FieldType> option = type.options().stream()
                    .filter(o -> o.name().equals(optionRule.to()))
                    .findFirst();
            Optional<Value> converted = option.flatMap(o -> values.convert(value, o.type(), optionRule));
            converted.ifPresent(v -> options.put(optionRule.to(), v));
            if (converted.isEmpty() && optionRule.reason().isEmpty()) {
                findings.warning(
                        LegacyCodes.UNKNOWN_OPTION,
                        value.pointer(),
                        "The option " + name + " of the markup " + type.name() + " of " + event.key()
                                + " cannot be kept: " + value.node(),
                        event.key());
            }
        });
        rule.set()
                .forEach((name, json) -> type.options().stream()
                        .filter(o -> o.name().equals(name))
                        .findFirst()
                        .flatMap(o -> ValueJson.read(json, o.type(), vocabulary.types())
                                .result())
                        .ifPresent(v -> options.putIfAbsent(name, v)));
        return new MarkupSpec(type.name(), options);
    }

    /** Chosen constants by their name, and what parameters hold by {@code parameter.member}. */
    private static Map<String, LegacyValue> given(LegacyPlan.Markup m) {
        Map<String, LegacyValue> given = new LinkedHashMap<>();
        m.options()
                .forEach((name, constant) -> given.put(
                        name,
                        new LegacyValue(
                                Findings.at(Findings.at(m.pointer(), "options"), name), TextNode.valueOf(constant))));
        m.parameters()
                .forEach((name, value) -> value.node().properties().forEach(member -> {
                    if (!member.getKey().equals("type")
                            && !member.getKey().equals("class")
                            && !member.getValue().isNull()) {
                        given.put(name + "." + member.getKey(), value.member(member.getKey()));
                    }
                }));
        return given;
    }
}
