package org.sami.dreamm.file;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.ZoneId;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.LibraryProject;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Project;

/** Offers the author what killed processes have left behind. On the event thread. */
final class Recovery {
    private static final DateTimeFormatter TIME = DateTimeFormatter.ofPattern("d MMM HH:mm:ss");

    private final DreammContext context;
    private final ProjectFile file;
    private final Autosave autosave;

    Recovery(DreammContext context, ProjectFile file, Autosave autosave) {
        this.context = Objects.requireNonNull(context, "context");
        this.file = Objects.requireNonNull(file, "file");
        this.autosave = Objects.requireNonNull(autosave, "autosave");
    }

    /** Asks about each piece of work; what the author leaves is offered again by the next window. */
    void offer(List<UnsavedWork> left, UnsavedChanges unsaved) {
        for (UnsavedWork work : left) {
            String of = work.file().map(path -> path.getFileName().toString()).orElse("a project without a file");
            context.questions()
                    .ask(new AuthorQuestion(
                            "unsaved-work-" + work.folder().getFileName(),
                            "Changes of " + of + ", not saved, were kept on "
                                    + TIME.format(work.time().atZone(ZoneId.systemDefault()))
                                    + " before DREAMM was ended.",
                            List.of(
                                    new AuthorQuestion.Choice(
                                            "restore-unsaved", "Restore", () -> unsaved.guard(() -> restore(work))),
                                    new AuthorQuestion.Choice("forget-unsaved", "Forget them", () -> forget(work))),
                            () -> {}));
        }
    }

    private void restore(UnsavedWork work) {
        Reading<Project> kept = new ProjectReader(context.vocabulary()).read(work.project());
        if (kept.result().isEmpty()) {
            context.notices()
                    .refused("the unsaved changes are not restored: " + work.project()
                            + " cannot be read with the words of this domain");
            return;
        }
        Project project = kept.result().get();
        String missing = openBase(work.file(), project);
        context.document().apply(new ReplaceProject("Restore unsaved changes", project));
        autosave.keep(Optional.of(work));
        context.notices().show("The unsaved changes are restored; Save keeps them" + missing);
    }

    /** Opens what the changes were made to, so that undo leads there; where that is gone, an empty project. */
    private String openBase(Optional<Path> path, Project project) {
        Optional<Path> there = path.filter(Files::exists);
        try {
            if (there.isPresent()) {
                file.open(file.read(there.get()));
                return "";
            }
        } catch (IOException unreadable) {
            file.open(empty(project));
            return "; " + unreadable.getMessage();
        }
        Project library = LibraryProject.of(context.domain());
        file.open(library.id().equals(project.id()) ? library : empty(project));
        return path.map(gone -> "; " + gone + " is no longer there").orElse("");
    }

    private static Project empty(Project project) {
        return new Project(project.id(), project.name(), project.domain(), List.of(), List.of(), List.of());
    }

    private void forget(UnsavedWork work) {
        try {
            RecoveryFolder.forget(work);
        } catch (IOException fault) {
            context.notices().refused("the unsaved changes stay in " + work.folder() + ": " + fault.getMessage());
        }
    }
}
