package org.sami.dreamm.window;

import java.awt.BorderLayout;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.IntConsumer;
import javax.swing.JFrame;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.DocumentChange;
import org.sami.dreamm.document.DocumentListener;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.export.ExportCommands;
import org.sami.dreamm.file.FileCommands;
import org.sami.dreamm.file.RecentProjects;
import org.sami.dreamm.file.RecoveryFolder;
import org.sami.dreamm.help.HelpCommands;
import org.sami.dreamm.help.word.WordCommands;
import org.sami.dreamm.learn.CourseCommands;
import org.sami.dreamm.learn.JobModel;
import org.sami.dreamm.learn.Learning;
import org.sami.dreamm.learn.show.LessonShow;
import org.sami.dreamm.learn.view.LearnPanel;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandKeys;
import org.sami.ui.dock.DockArea;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.window.FrameSize;
import org.sami.ui.window.ViewCommands;
import org.sami.ui.window.WindowSettings;

/** The window over a document. On the event thread. */
public final class DreammWindow {
    private final DreammContext context;
    private final IntConsumer ended;
    private final JFrame frame = new JFrame("DREAMM");
    private final RunParts run;
    private final DockArea dock;
    private final StatusLine status;
    private final FileCommands files;
    private final WordCommands words;
    private final CommandKeys keys;
    private final Optional<LessonShow> show;
    private final Optional<LearnPanel> learn;
    private final Optional<String> unknownInProfile;

    /**
     * A window that is not shown yet.
     *
     * @param recovery where unsaved changes are kept, given up with the window
     * @param ended is called when all is closed, with the exit code
     * @param learning what the window has to do with the course
     */
    public DreammWindow(
            DreammContext context,
            RecoveryFolder recovery,
            AuthorDirectory data,
            WindowSettings settings,
            IntConsumer ended,
            Learning learning) {
        this.context = context;
        this.ended = ended;
        files = new FileCommands(context, frame, new RecentProjects(settings), recovery);
        EditCommands.addTo(context);
        ExportCommands.addTo(context);
        new HelpCommands(context).addTo(frame);
        words = new WordCommands(context, learning.access());
        words.addTo(frame, settings);
        run = new RunParts(context);
        CourseCommands.addTo(
                context.commands(), learning.access(), learning.lesson().isPresent());
        show = learning.lesson()
                .map(model -> new LessonShow(context, model, frame)); // before the panel with its button
        learn = learning.lesson().map(model -> new LearnPanel(model, context.commands()));
        DreammPanels panels = new DreammPanels(context, run, learn);
        learn.ifPresent(panel -> panel.setJobs(new JobModel(
                learning.lesson().orElseThrow(),
                learning.grader().orElseThrow(),
                new LessonEditor(context, files, run, panels.comparison(), frame),
                run.grading(),
                EventThread.executor())));
        dock = new DockArea(
                frame,
                panels.all(),
                learn.isPresent() ? DreammPanels.OF_COURSE : DreammPanels.FIRST,
                data.arrangement(context.profile()));
        ViewCommands view = new ViewCommands(context.commands(), frame, settings);
        view.addPanels(dock);
        if (context.profile().shows("panel-model-view")) {
            context.commands()
                    .add(new Command(
                                    "panels-fold",
                                    "Fold the panels to the edge, or not",
                                    () -> dock.toggleFolded("model-view"))
                            .withKey("F11")
                            .withIcon("fit"));
        }
        context.commands()
                .add(new Command("end", "Close DREAMM", this::leave)
                        .withKey("ctrl Q")
                        .withIcon("close"));
        status = new StatusLine(context, run.counters());
        frame.setName("dreamm-window");
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.setJMenuBar(DreammMenus.bar(context.commands(), files, panels.all()));
        frame.getContentPane().add(new QuestionBar(context.questions()), BorderLayout.NORTH);
        frame.getContentPane().add(dock);
        frame.getContentPane().add(status, BorderLayout.SOUTH);
        new ProfileGuard(context.profile()).guard(status);
        unknownInProfile = new WindowIds(context, panels).unknown();
        keys = CommandKeys.install(context.commands());
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                leave();
            }
        });
        listen();
        showState();
    }

    private void listen() {
        context.document().addListener(new DocumentListener() {
            @Override
            public void changed(DocumentChange change) {
                // what is shown of it is its panels'
            }

            @Override
            public void stateChanged() {
                showState();
            }
        });
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                showState();
            }

            @Override
            public void modeChanged() {
                context.commands().refresh();
            }

            @Override
            public void selectionChanged() {
                context.commands().refresh();
            }
        });
    }

    private void showState() {
        ProjectDocument document = context.document();
        String mark = document.isModified() && !document.isLent() ? "● " : "";
        String file = document.isLent()
                ? "a copy that is shown; your own project comes back"
                : document.file().map(Path::toString).orElse("not saved in a file yet");
        String name = document.project().name().isEmpty()
                ? document.project().id()
                : document.project().name();
        String plan = context.editor().planId().map(id -> id + " – ").orElse("");
        frame.setTitle(mark + plan + name + " – DREAMM");
        status.showFile(mark + name + " · " + file, mark.isEmpty() ? file : "There are changes that are not saved");
        context.commands().refresh();
    }

    /** What its profile names that it does not have, in one sentence; empty where it has all. */
    public Optional<String> unknownInProfile() {
        return unknownInProfile;
    }

    /** Shows it, as large as the screen allows. */
    public void open() {
        FrameSize.show(frame);
        arrange();
    }

    /** Shows it where another window was, and as large as that. */
    public void openAt(FramePlace place) {
        place.give(frame);
        frame.setVisible(true);
        arrange();
    }

    /** Where it is, for a window that takes its place. */
    public FramePlace place() {
        return FramePlace.of(frame);
    }

    private void arrange() {
        dock.arrange();
        dock.panels().stream()
                .map(DockPanel::getPersistentID)
                .filter("model-view"::equals)
                .forEach(dock::show);
        if (learn.isPresent()) {
            dock.show("learn");
        }
    }

    /** The frame, for those who drive it. */
    public JFrame frame() {
        return frame;
    }

    /** What its panels work on. */
    public DreammContext context() {
        return context;
    }

    /** The project's file, for those who drive the window. */
    public FileCommands files() {
        return files;
    }

    /** Closes the window, once the author has saved or given up unsaved work. */
    public void leave() {
        files.guard(this::end);
    }

    /** Closes the window at once; the process ends with it. */
    public void end() {
        discard();
        ended.accept(0);
    }

    /** Discards a window that is not used. */
    public void discard() {
        show.ifPresent(LessonShow::close);
        learn.ifPresent(LearnPanel::close);
        files.close();
        words.close();
        keys.close();
        dock.close();
        run.close();
        context.close();
        frame.dispose();
    }
}
