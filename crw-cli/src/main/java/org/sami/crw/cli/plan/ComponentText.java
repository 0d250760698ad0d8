package org.sami.crw.cli.plan;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.spn.component.Candidate;
import org.sami.spn.component.Capabilities;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.ComponentType;
import org.sami.spn.component.Interaction;
import org.sami.spn.component.MarkupOption;
import org.sami.spn.component.Purpose;
import org.sami.spn.component.WidgetType;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.ValueType;

/** A choice of components in words: what was chosen, and how the others did. */
final class ComponentText {
    private static final String INDENT = "  ";

    private final ComponentChoice choice;

    ComponentText(ComponentChoice choice) {
        this.choice = choice;
    }

    /** What a component can do, in a paragraph. */
    static String of(ComponentType component) {
        return component.name()
                + "\n"
                + INDENT
                + component.help()
                + "\n"
                + of(component.can())
                + list("widgets", component.widgets(), WidgetType::name)
                + "\n";
    }

    /** What a widget adds, in a paragraph. */
    static String of(WidgetType widget) {
        return widget.name() + "  (widget)\n" + INDENT + widget.help() + "\n" + of(widget.can()) + "\n";
    }

    private static String of(Capabilities can) {
        return list("asks for", can.creates(), Object::toString)
                + list("shows", can.selects(), Object::toString)
                + list("acts on", can.markups(), Object::toString);
    }

    private static <T> String list(String what, List<T> items, Function<T, String> name) {
        return items.isEmpty()
                ? ""
                : INDENT + what + ": " + items.stream().map(name).collect(Collectors.joining(", ")) + "\n";
    }

    /** What is chosen for an interaction, part by part, and why. */
    String of(String title, Interaction interaction) {
        StringBuilder text = new StringBuilder(title)
                .append(interaction.purpose() == Purpose.CREATE ? ": the operator gives\n" : ": the operator sees\n");
        interaction
                .values()
                .forEach((name, type) -> text.append(INDENT)
                        .append(name)
                        .append("  ")
                        .append(TypeNames.of(type))
                        .append('\n'));
        text.append("markup: ").append(words(interaction.wanted())).append('\n');
        ChosenComponent chosen = choice.choose(interaction);
        text.append("chosen: score ")
                .append(chosen.score())
                .append(" of ")
                .append(interaction.wanted().size())
                .append('\n');
        append(text, "", chosen, 1);
        appendIgnored(text, interaction.wanted(), chosen);
        for (Map.Entry<String, ValueType> value : interaction.values().entrySet()) {
            appendCandidates(text, value.getKey(), value.getValue(), interaction);
        }
        return text.toString();
    }

    private static String words(List<MarkupOption> options) {
        return options.isEmpty()
                ? "none"
                : options.stream().map(MarkupOption::toString).collect(Collectors.joining(", "));
    }

    private static void append(StringBuilder text, String label, ChosenComponent chosen, int depth) {
        text.append(INDENT.repeat(depth)).append(label);
        if (chosen instanceof ChosenComponent.Direct direct) {
            text.append(name(direct));
            text.append(direct.actsOn().isEmpty() ? "\n" : "; acts on " + words(direct.actsOn()) + "\n");
        } else if (chosen instanceof ChosenComponent.Repeated repeated) {
            text.append("for each element\n");
            append(text, "", repeated.element(), depth + 1);
        } else if (chosen instanceof ChosenComponent.Entries entries) {
            text.append("for each entry\n");
            append(text, "key: ", entries.key(), depth + 1);
            append(text, "value: ", entries.value(), depth + 1);
        } else if (chosen instanceof ChosenComponent.Form form) {
            text.append("a form\n");
            form.fields().forEach((field, part) -> append(text, field + ": ", part, depth + 1));
        } else if (chosen instanceof ChosenComponent.Warning warning) {
            text.append("a warning: ").append(warning.reason()).append('\n');
        }
    }

    private static String name(ChosenComponent.Direct direct) {
        String widgets = direct.widgets().stream().map(WidgetType::name).collect(Collectors.joining(" and "));
        return direct.component().name() + (widgets.isEmpty() ? "" : " with " + widgets);
    }

    private static void appendIgnored(StringBuilder text, List<MarkupOption> wanted, ChosenComponent chosen) {
        if (chosen instanceof ChosenComponent.Direct direct) {
            List<MarkupOption> ignored = wanted.stream()
                    .filter(option -> !direct.actsOn().contains(option))
                    .toList();
            if (!ignored.isEmpty()) {
                text.append(INDENT)
                        .append("it does not act on ")
                        .append(words(ignored))
                        .append('\n');
            }
        }
    }

    private void appendCandidates(StringBuilder text, String name, ValueType type, Interaction interaction) {
        List<Candidate> candidates = choice.candidates(interaction.purpose(), type, interaction.wanted());
        text.append("considered for ").append(name).append(":\n");
        for (Candidate candidate : candidates) {
            candidate
                    .direct()
                    .ifPresent(direct -> text.append(INDENT)
                            .append(direct.score())
                            .append("  ")
                            .append(name(direct))
                            .append('\n'));
        }
        List<String> unable = candidates.stream()
                .filter(candidate -> candidate.direct().isEmpty())
                .map(candidate -> candidate.component().name())
                .toList();
        Optional.of(unable)
                .filter(names -> !names.isEmpty())
                .ifPresent(names -> text.append(INDENT)
                        .append("-1  unable: ")
                        .append(String.join(", ", names))
                        .append('\n'));
    }
}
