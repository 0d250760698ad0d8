package org.sami.dreamm.context;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.model.Plan;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;
import org.sami.ui.value.ChoiceRow;
import org.sami.ui.value.NamedThings;

/**
 * Plans of the project, variables of the open plan and names of robots, as editors of values offer them. Robots are met only when a plan runs:
 * the project says names of some, and any other can be typed.
 */
final class ProjectNames implements NamedThings {
    private final ProjectDocument document;
    private final EditorState editor;

    ProjectNames(ProjectDocument document, EditorState editor) {
        this.document = Objects.requireNonNull(document, "document");
        this.editor = Objects.requireNonNull(editor, "editor");
    }

    @Override
    public boolean takesOtherRobots() {
        return true;
    }

    /** Those of the deployment, which are records with a name in the project's variables, and those that values and test cases name. */
    @Override
    public List<ChoiceRow> proxies() {
        Set<String> names = new LinkedHashSet<>();
        document.project().globals().forEach(v -> v.initial().ifPresent(value -> deployed(value, names)));
        ProjectValues.of(document.project()).forEach(value -> named(value, names));
        document.project().plans().forEach(p -> p.testCases().forEach(test -> names.addAll(test.proxies())));
        return names.stream()
                .map(name -> new ChoiceRow(new ProxyValue(name), name, ""))
                .toList();
    }

    private static void deployed(Value value, Set<String> names) {
        if (value instanceof ListValue list) {
            list.items().forEach(item -> deployed(item, names));
        } else if (value instanceof RecordValue robot && robot.fields().get("name") instanceof TextValue name) {
            names.add(name.value());
        }
    }

    private static void named(Value value, Set<String> names) {
        if (value instanceof ProxyValue proxy) {
            names.add(proxy.proxy());
        } else if (value instanceof ListValue list) {
            list.items().forEach(item -> named(item, names));
        } else if (value instanceof RecordValue fields) {
            fields.fields().values().forEach(part -> named(part, names));
        } else if (value instanceof MapValue map) {
            map.entries().forEach((key, one) -> {
                named(key, names);
                named(one, names);
            });
        }
    }

    @Override
    public List<ChoiceRow> plans() {
        return document.project().plans().stream()
                .map(plan -> new ChoiceRow(
                        new PlanReference(plan.id()), plan.name().isEmpty() ? plan.id() : plan.name(), ""))
                .toList();
    }

    @Override
    public List<ChoiceRow> variables() {
        Stream<VariableSpec> own = editor.plan().map(Plan::variables).stream().flatMap(List::stream);
        return Stream.concat(own, document.project().globals().stream())
                .map(v -> new ChoiceRow(new VariableReference(v.name()), v.name(), TypeNames.of(v.type())))
                .toList();
    }
}
