package org.sami.crw.gui.mission;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.GraphicsEnvironment;
import java.awt.KeyboardFocusManager;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import javax.swing.Icon;
import javax.swing.JPanel;
import javax.swing.JTabbedPane;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.jspecify.annotations.Nullable;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.operator.mission.MissionsSnapshot;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Outcome;
import org.sami.ui.command.Command;
import org.sami.ui.look.Icons;
import org.sami.ui.look.PlainTextUI;
import org.sami.ui.net.NetView;
import org.sami.ui.value.ValueEditors;

/**
 * The plans that can be started, a tab for each mission that runs, and the list of those that have ended. The tab of a mission that begins comes to the front, unless the
 * operator writes in the one that is there or is about to end its mission, and has the keyboard's focus only where that was in these tabs. A mission that ends leaves the tabs, but
 * for the one that is looked at, which does so later; no tab moves while the pointer is on the tabs. On the event thread.
 */
public final class MissionMonitor extends JPanel {
    private final OperatorContext context;
    private final JTabbedPane tabs = new JTabbedPane();
    private final Map<Long, MissionView> views = new LinkedHashMap<>();
    private final PlansPanel plans;
    private final GlobalsPanel globals;
    private final EndedMissionsPanel over;
    private final Set<Long> again = new HashSet<>(); // ended ones that the operator has shown again
    private final Set<Long> begunHere = new HashSet<>(); // of which no model has told yet
    private final Map<Long, State> states = new HashMap<>(); // as the icons of the tabs say

    private record State(Optional<Outcome> outcome, boolean stuck) {
        static State of(MissionSnapshot mission) {
            return new State(mission.outcome(), mission.stuck().isPresent());
        }
    }

    /**
     * The missions of the session.
     *
     * @param editors with which globals are changed
     * @param file of the project
     */
    public MissionMonitor(OperatorContext context, MissionStarter starter, ValueEditors editors, LoadedProject file) {
        super(new BorderLayout());
        this.context = context;
        tabs.setName("mission-tabs");
        tabs.setTabLayoutPolicy(JTabbedPane.SCROLL_TAB_LAYOUT);
        plans = new PlansPanel(context, starter);
        globals = new GlobalsPanel(context, editors, file);
        tabs.addTab("Plans", Icons.small("folder"), plans);
        plans.onNeedToShow(() -> {
            toFront();
            tabs.setSelectedComponent(plans);
        });
        tabs.addTab("Globals", Icons.small("variables"), globals);
        over = new EndedMissionsPanel(context, this::showAgain);
        tabs.addTab("Ended", Icons.small("complete"), over);
        add(tabs);
        addCommands();
        starter.onStarted(this::startedHere);
        context.models().missions().addListener(this::show);
        context.models().gantt().addListener(missions -> showPhases());
        context.models().health().addListener(health -> tabChanged()); // no mission goes on while the engine does not
        show(context.models().missions().snapshot());
    }

    /** Puts the focus where the first thing is done. */
    public void focusFirst() {
        plans.first().requestFocusInWindow();
    }

    /** Shows the plans of the newest project. */
    public void reloadPlans() {
        plans.reload();
        globals.reload();
    }

    private void addCommands() {
        context.commands()
                .add(new Command("mission-abort", "Abort mission…", () -> propose(true))
                        .withKey("ctrl shift A")
                        .withIcon("abort")
                        .unless(this::whyNotEnd));
        context.commands()
                .add(new Command("mission-complete", "Complete mission…", () -> propose(false))
                        .withKey("ctrl shift C")
                        .withIcon("complete")
                        .unless(this::whyNotEnd));
        context.commands()
                .add(new Command(
                                "mission-end-confirm",
                                "End the mission as proposed",
                                () -> ending().ifPresent(EndingPanel::confirm))
                        .withKey("ctrl shift E")
                        .withIcon("check")
                        .unless(this::whyNothingProposed));
        context.commands()
                .add(new Command("mission-end-leave", "Let it run", () -> ending().ifPresent(EndingPanel::leave))
                        .withFocusKeys(List.of(EndingPanel.LEAVE))
                        .withIcon("close")
                        .unless(this::whyNothingProposed));
        context.commands()
                .add(new Command(
                                "mission-send-again",
                                "Send again what failed",
                                () -> shown().ifPresent(MissionView::sendAgain))
                        .withKey("ctrl R")
                        .withIcon("resend")
                        .unless(() -> shown().map(MissionView::whyNotAgain)
                                .orElse(Optional.of("show the tab of a running mission first"))));
        context.commands()
                .add(new Command("mission-close", "Close the tab of an ended mission", this::closeShown)
                        .withKey("ctrl W")
                        .withIcon("close")
                        .unless(() -> shown().map(view -> view.hasEnded()).orElse(false)
                                ? Optional.empty()
                                : Optional.of("only the tab of an ended mission can be closed")));
        context.commands()
                .add(new Command("mission-sub-mission", "Show a sub-mission…", this::chooseSubMission)
                        .withKey("ctrl P")
                        .withIcon("layers")
                        .unless(() ->
                                shown().filter(MissionView::hasSubMissions).isPresent()
                                        ? Optional.empty()
                                        : Optional.of("the mission that is shown has no sub-mission now")));
        NetView.commands(() -> shown().map(MissionView::net)).forEach(context.commands()::add);
        tabs.addChangeListener(e -> tabChanged());
    }

