package org.sami.dreamm.replay;

import java.awt.BorderLayout;
import java.io.File;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.ExecutorService;
import java.util.stream.Collectors;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.context.NetOverlay;
import org.sami.dreamm.document.EditorListener;
import org.sami.dreamm.replay.PlanReplay.Moment;
import org.sami.dreamm.tryout.Breakpoint;
import org.sami.dreamm.tryout.TryOut;
import org.sami.dreamm.tryout.TryOutOverlay;
import org.sami.palette.SemanticColor;
import org.sami.picture.net.NetBadges;
import org.sami.picture.net.NetMarking;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.replay.JournalRun;
import org.sami.spn.replay.TimeLine;
import org.sami.ui.EventThread;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.replay.PlaybackTimer;
import org.sami.ui.replay.TimeLinePanel;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/**
 * Opens a journal and shows it on the net of the open plan: missions that ran, a time line, where the plan differs from the session's. On the
 * event thread; moments are computed on another thread.
 */
public final class ReplayPanel extends FoldingPanel {
    private static final int LOW = 180;
    private static final int TWO_ROWS = 420;
    private static final String WORDS = "wmin 0";
    private static final String WORDS_BELOW = "newline, span, growx, " + WORDS;

    private final transient DreammContext context;
    private final transient TryOut tryOut;
    private final transient TryOutOverlay overlay;
    private final transient PlaybackTimer player;
    private final TimeLinePanel timeLine;
    private final transient MigLayout bars = new MigLayout("insets 4 8 4 8, gap 12 4", "[][][grow, fill]", "[]");
    private final JPanel top = new JPanel(bars);
    private final JPanel words = new JPanel(new MigLayout("insets 0, gap 2, wrap, hidemode 3", "[grow, fill]"));
    private final JLabel file = new JLabel();
    private final JLabel difference = new JLabel();
    private final RowTable<PlanReplay.ShownMission> missions;
    private transient Optional<PlanReplay> replay = Optional.empty();
    private transient Optional<Moment> moment = Optional.empty();
    private volatile boolean jumping = true; // read where moments are computed

    /**
     * A panel that shows no journal yet.
     *
     * @param worker computes moments, one after another
     */
    public ReplayPanel(DreammContext context, TryOut tryOut, TryOutOverlay overlay, ExecutorService worker) {
        super(new BorderLayout());
        this.context = context;
        this.tryOut = tryOut;
        this.overlay = overlay;
        setName("replay-panel");
        player = new PlaybackTimer(new TimeLine(0, List.of(), new TreeSet<>()), millis -> {}, worker);
        missions = new RowTable<>(
                "replay-missions",
                "No mission runs at this moment. Open the journal of a session; its missions stand here, their tokens on the net.",
                PlanReplay.ShownMission::id,
                List.of(
                        RowColumn.words("Mission", 0, PlanReplay.ShownMission::name),
                        RowColumn.words("Plan", 0, PlanReplay.ShownMission::plan),
                        RowColumn.words(
                                "Tokens in",
                                0,
                                shown -> String.join(
                                        ", ", shown.marking().tokens().keySet()))));
        Command open = new Command("replay-open", "Open a journal…", this::choose)
                .withKey("ctrl shift J")
                .withIcon("folder");
        Command close = new Command("replay-close", "Close the journal", this::closeJournal)
                .withKey("ctrl shift W")
                .withIcon("close")
                .unless(() -> replay.isPresent() ? Optional.empty() : Optional.of("no journal is open"));
        context.commands().add(open);
        context.commands().add(close);
        timeLine = new TimeLinePanel(player, context.commands(), TimeLinePanel.Keys.FOCUS);
        for (Command command : context.commands().all()) {
            if (command.id().startsWith("replay-") && command != open && command != close) {
                command.unless(() -> replay.isPresent() ? Optional.empty() : Optional.of("no journal is open"));
            }
        }
        top.setOpaque(false);
        top.add(new CommandButton(open), "hmin 32");
        top.add(CommandButton.iconOnly(close), "hmin 32");
        words.setOpaque(false);
        file.setName("replay-file");
        difference.setName("replay-difference");
        words.add(file, "wmin 0");
        words.add(difference, "wmin 0");
        top.add(words, WORDS);
        add(top, BorderLayout.NORTH);
        add(missions);
        add(timeLine, BorderLayout.SOUTH);
        foldWhere(this::leavesOutTop, hidden -> top.setVisible(!hidden));
        foldBelowWidth(TWO_ROWS, narrow -> bars.setComponentConstraints(words, narrow ? WORDS_BELOW : WORDS));
        missions.addSelectionListener(
                () -> missions.selected().ifPresent(shown -> context.editor().open(shown.plan())));
        context.editor().addListener(new EditorListener() {
            @Override
            public void planOpened() {
                refresh();
            }
        });
        context.document().addListener(change -> refresh());
        tryOut.addListener(this::refresh);
        player.addListener(this::noteJump);
        style();
        refresh();
    }

