package org.sami.dreamm.file;

import java.awt.Component;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.LibraryProject;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;

/** New, open, save, and what is asked before something would be lost. On the event thread. */
public final class FileCommands implements AutoCloseable {
    private final DreammContext context;
    private final ProjectFile file;
    private final RecentProjects recent;
    private final FileDialogs dialogs;
    private final Autosave autosave;
    private final DiskWatch watch;
    private final UnsavedChanges unsaved;

    /**
     * The commands of a window, which are added to its registry.
     *
     * @param recovery where unsaved changes are kept for the case that the process is killed
     */
    public FileCommands(DreammContext context, Component owner, RecentProjects recent, RecoveryFolder recovery) {
        this.context = Objects.requireNonNull(context, "context");
        this.recent = Objects.requireNonNull(recent, "recent");
        file = new ProjectFile(context.document());
        dialogs = new FileDialogs(owner, Path.of("").toAbsolutePath());
        autosave = new Autosave(context.document(), recovery, context.notices()::refused);
        watch = new DiskWatch(context, file);
        unsaved = new UnsavedChanges(context, this::save);
        context.document().file().ifPresent(recent::add);
        add(new Command("project-new", "New project", () -> unsaved.guard(this::begin)).withKey("ctrl N"));
        add(new Command("project-open", "Open a project…", () -> unsaved.guard(this::choose))
                .withKey("ctrl O")
                .withIcon("folder"));
        add(new Command("library-open", "Open the library of plans", () -> unsaved.guard(this::openLibrary))
                .withKey("ctrl shift O"));
        add(new Command("project-save", "Save", () -> save(() -> {}))
                .withKey("ctrl S")
                .withIcon("file"));
        add(new Command("project-save-as", "Save as a file…", () -> saveAs(() -> {})).withKey("ctrl shift S"));
        add(new Command("project-save-folder", "Save as a folder, one file for each plan…", this::saveAsFolder)
                .withKey("alt shift S"));
        new ImportCommands(context, file, dialogs, unsaved).register();
    }

    private void add(Command command) {
        context.commands().add(command);
    }

    /** Offers what killed processes have left behind. */
    public void offer(List<UnsavedWork> left) {
        new Recovery(context, file, autosave).offer(left, unsaved);
    }

    /** Does something that would lose unsaved changes, once the author has saved or given up what there is. */
    public void guard(Runnable next) {
        unsaved.guard(next);
    }

    /** Opens a project instead of the one that is open, once nothing of that is lost. */
    public void open(Path path) {
        unsaved.guard(() -> read(path));
    }

    /**
     * Opens a project as the one of a file, which is written; for files that the program keeps by itself.
     *
     * @param path need not be there yet
     */
    public void openIn(Path path, Project project) {
        try {
            Files.createDirectories(path.toAbsolutePath().getParent());
            new ProjectWriter(context.vocabulary()).write(project, path);
            file.open(file.read(path));
        } catch (IOException | UncheckedIOException fault) {
            context.notices().refused(path + " cannot be kept: " + SaveFault.words(path, fault));
            file.open(project);
        }
    }

    /** Writes the project into its file without a word, where it has one and is not in it yet. */
    public void keep() {
        Optional<Path> path =
                context.document().file().filter(each -> context.document().isModified());
        path.ifPresent(each -> {
            try {
                file.save(each);
            } catch (IOException | UncheckedIOException fault) {
                context.notices().refused(each + " is not kept: " + SaveFault.words(each, fault));
            }
        });
    }

    /** The projects that were opened last. */
    public List<Path> recent() {
        return recent.all();
    }

    private void begin() {
        String domain = context.vocabulary().domain();
        Project project = new Project(
                "project", "New project", domain, List.of(), List.of(), List.of(new PlanBuilder("plan").build()));
        file.open(project);
        context.notices().show("A new project; F2 in the mission tree renames its plan");
    }

    private void openLibrary() {
        file.open(LibraryProject.of(context.domain()));
        context.notices().show("The library's plans; what you change is saved as a project of your own");
    }

    private void choose() {
        dialogs.open("Open a project: a file, or a folder with a project.json", "Project files", "json")
                .ifPresent(this::read);
    }

    private void read(Path path) {
        Project before = context.document().project();
        context.background()
                .run(
                        "Opening " + path.getFileName(),
                        () -> {
                            try {
                                return Outcome.of(file.read(path));
                            } catch (IOException unfit) {
                                return Outcome.refused(String.valueOf(unfit.getMessage()));
                            }
                        },
                        outcome -> outcome.show(context, read -> unsaved.guardSince(before, () -> opened(read))));
    }

