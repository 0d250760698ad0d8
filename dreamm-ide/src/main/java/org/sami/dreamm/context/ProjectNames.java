package org.sami.dreamm.context;

import java.util.List;
import java.util.Objects;
import java.util.stream.Stream;
import org.sami.dreamm.document.EditorState;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.spn.model.Plan;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.VariableReference;
import org.sami.ui.value.ChoiceRow;
import org.sami.ui.value.NamedThings;

/** Plans of the project and variables of the open plan, as editors of values offer them. Robots are known only when a plan runs. */
final class ProjectNames implements NamedThings {
    private final ProjectDocument document;
    private final EditorState editor;

    ProjectNames(ProjectDocument document, EditorState editor) {
        this.document = Objects.requireNonNull(document, "document");
        this.editor = Objects.requireNonNull(editor, "editor");
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