    private void refreshCommands() {
        List.of(
                        "mission-abort",
                        "mission-complete",
                        "mission-end-confirm",
                        "mission-end-leave",
                        "mission-send-again",
                        "mission-close",
                        "mission-sub-mission")
                .forEach(id -> context.commands().get(id).refresh());
    }

    private Optional<String> whyNotEnd() {
        return shown().filter(view -> !view.hasEnded()).isPresent()
                ? Optional.empty()
                : Optional.of("show the tab of a running mission first");
    }

    private Optional<MissionView> shown() {
        return tabs.getSelectedComponent() instanceof MissionView view ? Optional.of(view) : Optional.empty();
    }

    private Optional<EndingPanel> ending() {
        return shown().map(MissionView::ending)
                .filter(ending -> ending.proposed().isPresent());
    }

    private Optional<String> whyNothingProposed() {
        return ending().isPresent() ? Optional.empty() : Optional.of("press Abort mission or Complete mission first");
    }

    /** What is proposed is to be read before it is confirmed: a key may be pressed while the panel lies behind another. */
    private void propose(boolean abort) {
        shown().ifPresent(view -> {
            toFront();
            view.propose(abort);
        });
    }

    private void chooseSubMission() {
        shown().ifPresent(view -> {
            toFront();
            view.chooseSubMission();
        });
    }

    private void toFront() {
        if (!isShowing()) {
            context.commands().find("panel-missions").ifPresent(Command::run);
        }
    }

    /** Shows what changes by itself; to be called a few times a second. */
    public void refresh() {
        if (context.whyNotAct().isEmpty()) { // a replay starts none
            plans.refresh();
        }
        shown().ifPresent(MissionView::refreshEnding);
        leaveEnded(context.models().missions().snapshot());
    }

    private void closeShown() {
        shown().ifPresent(view -> {
            remove(view);
            if (shown().isEmpty()) {
                tabs.setSelectedIndex(0); // the plans, of which the next mission is one
            }
        });
    }

    private void showPhases() {
        shown().ifPresent(view -> view.show(context.models().gantt().mission(view.mission())));
    }

    /** A tab that was hidden was not kept up to date. */
    private void tabChanged() {
        MissionsSnapshot missions = context.models().missions().snapshot();
        showPhases();
        shown().filter(views::containsValue)
                .ifPresent(view -> missions.mission(view.mission()).ifPresent(mission -> view.show(mission, missions)));
        refreshCommands();
    }

    private void show(MissionsSnapshot missions) {
        for (MissionSnapshot mission : missions.missions()) {
            if (mission.parent() == Ids.NONE && (!mission.hasEnded() || views.containsKey(mission.id()))) {
                MissionView view = views.computeIfAbsent(mission.id(), id -> added(mission, missions));
                if (view == tabs.getSelectedComponent()) {
                    view.show(mission, missions);
                }
                if (!State.of(mission).equals(states.put(mission.id(), State.of(mission)))) {
                    tabs.setIconAt(tabs.indexOfComponent(view), icon(mission));
                }
            }
        }
        over.show(missions);
        leaveOut(missions);
        leaveEnded(missions);
        refreshCommands();
    }

