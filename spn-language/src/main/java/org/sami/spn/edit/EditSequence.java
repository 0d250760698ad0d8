package org.sami.spn.edit;

import java.util.List;
import java.util.Objects;
import org.sami.spn.model.Project;

/** Several edits that are made, undone and redone as one; where one of them is refused, none is made. */
public record EditSequence(String label, List<Edit> edits) implements Edit {
    public EditSequence {
        Objects.requireNonNull(label, "label");
        edits = List.copyOf(edits);
    }

    @Override
    public Project change(Project project, EditContext context) throws EditRefusedException {
        Project changed = project;
        for (Edit edit : edits) {
            changed = context.settle(changed, edit.change(changed, context));
        }
        return changed;
    }
}
