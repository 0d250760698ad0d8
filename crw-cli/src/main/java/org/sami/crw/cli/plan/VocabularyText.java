package org.sami.crw.cli.plan;

import java.util.List;
import java.util.stream.Collectors;
import org.sami.crw.cli.output.UsageFault;
import org.sami.spn.json.VocabularyWriter;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** Events and markups as paragraphs for a terminal. */
final class VocabularyText {
    private static final int WIDTH = 96;
    private static final String INDENT = "    ";

    private final Vocabulary vocabulary;
    private final VocabularyWriter writer;

    VocabularyText(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
        writer = new VocabularyWriter(vocabulary);
    }

    /** Name and side of an event, what it does, its other names, the tokens that it needs, its fields, what answers it. */
    String of(EventType event) {
        boolean output = event.direction() == Direction.OUTPUT;
        StringBuilder text = new StringBuilder(event.name());
        text.append(output ? "  (output, on places)\n" : "  (input, on transitions)\n");
        text.append(wrapped(event.help()));
        appendNames(text, "also", event.aliases());
        if (event.tokens() != TokenNeed.NONE) {
            text.append(wrapped((output ? "needs: " : "names: ") + word(event.tokens())));
        }
        event.fields().forEach(field -> text.append(field(field)));
        appendNames(text, "answers", event.answers());
        if (!output) {
            appendNames(text, "answer to", writer.causes(event));
        }
        return text.append('\n').toString();
    }

    /** Name of a markup, what it does, its other names and its options. */
    String of(MarkupType markup) {
        StringBuilder text = new StringBuilder(markup.name()).append('\n');
        text.append(wrapped(markup.help()));
        appendNames(text, "also", markup.aliases());
        markup.options().forEach(option -> text.append(field(option)));
        return text.append('\n').toString();
    }

    private static void appendNames(StringBuilder text, String what, List<String> names) {
        if (!names.isEmpty()) {
            text.append(wrapped(what + ": " + String.join(", ", names)));
        }
    }

    private String field(FieldType field) {
        String type = field.type() instanceof ValueType.Named named
                        && vocabulary.types().get(named.name()) instanceof NamedType.Enumeration words
                ? String.join(" or ", words.constants())
                : TypeNames.of(field.type());
        String unit = field.unit().isEmpty() ? "" : " in " + field.unit();
        String optional = field.required() ? "" : ", optional";
        return wrapped(field.name() + " (" + type + unit + optional + "): " + field.help());
    }

    private static String word(TokenNeed need) {
        return switch (need) {
            case NONE -> "nobody";
            case PROXY -> "boats";
            case TASK -> "tasks";
            case PROXY_OR_TASK -> "boats or tasks";
        };
    }

    private static String wrapped(String paragraph) {
        StringBuilder lines = new StringBuilder();
        int column = 0;
        for (String word : paragraph.split(" ", -1)) {
            boolean newLine = column == 0 || column + 1 + word.length() > WIDTH;
            lines.append(column == 0 ? "" : newLine ? "\n" : " ");
            if (newLine) {
                String margin = column == 0 ? INDENT : INDENT + "  ";
                lines.append(margin);
                column = margin.length();
            } else {
                column++;
            }
            lines.append(word);
            column += word.length();
        }
        return lines.append('\n').toString();
    }

    /** The fault where nothing fits. */
    static UsageFault nothing(String kind, String wanted, List<String> alike) {
        String meant = alike.isEmpty() ? "" : "; alike are " + alike.stream().collect(Collectors.joining(", "));
        return new UsageFault("no " + kind + " has '" + wanted + "' in its name" + meant);
    }
}
