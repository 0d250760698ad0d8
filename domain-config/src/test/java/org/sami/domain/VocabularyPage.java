package org.sami.domain;

import java.util.List;
import java.util.Locale;
import org.sami.spn.json.VocabularyWriter;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldLimits;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** The reference page of a vocabulary, in Markdown. */
final class VocabularyPage {
    private static final String HEAD = """
            # What a plan of the boats may say

            Made from [the vocabulary](../domain-config/src/main/resources/org/sami/domain/crw/events.json) by
            `./gradlew :domain-config:test -PcanonicalWrite`; do not edit it here. `crw events` and `crw markups` print the same. The names are
            those of appendix .2 of the thesis; a plan file may also use the other names, which earlier plans and the thesis's chapters have.
            """;

    private final Vocabulary vocabulary;
    private final VocabularyWriter writer;
    private final StringBuilder page = new StringBuilder(HEAD);

    private VocabularyPage(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
        writer = new VocabularyWriter(vocabulary);
    }

    static String of(Vocabulary vocabulary) {
        return new VocabularyPage(vocabulary).write();
    }

    private String write() {
        section("Output events", "On places: what a plan asks of boats, of services and of its operator.");
        events(Direction.OUTPUT);
        section("Input events", "On transitions: answers and news.");
        events(Direction.INPUT);
        section("Markups", "On events: hints for people and services.");
        vocabulary.markups().values().forEach(this::markup);
        section("Classes of tasks", "");
        vocabulary.taskClasses().values().forEach(task -> {
            heading(task.name(), List.of());
            line(task.help());
            task.fields().forEach(this::field);
        });
        section(
                "Types",
                "Those that the vocabulary declares; the others stand in [the file format](file-format.md#values).");
        vocabulary.types().values().forEach(this::type);
        return page.toString();
    }

    private void section(String title, String text) {
        page.append("\n## ").append(title).append('\n');
        if (!text.isEmpty()) {
            line(text);
        }
    }

    private void heading(String name, List<String> aliases) {
        page.append("\n### ").append(name).append('\n');
        if (!aliases.isEmpty()) {
            line("Also `" + String.join("`, `", aliases) + "`.");
        }
    }

    private void line(String text) {
        page.append(text).append('\n');
    }

    private void item(String text) {
        page.append("- ").append(text).append('\n');
    }

    private void events(Direction direction) {
        vocabulary.events().values().stream()
                .filter(event -> event.direction() == direction)
                .forEach(this::event);
    }

    private void event(EventType event) {
        boolean output = event.direction() == Direction.OUTPUT;
        heading(event.name(), event.aliases());
        line(event.help());
        if (event.tokens() != TokenNeed.NONE) {
            String need = event.tokens().name().toLowerCase(Locale.ROOT).replace('_', ' ');
            item((output ? "needs tokens: " : "names: ") + need);
        }
        event.fields().forEach(this::field);
        if (event.flags().contains(EventFlag.FAILURE)) {
            item("a failure: a plan that may get it as an answer draws what is to be done then");
        }
        links("answered by", event.answers());
        if (!output) {
            links("answers", writer.causes(event));
        }
    }

    private void links(String what, List<String> names) {
        if (!names.isEmpty()) {
            item(what + " "
                    + String.join(
                            ", ",
                            names.stream()
                                    .map(name -> "[" + name + "](#" + name.toLowerCase(Locale.ROOT) + ")")
                                    .toList()));
        }
    }

    private void markup(MarkupType markup) {
        heading(markup.name(), markup.aliases());
        line(markup.help());
        markup.options().forEach(this::field);
    }

    private void field(FieldType field) {
        String type = field.type() instanceof ValueType.Named named
                        && vocabulary.types().get(named.name()) instanceof NamedType.Enumeration words
                ? "`" + String.join("` or `", words.constants()) + "`"
                : "`" + TypeNames.of(field.type()) + "`";
        String unit = field.unit().isEmpty() ? "" : " in " + field.unit();
        String optional = field.required() ? "" : ", optional";
        item("`" + field.name() + "`: " + type + unit + limits(field) + optional + ". " + field.help());
    }

    private static String limits(FieldType field) {
        FieldLimits limits = field.limits();
        StringBuilder words = new StringBuilder();
        String seconds = field.type() == ValueType.Simple.DURATION ? " s" : "";
        if (!limits.range().equals(FieldLimits.Range.ALL)) {
            words.append(", from ").append(ends(limits.range())).append(seconds);
        }
        if (!limits.usual().equals(FieldLimits.Range.ALL)) {
            words.append(", usually ").append(ends(limits.usual())).append(seconds);
        }
        limits.above()
                .ifPresent(other -> words.append(", above `").append(other).append('`'));
        if (!limits.words().isEmpty()) {
            words.append(", one of ").append(String.join(", ", limits.words()));
        }
        return words.toString();
    }

    private static String ends(FieldLimits.Range range) {
        return number(range.least()) + " to " + number(range.most());
    }

    private static String number(double number) {
        return number == Math.rint(number) ? String.format(Locale.ROOT, "%.0f", number) : Double.toString(number);
    }

    private void type(NamedType type) {
        if (type instanceof NamedType.RecordType record) {
            heading(record.name(), List.of());
            record.fields().forEach((name, of) -> item("`" + name + "`: `" + TypeNames.of(of) + "`"));
        }
    }
}
