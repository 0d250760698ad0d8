package org.sami.crw.gui.replay;

import java.awt.BorderLayout;
import java.awt.Font;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.function.Consumer;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import javax.swing.JFrame;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.Timer;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.gui.context.BoatSelection;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.window.OperatorPanels;
import org.sami.crw.gui.window.WindowMenus;
import org.sami.crw.handler.HandlerModules;
import org.sami.crw.operator.DecisionQueue;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.replay.Replay;
import org.sami.crw.replay.ReplayedJournal;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.spn.journal.JournalAddress;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandKeys;
import org.sami.ui.command.CommandPolicy;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.DockArea;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.replay.PlaybackTimer;
import org.sami.ui.replay.TimeLinePanel;
import org.sami.ui.window.FrameSize;
import org.sami.ui.window.Notices;
import org.sami.ui.window.ViewCommands;
import org.sami.ui.window.WindowSettings;

/**
 * The operator's window over a journal: the same panels, a band that says that it is a replay, a time line. What would act on boats or missions
 * cannot be run, and says why. On the event thread.
 */
public final class ReplayWindow {
    private static final int REFRESH_MS = 250;

    /** Commands whose ids begin so only show something. */
    private static final Set<String> SHOWING =
            Set.of("replay-", "panel-", "panels-", "theme-", "scale-", "command-", "help-", "map-", "end");

    private static final Set<String> ALSO_SHOWING =
            Set.of("mission-close", "mission-sub-mission", "decision-later", "decision-earlier", "decision-focus");

    private final DataDirectory data;
    private final IntConsumer ended;
    private final ExecutorService worker = Executors.newSingleThreadExecutor(work -> daemon(work, "replay"));
    private final ExecutorService computing = Executors.newSingleThreadExecutor(work -> daemon(work, "map"));
    private final JFrame frame = new JFrame();
    private final PlaybackTimer player;
    private final OperatorPanels panels;
    private final DockArea dock;
    private final CommandKeys keys;
    private final TimeLinePanel timeLine;
    private final Timer refresh;

    /**
     * A window that is not shown yet.
     *
     * @param data is closed with the window
     * @param ended is called when all is closed
     */
    public ReplayWindow(ReplayedJournal journal, DataDirectory data, WindowSettings settings, IntConsumer ended) {
        this.data = data;
        this.ended = ended;
        Replay replay = new Replay(journal, EventThread.executor(), computing);
        player = new PlaybackTimer(journal.timeLine(), replay::goTo, worker);
        RobotKind robots = HandlerModules.robotsOf(journal.vocabulary());
        OperatorContext context = new OperatorContext(
                new ReplayedSession(replay, worker, computing, player::goTo),
                new CommandRegistry(CommandPolicy.ALL, robots::say),
                new ProxyMarks(),
                new BoatSelection(),
                new Notices(robots::say));
        CommandRegistry commands = context.commands();
        panels = new OperatorPanels(context, settings, new LoadedProject(Optional.empty()));
        dock = new DockArea(frame, panels.all(), OperatorPanels.FIRST, data.arrangement());
        ViewCommands view = new ViewCommands(commands, frame, settings);
        view.addPanels(dock);
        commands.add(new Command("end", "Close the replay", this::end)
                .withKey("ctrl Q")
                .withIcon("close"));
        commands.add(decisionMoment(replay.models().decisions()));
        timeLine = new TimeLinePanel(player, commands, TimeLinePanel.Keys.WINDOW);
        refuseWhatActs(context);
        frame.setName("replay-window");
        frame.setTitle("REPLAY " + name(journal.address()) + " – SAMI operator");
        frame.setDefaultCloseOperation(JFrame.DO_NOTHING_ON_CLOSE);
        frame.setJMenuBar(new WindowMenus(commands, panels.all(), robots).bar());
        frame.getContentPane().add(band(journal, robots), BorderLayout.NORTH);
        frame.getContentPane().add(dock);
        frame.getContentPane().add(timeLine, BorderLayout.SOUTH);
        keys = CommandKeys.install(commands);
        refresh = new Timer(REFRESH_MS, e -> panels.refresh());
        frame.addWindowListener(new WindowAdapter() {
            @Override
            public void windowClosing(WindowEvent e) {
                end();
            }
        });
    }

