package org.sami.dreamm.file;

import java.util.Objects;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditContext;
import org.sami.spn.model.Project;

/** Puts another version of the project into the place of the one that is there, so that it can be taken back. */
public record ReplaceProject(String label, Project next) implements Edit {
    public ReplaceProject {
        Objects.requireNonNull(label, "label");
        Objects.requireNonNull(next, "next");
    }

    @Override
    public Project change(Project project, EditContext context) {
        return next;
    }
}
