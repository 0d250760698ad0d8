package org.sami.spn.json;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.component.Capabilities;
import org.sami.spn.component.ComponentLibrary;
import org.sami.spn.component.ComponentType;
import org.sami.spn.component.MarkupOption;
import org.sami.spn.component.TypePattern;
import org.sami.spn.component.WidgetType;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Vocabulary;

/** Reads what components a domain's windows have, or says everything that is wrong with it (docs/components.md). */
public final class ComponentReader {
    /** The version of the format that is read and shipped. */
    public static final int FORMAT_VERSION = 1;

    private final Vocabulary vocabulary;
    private final Problems problems = new Problems();
    private final Map<String, WidgetType> widgets = new LinkedHashMap<>();

    private ComponentReader(Vocabulary vocabulary) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /** The components of a file's text, whose types and markups are those of the vocabulary. */
    public static Reading<ComponentLibrary> read(String text, Vocabulary vocabulary) {
        return new ComponentReader(vocabulary).read(text);
    }

    private Reading<ComponentLibrary> read(String text) {
        return JsonText.parse(text, problems)
                .flatMap(node -> JsonObjectReader.of(node, "", problems))
                .map(this::library)
                .map(library -> Reading.of(library, problems))
                .orElseGet(() -> Reading.nothing(problems));
    }

    private ComponentLibrary library(JsonObjectReader root) {
        int version = root.integer("formatVersion", 0);
        if (version != FORMAT_VERSION) {
            root.problem(
                    Codes.VERSION,
                    "formatVersion",
                    "This program reads components of version " + FORMAT_VERSION + ", not " + version);
        }
        root.text(ProjectReader.SCHEMA, "");
        Names widgetNames = new Names(problems);
        for (JsonObjectReader m : root.objects("widgets")) {
            String name = name(m, widgetNames);
            widgets.put(name, new WidgetType(name, m.text("help"), capabilities(m)));
            m.done();
        }
        Names componentNames = new Names(problems);
        List<ComponentType> components = new ArrayList<>();
        for (JsonObjectReader m : root.objects("components")) {
            String name = name(m, componentNames);
            components.add(new ComponentType(name, m.text("help"), capabilities(m), widgetsOf(m)));
            m.done();
        }
        root.done();
        return new ComponentLibrary(components, List.copyOf(widgets.values()));
    }

    private static String name(JsonObjectReader m, Names taken) {
        String name = m.text("name");
        taken.take(name, m.pointer());
        return name;
    }

    private Capabilities capabilities(JsonObjectReader m) {
        return new Capabilities(types(m, "creates"), types(m, "selects"), markups(m));
    }

    private List<WidgetType> widgetsOf(JsonObjectReader m) {
        List<WidgetType> found = new ArrayList<>();
        for (String name : m.texts("widgets")) {
            if (widgets.containsKey(name)) {
                found.add(widgets.get(name));
            } else {
                m.problem(
                        Codes.UNKNOWN_WORD,
                        "widgets",
                        "There is no widget " + name + NearMatches.meant(widgets.keySet(), name));
            }
        }
        if (found.size() > ComponentType.MOST_WIDGETS) {
            m.problem(
                    Codes.BAD_VALUE,
                    "widgets",
                    "A component has at most " + ComponentType.MOST_WIDGETS + " widgets, not " + found.size());
            return List.of();
        }
        return found;
    }

    private List<TypePattern> types(JsonObjectReader m, String member) {
        List<TypePattern> patterns = new ArrayList<>();
        for (JsonObjectReader.Element element : m.array(member)) {
            String text = element.node().asText();
            Optional<TypePattern> pattern = TypePattern.parse(text);
            if (pattern.isEmpty() || !element.node().isTextual()) {
                problems.add(Codes.UNKNOWN_TYPE, element.pointer(), "\"" + text + "\" is no type");
            } else if (isDeclared(pattern.get().shape(), element.pointer())) {
                patterns.add(pattern.get());
            }
        }
        return patterns;
    }

    private boolean isDeclared(ValueType shape, String where) {
        Map<String, NamedType> known = new LinkedHashMap<>(vocabulary.types());
        known.put(
                TypePattern.ANY_ENUMERATION,
                new NamedType.Enumeration(TypePattern.ANY_ENUMERATION, List.of(TypePattern.ANY_ENUMERATION)));
        return NamedTypeReader.check(shape, known, where, problems);
    }

    private List<MarkupOption> markups(JsonObjectReader m) {
        List<MarkupOption> options = new ArrayList<>();
        for (JsonObjectReader.Element element : m.array("markups")) {
            String text = element.node().asText();
            Optional<MarkupOption> option = MarkupOption.parse(text);
            if (option.isEmpty() || !element.node().isTextual()) {
                problems.add(
                        Codes.BAD_VALUE,
                        element.pointer(),
                        "A markup is written as Sort, Sort.method or Sort.method=ALPHABETICAL, not as \"" + text
                                + "\"");
            } else {
                option.get()
                        .unknownIn(vocabulary)
                        .ifPresentOrElse(
                                words -> problems.add(Codes.UNKNOWN_WORD, element.pointer(), words),
                                () -> options.add(option.get()));
            }
        }
        return options;
    }
}
