package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTabbedPane;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.gantt.GanttMission;
import org.sami.crw.operator.mission.EngineText;
import org.sami.crw.operator.mission.MissionEnd;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.crw.operator.mission.StuckMission;
import org.sami.crw.operator.mission.Wait;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.Value;
import org.sami.ui.look.FoldingPanel;
import org.sami.ui.net.NetView;
import org.sami.ui.replay.SessionClock;
import org.sami.ui.table.RowColumn;
import org.sami.ui.table.RowTable;

/** One mission: where its tokens are, what it waits for and why nothing fires, its variables; its end in two buttons. */
final class MissionView extends FoldingPanel {
    private static final int LOW = 300;
    private static final int NARROW = 720; // tabs, the words of both buttons and what is stuck
    private static final int LEAST_TAB = 64;

    private final long mission;
    private final String title;
    private final MissionHead head;
    private final RowTable<Line> places;
    private final RowTable<Line> variables;
    private final JTabbedPane parts = new JTabbedPane();
    private final MissionNet net;
    private final PhasesView phases = new PhasesView();
    private final OperatorContext context;
    private final EndingPanel ending;
    private Optional<String> interceptor = Optional.empty();
    private final StuckBar stuckBar;
    private boolean ended;
    private boolean stuck;
    private Optional<StuckMission> stuckNow = Optional.empty();
    private String said = "";

    /** A line of a table: what, and what is so. */
    private record Line(String what, String text, boolean wrong) {}

    /** @param proposed is called when an end is proposed, or no longer */
    MissionView(OperatorContext context, MissionSnapshot first, MissionsSnapshot all, Runnable proposed) {
        super(new BorderLayout());
        this.context = context;
        mission = first.id();
        title = first.title();
        setName("mission-" + mission);
        places =
                table("mission-places", "Nothing stands anywhere: the mission is over.", "Place", "Who waits for what");
        variables = table("mission-variables", "The plan has no variable with a value yet.", "Variable", "Value");
        head = new MissionHead(context.commands());
        stuckBar = new StuckBar(context.commands());
        ending = new EndingPanel(context.commands(), this::end, this::focusFirst, proposed);
        parts.setName("mission-parts");
        parts.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        parts.putClientProperty("JTabbedPane.minimumTabWidth", LEAST_TAB);
        parts.putClientProperty("JTabbedPane.trailingComponent", head.icons());
        JScrollPane scrolledPhases = new JScrollPane(phases);
        scrolledPhases.setBorder(BorderFactory.createEmptyBorder());
        net = new MissionNet(context, all, mission);
        net.onNeedOfMenu(() -> head.needSubMissions(net.needsMenu()));
        head.needSubMissions(net.needsMenu());
        parts.addTab("Net", net);
        parts.addTab("Waits", places);
        parts.addTab("Phases", scrolledPhases);
        parts.addTab("Variables", variables);
        JPanel top = new JPanel(new BorderLayout());
        top.add(head.line(), BorderLayout.NORTH);
        top.add(stuckBar);
        top.add(ending, BorderLayout.SOUTH);
        add(top, BorderLayout.NORTH);
        add(parts);
        foldBelowHeight(LOW, this::leaveRoomToNet);
        foldBelowWidth(NARROW, head::setNarrow);
    }

    /** Its net. */
    NetView net() {
        return net.view();
    }

    /** Whether it has sub-missions whose nets can be shown. */
    boolean hasSubMissions() {
        return net.hasSubMissions();
    }

    /** Lets the operator choose whose net is shown. */
    void chooseSubMission() {
        parts.setSelectedComponent(net);
        net.choose();
    }

    EndingPanel ending() {
        return ending;
    }

    /** Says what an abort, or a completion, will do, and lets the operator have it done or leave it. */
    void propose(boolean abort) {
        interceptor = Optional.empty();
        ending.propose(abort, title);
        refreshEnding();
        context.shown()
                .ask(view ->
                        view.planOf(mission).flatMap(plan -> MissionEnd.interceptor(plan, view.vocabulary(), abort)))
                .thenAccept(transition -> {
                    interceptor = transition.map(one -> one.name().isEmpty() ? one.id() : one.name());
                    refreshEnding();
                });
    }

