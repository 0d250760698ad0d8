package org.sami.dreamm.compare;

import java.io.File;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BiConsumer;
import javax.swing.JFileChooser;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.ui.command.Command;

/** The commands that read another version of the open plan, off the event thread. */
final class CompareCommands {
    private final DreammContext context;
    private final BiConsumer<Plan, String> compare;
    private final Command saved;
    private final Command file;

    /**
     * Registers the commands.
     *
     * @param compare is given the version that was read, and what it is called
     */
    CompareCommands(DreammContext context, BiConsumer<Plan, String> compare) {
        this.context = context;
        this.compare = compare;
        saved = context.commands()
                .add(new Command("plan-compare-saved", "Compare with what was saved", this::compareWithSaved)
                        .withKey("ctrl shift K")
                        .withIcon("compare")
                        .unless(() -> whyNot().or(
                                        () -> context.document().file().isPresent()
                                                ? Optional.empty()
                                                : Optional.of("the project is not saved in a file yet"))));
        file = context.commands()
                .add(new Command("plan-compare-file", "Compare with a file…", this::compareWithFile)
                        .withKey("alt shift K")
                        .withIcon("file")
                        .unless(this::whyNot));
    }

    Command saved() {
        return saved;
    }

    Command file() {
        return file;
    }

    private Optional<String> whyNot() {
        return context.editor().plan().isPresent() ? Optional.empty() : Optional.of("no plan is open");
    }

    private void compareWithSaved() {
        read(context.document().file().orElseThrow(), "what was saved");
    }

    private void compareWithFile() {
        JFileChooser chooser = new JFileChooser(context.document()
                .file()
                .map(Path::toFile)
                .map(File::getParentFile)
                .orElse(null));
        chooser.setDialogTitle("Compare with");
        chooser.setFileSelectionMode(JFileChooser.FILES_AND_DIRECTORIES);
        if (chooser.showOpenDialog(null) == JFileChooser.APPROVE_OPTION) {
            Path path = chooser.getSelectedFile().toPath();
            read(path, path.getFileName().toString());
        }
    }

    /** Reads a project and compares the open plan with the plan that has its id there. */
    void read(Path path, String name) {
        String plan = context.editor().planId().orElseThrow();
        context.background()
                .run(
                        "Reading " + path,
                        () -> new ProjectReader(context.vocabulary()).read(path),
                        reading -> compare(reading, plan, name));
    }

    private void compare(Reading<Project> reading, String plan, String name) {
        Optional<Plan> before = reading.result().flatMap(project -> project.plan(plan));
        if (reading.result().isEmpty()) {
            context.notices()
                    .refused(name + " cannot be read: "
                            + reading.findings().get(0).message());
        } else if (before.isEmpty()) {
            context.notices().refused("There is no plan \"" + plan + "\" in " + name);
        } else {
            context.commands().find("panel-comparison").ifPresent(Command::run);
            compare.accept(before.get(), name);
            context.notices().show("Compared with " + name);
        }
    }
}
