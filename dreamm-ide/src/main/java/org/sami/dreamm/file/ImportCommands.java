package org.sami.dreamm.file;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.finding.Finding;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.legacy.LegacyTable;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;

/** Brings in what other programs have written. On the event thread. */
final class ImportCommands {
    private final DreammContext context;
    private final ProjectFile file;
    private final FileDialogs dialogs;
    private final UnsavedChanges unsaved;

    ImportCommands(DreammContext context, ProjectFile file, FileDialogs dialogs, UnsavedChanges unsaved) {
        this.context = Objects.requireNonNull(context, "context");
        this.file = Objects.requireNonNull(file, "file");
        this.dialogs = Objects.requireNonNull(dialogs, "dialogs");
        this.unsaved = Objects.requireNonNull(unsaved, "unsaved");
    }

    void register() {
        GeometryImport geometry = new GeometryImport(context);
        context.commands()
                .add(new Command(
                                "import-geometry",
                                "Import locations, paths or areas as a variable…",
                                () -> dialogs.open("Import a text file of positions", "Text files", "txt")
                                        .ifPresent(geometry::read))
                        .withKey("alt shift G"));
        context.commands()
                .add(new Command(
                                "import-legacy",
                                "Import a project of the earlier system…",
                                () -> unsaved.guard(() -> dialogs.open(
                                                "Import an export of the earlier system", "Exported projects", "json")
                                        .ifPresent(this::readLegacy)))
                        .withKey("alt shift O")
                        .unless(() -> context.source().hasLegacyTable()
                                ? Optional.empty()
                                : Optional.of("this domain has no legacy.json, which says what the classes meant")));
    }

    private void readLegacy(Path export) {
        Project before = context.document().project();
        context.background()
                .run(
                        "Importing " + export.getFileName(),
                        () -> new LegacyImport(context.vocabulary(), table()).read(export),
                        result -> unsaved.guardSince(before, () -> imported(export, result)));
    }

    private LegacyTable table() {
        try {
            return context.source().legacyTable(context.vocabulary()).orThrow();
        } catch (IOException unreadable) {
            throw new UncheckedIOException("the domain's legacy.json cannot be read", unreadable);
        }
    }

    private void imported(Path export, LegacyImport.Result result) {
        if (result.project().isEmpty()) {
            context.notices()
                    .refused(export.getFileName() + " is not imported: "
                            + result.findings().stream()
                                    .filter(Finding::isError)
                                    .findFirst()
                                    .map(Finding::message)
                                    .orElse("it cannot be read"));
            return;
        }
        file.open(result.project().get());
        int losses = result.losses().size();
        context.notices()
                .show(export.getFileName() + ": "
                        + result.project().get().plans().size() + " plans are imported"
                        + (losses == 0
                                ? ", nothing was lost"
                                : "; " + losses + " things say less here, crw import-legacy --all lists them")
                        + ". Save keeps them");
    }
}