    /** Says again what the proposed end will do, as boats go on meanwhile. */
    void refreshEnding() {
        if (ending.proposed().isPresent()) {
            OperatorModels models = context.models();
            ending.say(EndingWords.lines(
                            MissionEnd.of(
                                    mission,
                                    models.missions().snapshot(),
                                    models.commands().snapshot(),
                                    models.decisions().snapshot()),
                            interceptor,
                            context.titles())
                    .stream()
                    .map(context::say)
                    .toList());
        }
    }

    private void end(boolean abort) {
        context.tell(
                abort ? context.session().abort(mission) : context.session().complete(mission),
                title + (abort ? " is asked to abort" : " is asked to complete"));
    }

    private static RowTable<Line> table(String name, String nothing, String what, String text) {
        return new RowTable<>(
                name,
                nothing,
                Line::what,
                List.of(
                        RowColumn.words(what, 180, Line::what),
                        RowColumn.<Line>words(text, 0, Line::text)
                                .colored(line -> line.wrong() ? SemanticColor.MUTED : SemanticColor.TEXT)));
    }

    /** Puts the focus on what is shown, not on what would end the mission. */
    void focusFirst() {
        parts.requestFocusInWindow();
    }

    long mission() {
        return mission;
    }

    String title() {
        return title;
    }

    /** Why what failed cannot be sent again; empty where it can. */
    Optional<String> whyNotAgain() {
        return context.models()
                        .missions()
                        .snapshot()
                        .mission(mission)
                        .flatMap(MissionSnapshot::stuck)
                        .filter(StuckMission::canBeSentAgain)
                        .isPresent()
                ? Optional.empty()
                : Optional.of("nothing has failed in the mission that is shown");
    }

    /** Has what failed sent again. */
    void sendAgain() {
        context.tell(context.session().sendAgain(mission), "what failed in " + title + " is sent again");
    }

    private boolean isStuck() {
        return stuckNow.isPresent();
    }

    boolean hasEnded() {
        return ended;
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (head != null) {
            head.show(said, ended, stuck);
        }
    }

    /** In a low panel all that can be is left to the net; that the mission is stuck stands next to the tabs. */
    private void leaveRoomToNet(boolean low) {
        head.setLow(low);
        stuckBar.setVisible(isStuck() && !low);
    }

    /** Shows how far it is in the phases of its plan. */
    void show(Optional<GanttMission> now) {
        phases.show(now);
    }

    /** Shows how it stands now. */
    void show(MissionSnapshot now, MissionsSnapshot all) {
        ended = now.hasEnded();
        if (ended) {
            ending.leave();
        }
        boolean still = context.models().health().snapshot().missionsStandStill();
        stuck = !ended && (still || now.stuck().isPresent());
        stuckNow = ended ? Optional.empty() : now.stuck();
        stuckNow.ifPresent(stuckBar::show);
        stuckBar.setVisible(isStuck() && !head.isLow());
        head.showStuck(stuckNow);
        said = now.outcome()
                        .map(outcome -> outcome.name().toLowerCase(Locale.ROOT) + " at "
                                + SessionClock.text(now.endedAtMillis().orElse(0)))
                        .orElse((still ? "stands still, runs since " : stuck ? "stuck, runs since " : "runs since ")
                                + SessionClock.text(now.startedAtMillis()))
                + ", " + now.firings() + (now.firings() == 1 ? " firing" : " firings");
        head.show(said, ended, stuck);
        net.show(all);
        places.show(lines(now.details().blocked()));
        List<Line> values = new ArrayList<>();
        now.variables().forEach((name, value) -> values.add(line(name, value)));
        all.globals().forEach((name, value) -> values.add(line(name, value)));
        variables.show(values);
    }

    private static Line line(String name, Value value) {
        return new Line(name, EngineText.value(value), false);
    }

    private static List<Line> lines(List<Wait> waits) {
        List<Line> lines = new ArrayList<>();
        for (Wait wait : waits) {
            String who = wait.tokens().isEmpty() ? "" : String.join(", ", wait.tokens()) + ": ";
            lines.add(new Line(wait.place(), who + "waits for " + wait.occurrence(), false));
            wait.transitions()
                    .forEach(transition -> transition
                            .reasons()
                            .forEach(reason ->
                                    lines.add(new Line("    " + transition.name(), "cannot fire: " + reason, true))));
        }
        return lines;
    }
}