    private void opened(ProjectFile.Read read) {
        file.open(read);
        recent.add(read.path());
        context.notices().show(read.path() + " is open");
    }

    private record Outcome(Optional<ProjectFile.Read> read, String why) {
        static Outcome of(ProjectFile.Read read) {
            return new Outcome(Optional.of(read), "");
        }

        static Outcome refused(String why) {
            return new Outcome(Optional.empty(), why);
        }

        void show(DreammContext context, java.util.function.Consumer<ProjectFile.Read> opened) {
            read.ifPresentOrElse(opened, () -> context.notices().refused(why));
        }
    }

    private void save(Runnable then) {
        context.document().giveBack();
        context.typed().give();
        Optional<Path> path = context.document().file();
        if (path.isEmpty()) {
            saveAs(then);
            return;
        }
        try {
            Optional<DiskVersion> other = file.changedOnDisk();
            if (other.filter(DiskVersion::isThere).isPresent()) {
                askToWriteOver(path.get(), then);
            } else if (other.isEmpty() && !context.document().isModified()) {
                context.notices().show("Everything is saved in " + path.get());
                then.run();
            } else {
                write(path.get(), then);
            }
        } catch (IOException unreadable) {
            context.notices()
                    .refused(path.get() + " is not saved, as it cannot be read: "
                            + SaveFault.words(path.get(), unreadable));
        }
    }

    private void askToWriteOver(Path path, Runnable then) {
        context.questions()
                .ask(new AuthorQuestion(
                        "changed-on-disk",
                        path.getFileName() + " was changed by another program since it was read.",
                        List.of(
                                new AuthorQuestion.Choice("disk-over", "Write over it", () -> write(path, then)),
                                new AuthorQuestion.Choice("disk-as", "Save as another file…", () -> saveAs(then)),
                                new AuthorQuestion.Choice("disk-stay", "Stay here", () -> {})),
                        () -> {}));
    }

    private void saveAs(Runnable then) {
        context.document().giveBack();
        context.typed().give();
        String proposed = context.document()
                .file()
                .map(path -> path.getFileName().toString().replaceFirst("\\.json$", ""))
                .orElse(context.document().project().id());
        dialogs.save("Save the project", proposed).ifPresent(path -> writeOrAsk(path, then, () -> saveAs(then)));
    }

    /** Writes where nothing of somebody else's would go; else the author is asked first. */
    private void writeOrAsk(Path path, Runnable then, Runnable chooseAgain) {
        if (Files.exists(DiskVersion.main(path)) && !file.isOwn(path)) {
            askToReplace(path, then, chooseAgain);
        } else {
            write(path, then);
        }
    }

    private void askToReplace(Path path, Runnable then, Runnable chooseAgain) {
        String there = Files.isDirectory(path) ? "a project in the folder " : "a file ";
        context.questions()
                .ask(new AuthorQuestion(
                        "file-there",
                        "There is " + there + path.getFileName() + " already.",
                        List.of(
                                new AuthorQuestion.Choice("file-replace", "Replace it", () -> write(path, then)),
                                new AuthorQuestion.Choice("file-other", "Choose another…", chooseAgain),
                                new AuthorQuestion.Choice("file-stay", "Stay here", () -> {})),
                        () -> {}));
    }

    private void saveAsFolder() {
        context.document().giveBack();
        context.typed().give();
        dialogs.folder("Save the project as a folder with one file for each plan")
                .ifPresent(path -> {
                    try {
                        Files.createDirectories(path);
                        writeOrAsk(path, () -> {}, this::saveAsFolder);
                    } catch (IOException fault) {
                        context.notices().refused(path + " cannot be made: " + SaveFault.words(path, fault));
                    }
                });
    }

    private void write(Path path, Runnable then) {
        try {
            file.save(path);
        } catch (IOException | UncheckedIOException fault) {
            context.notices().refused(path + " is not saved: " + SaveFault.words(path, fault));
            return;
        }
        context.questions().withdraw("changed-on-disk");
        recent.add(path);
        context.notices().show("Saved in " + path);
        then.run();
    }

    /** Stops the window's background tasks. Unsaved changes are lost. */
    @Override
    public void close() {
        watch.close();
        try {
            autosave.close();
        } catch (IOException fault) {
            System.err.println("dreamm: " + fault.getMessage());
        }
    }
}
