package org.sami.dreamm.window;

import java.awt.Dimension;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.Objects;
import java.util.Set;
import javax.swing.JFrame;
import org.sami.dreamm.compare.ComparisonPanel;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.file.FileCommands;
import org.sami.dreamm.file.ReplaceProject;
import org.sami.dreamm.learn.JobEditor;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.Reading;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TestCase;
import org.sami.ui.EventThread;
import org.sami.ui.look.Look;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** The editor of a window of the course: its document is kept in the learner's file after each edit. */
final class LessonEditor implements JobEditor {
    private static final int WIDTH = 860;
    private static final int HEIGHT = 640;

    private final DreammContext context;
    private final JFrame frame;
    private final FileCommands files;
    private final RunParts run;
    private final ComparisonPanel comparison;
    private boolean keeping;

    LessonEditor(DreammContext context, FileCommands files, RunParts run, ComparisonPanel comparison, JFrame frame) {
        this.frame = Objects.requireNonNull(frame, "frame");
        this.context = Objects.requireNonNull(context, "context");
        this.files = Objects.requireNonNull(files, "files");
        this.run = Objects.requireNonNull(run, "run");
        this.comparison = Objects.requireNonNull(comparison, "comparison");
        context.document().addListener((DocumentChange change) -> keepSoon());
    }

    private void keepSoon() {
        if (!keeping) {
            keeping = true;
            EventThread.later(() -> {
                keeping = false;
                if (!context.document().isLent()) { // a copy that is only shown is not the learner's
                    files.keep();
                }
            });
        }
    }

    @Override
    public void open(Path file, Project begin) {
        if (!Files.exists(file)) {
            files.openIn(file, begin);
            return;
        }
        Reading<Project> kept = new ProjectReader(context.vocabulary()).read(file);
        if (kept.result().isPresent()) {
            files.openIn(file, kept.result().get());
            return;
        }
        try {
            Path aside = aside(file);
            Files.move(file, aside, StandardCopyOption.ATOMIC_MOVE);
            context.notices()
                    .refused("Your plan of this job could not be read; it is kept as " + aside
                            + ", and the job begins anew");
            files.openIn(file, begin);
        } catch (IOException fault) {
            context.notices().refused(file + " can be neither read nor set aside: " + fault.getMessage());
        }
    }

    private static Path aside(Path file) {
        for (int i = 1; ; i++) {
            Path aside = file.resolveSibling(file.getFileName() + ".broken-" + i);
            if (!Files.exists(aside)) {
                return aside;
            }
        }
    }

    @Override
    public void replace(String label, Project by) {
        context.apply(new ReplaceProject(label, by));
    }

    @Override
    public Project project() {
        return context.document().project();
    }

    @Override
    public void show(String plan, Set<String> elements) {
        context.editor().open(plan, elements);
    }

    @Override
    public boolean play(String plan, TestCase test) {
        if (!context.profile().shows("panel-try-out")) {
            return false;
        }
        context.editor().open(plan, Set.of());
        return run.play(plan, test);
    }

    /** A window whose mode has no panel for it shows the same over its panels: the learner asked for it. */
    @Override
    public void compareWithSolution(Plan solution) {
        context.editor().open(solution.id(), Set.of());
        comparison.compareWithSolution(solution);
        if (context.profile().shows("panel-comparison")) {
            context.commands().get("panel-comparison").run();
        } else {
            comparison.setPreferredSize(new Dimension(Look.px(WIDTH), Look.px(HEIGHT)));
            WindowSheet.in(frame.getRootPane())
                    .open(new Sheet("comparison-sheet", "Your plan and the solution", comparison));
            EventThread.later(comparison::focusDifferences);
        }
    }
}