    /** Takes the tabs of ended missions away, but for the one that is looked at and those that were asked for. */
    private void leaveEnded(MissionsSnapshot missions) {
        if (isPointedAt()) {
            return;
        }
        List<MissionView> leaving = views.values().stream()
                .filter(view -> view != tabs.getSelectedComponent() && !again.contains(view.mission()))
                .filter(view -> missions.mission(view.mission())
                        .map(MissionSnapshot::hasEnded)
                        .orElse(false))
                .toList();
        leaving.forEach(this::remove);
    }

    private void remove(MissionView view) {
        again.remove(view.mission());
        states.remove(view.mission());
        views.remove(view.mission());
        tabs.remove(view);
    }

    /** Whether the pointer is on the tabs, which would move under it. */
    private boolean isPointedAt() {
        Point at = GraphicsEnvironment.isHeadless() ? null : tabs.getMousePosition();
        Rectangle first = tabs.getBoundsAt(0);
        return at != null && first != null && at.y < first.y + first.height;
    }

    private void showAgain(long mission) {
        MissionsSnapshot missions = context.models().missions().snapshot();
        missions.mission(mission).ifPresent(ended -> {
            again.add(mission);
            MissionView view = views.containsKey(mission) ? views.get(mission) : added(ended, missions);
            views.put(mission, view);
            tabs.setSelectedComponent(view);
            tabChanged();
        });
    }

    /** In a replay that went back there are missions that have not begun yet; a session forgets those that ended long ago only. */
    private void leaveOut(MissionsSnapshot missions) {
        if (context.whyNotAct().isPresent()) {
            Set<Long> known =
                    missions.missions().stream().map(MissionSnapshot::id).collect(Collectors.toSet());
            views.entrySet().removeIf(view -> {
                boolean gone = !known.contains(view.getKey());
                if (gone) {
                    tabs.remove(view.getValue());
                }
                return gone;
            });
        }
    }

    private MissionView added(MissionSnapshot mission, MissionsSnapshot all) {
        MissionView view = new MissionView(context, mission, all, this::refreshCommands);
        view.show(context.models().gantt().mission(mission.id()));
        boolean twice = views.keySet().stream()
                .flatMap(id -> all.mission(id).stream())
                .anyMatch(other -> other.id() != mission.id() && other.words().equals(mission.words()));
        String title = twice ? mission.words() + " (" + mission.id() + ")" : mission.words();
        states.put(mission.id(), State.of(mission));
        tabs.addTab(
                PlainTextUI.of(title),
                icon(mission),
                view); // with its icon: a tab that widens later is cut at the edge
        if (begunHere.remove(mission.id())) {
            turnTo(view);
        } else if (!isInUse()) {
            boolean focused = hasFocus(tabs);
            tabs.setSelectedComponent(view);
            if (focused) {
                view.focusFirst();
            }
        }
        return view;
    }

    /** The operator has begun it in this window. */
    private void startedHere(long mission) {
        if (views.containsKey(mission)) {
            turnTo(views.get(mission));
        } else {
            begunHere.add(mission);
        }
    }

    private void turnTo(MissionView view) {
        Component owner = focusOwner();
        boolean free = owner == null || !owner.isShowing() || hasFocus(tabs); // what it was begun with may be gone
        tabs.setSelectedComponent(view);
        if (free) {
            view.focusFirst();
        }
    }

    /** Whether the operator writes in the tab in front, draws in it, or is about to end its mission: it must not go away then. */
    private boolean isInUse() {
        return hasFocus(tabs)
                && (focusOwner() instanceof JTextComponent
                        || tabs.getSelectedComponent() == globals
                        || ending().isPresent());
    }

    private static boolean hasFocus(Component part) {
        Component owner = focusOwner();
        return owner != null && SwingUtilities.isDescendingFrom(owner, part);
    }

    private static @Nullable Component focusOwner() {
        return KeyboardFocusManager.getCurrentKeyboardFocusManager().getFocusOwner();
    }

    private static Icon icon(MissionSnapshot mission) {
        return mission.outcome()
                .map(outcome -> switch (outcome) {
                    case ENDED, COMPLETED -> Icons.of("complete", 16, SemanticColor.OK);
                    case ABORTED, HALTED -> Icons.of("abort", 16, SemanticColor.WARNING);
                })
                .orElseGet(() -> mission.stuck().isPresent()
                        ? Icons.of("alarm", 16, SemanticColor.WARNING)
                        : Icons.of("play", 16, SemanticColor.ACCENT));
    }
}