    /** In a low panel there is room for missions and the time line of a journal; its file is closed and another opened from the menu. */
    private boolean leavesOutTop() {
        return replay.isPresent() && !difference.isVisible() && getHeight() < Look.px(LOW);
    }

    private void choose() {
        JFileChooser chooser = new JFileChooser();
        chooser.setName("replay-chooser");
        chooser.setDialogTitle("Open the journal of a session");
        if (chooser.showOpenDialog(this) == JFileChooser.APPROVE_OPTION) {
            File chosen = chooser.getSelectedFile();
            open(chosen.toPath());
        }
    }

    /** Opens a journal, off the event thread; one that cannot be read is refused in the status line. */
    public void open(Path journal) {
        context.background()
                .run(
                        "Reading the journal",
                        () -> {
                            try {
                                return new PlanReplay(JournalRun.open(journal));
                            } catch (IOException unreadable) {
                                throw new UncheckedIOException(unreadable.getMessage(), unreadable);
                            }
                        },
                        this::opened);
    }

    private void opened(PlanReplay next) {
        replay = Optional.of(next);
        moment = Optional.empty();
        player.show(next.journal().timeLine(), millis -> compute(next, millis));
        next.journal().project().plans().stream()
                .filter(plan -> next.journal().timeLine().marks().stream()
                                .anyMatch(mark -> mark.text().startsWith(plan.name()))
                        && context.document().plan(plan.id()).isPresent())
                .findFirst()
                .ifPresent(plan -> context.editor().open(plan.id()));
        context.commands().refresh();
        refresh();
        context.commands().find("panel-replay").ifPresent(Command::run);
        EventThread.later(timeLine::focus); // when the panel is to be seen
    }

    private void closeJournal() {
        player.close();
        replay = Optional.empty();
        moment = Optional.empty();
        player.show(new TimeLine(0, List.of(), new TreeSet<>()), millis -> {});
        context.commands().refresh();
        refresh();
    }

    private void noteJump() {
        jumping = !player.playback().isPlaying();
    }

    /** On the worker: breakpoints stop it while it plays, but not when the user goes to a moment. */
    private void compute(PlanReplay of, long millis) {
        boolean plays =
                !jumping && of.journal().entriesUntil(millis) > of.journal().taken();
        Set<Breakpoint> at = plays ? tryOut.breakpoints() : Set.of();
        Moment next = plays ? of.goOn(millis, at) : of.goTo(millis);
        EventThread.later(() -> computed(of, next));
    }

    private void computed(PlanReplay of, Moment next) {
        if (replay.filter(now -> now == of).isEmpty()) {
            return;
        }
        moment = Optional.of(next);
        next.stopped().ifPresent(at -> {
            player.pause();
            player.goTo(next.atMillis());
            context.editor().open(at.plan());
            context.editor().highlight(Set.of(at.vertex()));
            context.notices().show("The replay stopped at the breakpoint at " + name(at));
        });
        refresh();
        String open = context.editor().planId().orElse("");
        context.overlay()
                .fired(next.fired().stream()
                        .filter(vertex -> vertex.plan().equals(open))
                        .map(Breakpoint::vertex)
                        .collect(Collectors.toSet()));
    }

    private String name(Breakpoint at) {
        return context.document()
                .plan(at.plan())
                .flatMap(plan -> new ElementNames(plan, context.vocabulary()).of(at.vertex()))
                .orElse(at.vertex());
    }

    private void refresh() {
        file.setText(replay.map(r -> r.journal().file().toAbsolutePath()
                        + r.journal()
                                .damage()
                                .map(text -> "  ▲ not all of it can be read: " + text)
                                .orElse(""))
                .orElse("No journal is open"));
        file.setToolTipText(
                replay.isPresent()
                        ? file.getText()
                        : "A journal is the recorded session of a field day; its tokens are shown on the plan");
        Optional<String> differs = replay.flatMap(r -> context.editor().plan().flatMap(r::difference));
        difference.setText(differs.map(text -> "▲ " + text).orElse(""));
        difference.setToolTipText(differs.orElse(null));
        difference.setVisible(differs.isPresent());
        timeLine.setVisible(replay.isPresent());
        revalidate();
        missions.show(moment.map(Moment::missions).orElse(List.of()));
        String open = context.editor().planId().orElse("");
        overlay.showInstead(moment.filter(m -> replay.isPresent())
                .map(m -> new NetOverlay.Shown(
                        m.mission(open).map(PlanReplay.ShownMission::marking).orElse(NetMarking.EMPTY),
                        new NetBadges(overlay.breakpoints(open), Set.of()),
                        id -> Optional.empty())));
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (difference != null) {
            style();
        }
    }

    private void style() {
        LookColors.background(this, SemanticColor.SURFACE);
        file.setFont(Fonts.text());
        LookColors.foreground(file, SemanticColor.MUTED);
        difference.setFont(Fonts.text());
        LookColors.foreground(difference, SemanticColor.WARNING);
    }
}