    private Command decisionMoment(DecisionQueue decisions) {
        Command moment = new Command(
                        "replay-decision",
                        "Show when the top decision was asked",
                        () -> player.goTo(decisions.snapshot().get(0).openedAtMillis()))
                .withKey("alt J")
                .withIcon("clock")
                .unless(() -> decisions.snapshot().isEmpty()
                        ? Optional.of("no decision waited at this moment")
                        : Optional.empty());
        decisions.addListener((Consumer<List<PendingDecision>>) waiting -> moment.refresh());
        return moment;
    }

    private static Thread daemon(Runnable work, String name) {
        Thread thread = new Thread(work, name);
        thread.setDaemon(true);
        return thread;
    }

    private static void refuseWhatActs(OperatorContext context) {
        for (Command command : context.commands().all()) {
            boolean shows =
                    ALSO_SHOWING.contains(command.id()) || SHOWING.stream().anyMatch(command.id()::startsWith);
            if (!shows) {
                command.unless(context::whyNotAct);
            }
        }
    }

    private static String name(JournalAddress journal) {
        return journal.file().map(file -> file.getFileName().toString()).orElseGet(journal::toString);
    }

    private static String place(JournalAddress journal) {
        return journal.file().map(file -> file.toAbsolutePath().toString()).orElseGet(journal::toString);
    }

    private static JPanel band(ReplayedJournal journal, RobotKind robots) {
        JPanel band = new JPanel(new MigLayout("insets 8 12 8 12, gap 16", "[][]push[]", "[]"));
        band.setName("replay-band");
        LookColors.background(band, SemanticColor.WARNING_FILL);
        band.add(new BandLabel("REPLAY", "replay-mark", Fonts::title));
        JLabel file = new BandLabel(place(journal.address()), "replay-file", Fonts::strong);
        file.setToolTipText(file.getText());
        band.add(file, "wmin 0, shrinkprio 200"); // what the window is for is read before where it comes from
        String damage = journal.damage()
                .map(text -> "▲ not all of it can be read: " + text)
                .orElse("");
        JLabel what = new BandLabel(
                damage.isEmpty()
                        ? robots.say("Nothing here acts on boats. The fleet stop is in the session's own window.")
                        : damage,
                "replay-note",
                Fonts::strong);
        what.setToolTipText(what.getText());
        band.add(what, "wmin 0");
        return band;
    }

    /** Shows it, as large as the screen allows, at a moment; empty = the start. */
    public void open(Optional<Long> atMillis) {
        FrameSize.show(frame);
        dock.arrange();
        timeLine.focus();
        refresh.start();
        player.goTo(atMillis.orElse(0L));
    }

    /** The frame, for those who drive it. */
    public JFrame frame() {
        return frame;
    }

    /** Closes the window. */
    public void end() {
        refresh.stop();
        player.close();
        keys.close();
        dock.close();
        panels.close();
        frame.dispose();
        worker.shutdown();
        computing.shutdown();
        int code = 0;
        try {
            data.close();
        } catch (IOException fault) {
            System.err.println("crw-operator: " + fault.getMessage());
            code = 4;
        }
        ended.accept(code);
    }

    /** A text of the band, in letters of the look in force at any time. */
    private static final class BandLabel extends JLabel {
        private final transient Supplier<Font> letters;

        BandLabel(String text, String name, Supplier<Font> letters) {
            super(text);
            this.letters = letters;
            setName(name);
            setFont(letters.get());
            LookColors.foreground(this, SemanticColor.ON_WARNING);
        }

        @Override
        public void updateUI() {
            super.updateUI();
            if (letters != null) { // the superclass sets the look before this class has its letters
                setFont(letters.get());
            }
        }
    }
}
