package org.sami.crw.gui.window;

import java.awt.Dimension;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.sami.crw.gui.boat.BoatListPanel;
import org.sami.crw.gui.boat.SelectedBoatPanel;
import org.sami.crw.gui.context.LoadedProject;
import org.sami.crw.gui.context.MarksOfBoats;
import org.sami.crw.gui.context.OperatorContext;
import org.sami.crw.gui.context.RobotIcons;
import org.sami.crw.gui.decision.DecisionsPanel;
import org.sami.crw.gui.decision.SessionDecisions;
import org.sami.crw.gui.gantt.GanttPanel;
import org.sami.crw.gui.map.MapPanel;
import org.sami.crw.gui.map.SessionMaps;
import org.sami.crw.gui.mission.AllocationPanel;
import org.sami.crw.gui.mission.InterruptsPanel;
import org.sami.crw.gui.mission.MissionMonitor;
import org.sami.crw.gui.mission.MissionStarter;
import org.sami.crw.gui.notice.AlarmsPanel;
import org.sami.crw.gui.notice.CommunicationPanel;
import org.sami.crw.gui.notice.HealthPanel;
import org.sami.crw.gui.notice.LogPanel;
import org.sami.crw.gui.notice.MessagesPanel;
import org.sami.crw.gui.picture.PicturesPanel;
import org.sami.crw.gui.picture.ShownPictures;
import org.sami.crw.gui.value.SessionEditors;
import org.sami.crw.operator.OperatorModels;
import org.sami.crw.operator.mission.AllocationSnapshot;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.ComponentLibrary;
import org.sami.spn.json.DomainLibrary;
import org.sami.ui.command.CommandRegistry;
import org.sami.ui.dock.Arrangement;
import org.sami.ui.dock.Arrangements;
import org.sami.ui.dock.DockArea;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;
import org.sami.ui.value.MapMaker;
import org.sami.ui.value.ValueEditors;
import org.sami.ui.window.WindowSettings;

/** The panels of a window, over a session or over its replay, and how they lie at first. */
public final class OperatorPanels implements AutoCloseable {
    /** How they lie at first: thesis, Figure 5.5; in small windows and with large letters with more of them behind one another. */
    public static final Arrangements FIRST = new Arrangements(
            Arrangement.of("map")
                    .right("missions", "map", 0.42)
                    .behind("pictures", "map")
                    .behind("gantt", "map") // a tab row would take its height from the net of the missions
                    .below("boats", "map", 0.34)
                    .behind("boat", "boats")
                    .behind("communication", "boats")
                    .below("decisions", "missions", 0.68)
                    .below("interrupts", "decisions", 0.34) // three of a mission are in sight
                    .right("messages", "interrupts", 0.62)
                    .behind("alarms", "messages")
                    .behind("health", "messages")
                    .behind("allocation", "messages")
                    .behind("log", "messages"),
            Arrangement.of("map")
                    .right("missions", "map", 0.48)
                    .behind("pictures", "map")
                    .below("boats", "map", 0.4)
                    .behind("communication", "boats")
                    .behind("alarms", "boats")
                    .behind("health", "boats")
                    .behind("log", "boats")
                    .below("decisions", "missions", 0.62) // both what waits and the net of a mission are in sight
                    .behind("gantt", "missions")
                    .behind("boat", "missions") // the list of boats stays in sight
                    .behind("interrupts", "missions")
                    .behind("messages", "missions")
                    .behind("allocation", "missions"),
            Arrangement.of("map")
                    .right("decisions", "map", 0.5)
                    .behind("missions", "map")
                    .behind("gantt", "map")
                    .behind("pictures", "map")
                    .behind("boats", "map")
                    .behind("boat", "map")
                    .behind("communication", "map")
                    .behind("interrupts", "decisions")
                    .behind("messages", "decisions")
                    .behind("alarms", "decisions")
                    .behind("health", "decisions")
                    .behind("allocation", "decisions")
                    .behind("log", "decisions"),
            new Dimension(1280, 780),
            new Dimension(720, 440));

    /**
     * The other arrangement: thesis, Figure 5.6. The robots with their status and newest pictures on the left, one large map on which decisions draw, below it the
     * mission manager, whose tabs are plans with the nets of what runs, the Gantt chart, interrupts and decisions, and the messages at the bottom right. Where
     * there is less room the mission manager lies below the robots, and the map has all of the height.
     */
    public static final Arrangements AIMS = new Arrangements(
            Arrangement.of("map")
                    .left("boats", "map", 0.25)
                    .behind("boat", "boats")
                    .behind("communication", "boats")
                    .behind("pictures", "boats")
                    .below("missions", "map", 0.43)
                    .right("messages", "missions", 0.3)
                    .behind("gantt", "missions")
                    .behind("interrupts", "missions")
                    .behind("decisions", "missions")
                    .behind("alarms", "messages")
                    .behind("health", "messages")
                    .behind("allocation", "messages")
                    .behind("log", "messages"),
            Arrangement.of("map")
                    .left("boats", "map", 0.42) // with the missions below them, so that the map has all of the height
                    .behind("boat", "boats")
                    .behind("communication", "boats")
                    .behind("pictures", "boats")
                    .behind("messages", "boats")
                    .behind("alarms", "boats")
                    .behind("health", "boats")
                    .behind("allocation", "boats")
                    .behind("log", "boats")
                    .below("missions", "boats", 0.56)
                    .behind("gantt", "missions")
                    .behind("interrupts", "missions")
                    .behind("decisions", "missions"),
            FIRST.tight(),
            FIRST.leastRoomy(),
            FIRST.leastCompact());

    private final ShownPictures pictures;
    private final BoatListPanel boats;
    private final SelectedBoatPanel boat;
    private final GanttPanel gantt;
    private final MapPanel map;
    private final MissionMonitor missions;
    private final DecisionsPanel decisions;
    private final DockPanel asking;
    private final CommunicationPanel communication;
    private final List<DockPanel> all;
    private final ArrangementChoice arrangement;
    private final Map<DockPanel, BooleanSupplier> empty; // panels of which some have nothing in them at times

    /**
     * The panels of a window.
     *
     * @param file of the project that is shown
     */
    public OperatorPanels(OperatorContext context, WindowSettings settings, LoadedProject file) {
        Look.useFieldTargets();
        MarksOfBoats.give(context.shown(), context.marks());
        pictures = new ShownPictures(context);
        boats = new BoatListPanel(context, pictures, settings);
        boat = new SelectedBoatPanel(context);
        gantt = new GanttPanel(context);
        map = new MapPanel(context);
        map.rememberBaseMaps(settings);
        ComponentLibrary components =
                DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow().components();
        MapMaker maps = new SessionMaps(context, map::giveBaseMaps);
        ValueEditors editors = SessionEditors.of(
                context, new ComponentChoice(components, context.vocabulary().types()), maps);
        missions = new MissionMonitor(
                context, new MissionStarter(context, settings, editors, map::preview), editors, file);
        decisions = SessionDecisions.panel(context, components, map.decisionMap(), maps, pictures);
        communication = new CommunicationPanel(context);
        asking = new DockPanel("decisions", "Decisions", "decision", decisions);
        all = panels(context);
        empty = emptiness(context.models());
        arrangement = new ArrangementChoice(
                settings,
                FIRST,
                AIMS,
                all.stream().collect(Collectors.toMap(Function.identity(), DockPanel::title)),
                boats::showPictures);
    }

    private List<DockPanel> panels(OperatorContext context) {
        return List.of(
                new DockPanel("map", "Map", "map", map).withUseOfRoom(),
                new DockPanel("missions", "Missions", "net", missions).withUseOfRoom(),
                asking,
                new DockPanel("boats", context.say("Boats"), RobotIcons.some(context.robots()), boats),
                new DockPanel("boat", context.say("Boat"), RobotIcons.one(context.robots()), boat),
                new DockPanel("messages", "Messages", "message", new MessagesPanel(context, map::pointAt, pictures)),
                new DockPanel("alarms", "Alarms", "alarm", new AlarmsPanel(context, map::pointAt)),
                new DockPanel("interrupts", "Interrupts", "interrupt", new InterruptsPanel(context)),
                new DockPanel("allocation", "Allocation", "allocation", new AllocationPanel(context)),
                new DockPanel("communication", "Communication", "link", communication),
                new DockPanel("log", "Log", "log", new LogPanel(context)),
                new DockPanel("health", "Health", "health", new HealthPanel(context, map::pointAt)),
                new DockPanel("pictures", "Pictures", "picture", new PicturesPanel(context, pictures)).withUseOfRoom(),
                new DockPanel("gantt", "Gantt", "phases", gantt).withUseOfRoom());
    }

    /** When panels have nothing in them; those that are not named here always have something. */
    private Map<DockPanel, BooleanSupplier> emptiness(OperatorModels models) {
        Map<DockPanel, BooleanSupplier> when = new HashMap<>();
        when.put(asking, () -> models.decisions().snapshot().isEmpty());
        when.put(panel("boats"), () -> isWithoutBoats(models));
        when.put(panel("boat"), () -> isWithoutBoats(models));
        when.put(panel("communication"), () -> isWithoutBoats(models));
        when.put(panel("messages"), () -> models.messages().messages().isEmpty());
        when.put(panel("alarms"), () -> models.alarms().snapshot().isEmpty());
        when.put(panel("health"), () -> models.health().snapshot().isWell());
        when.put(panel("interrupts"), () -> models.interrupts().snapshot().isEmpty());
        when.put(panel("allocation"), () -> isWithoutTasks(models.allocation().snapshot()));
        when.put(panel("pictures"), () -> models.pictures().snapshot().isEmpty());
        when.put(panel("gantt"), () -> models.gantt().snapshot().isEmpty());
        when.put(panel("log"), () -> !panel("log").isShowing()); // nobody waits for what was done
        return Map.copyOf(when);
    }

    private static boolean isWithoutBoats(OperatorModels models) {
        return models.fleet().snapshot().isEmpty()
                && models.unreached().snapshot().isEmpty();
    }

    private static boolean isWithoutTasks(AllocationSnapshot tasks) {
        return tasks.unallocated().isEmpty() && tasks.queues().values().stream().allMatch(List::isEmpty);
    }

    private DockPanel panel(String id) {
        return all.stream()
                .filter(panel -> panel.getPersistentID().equals(id))
                .findFirst()
                .orElseThrow();
    }

    /** All of them, in order. */
    public List<DockPanel> all() {
        return all;
    }

    /** How they lie in the arrangement that the operator chose last. */
    public Arrangements offered() {
        return arrangement.offered();
    }

    /** Adds the commands of the two arrangements, once the panels have theirs; the one with the robots on the left shows each with its newest picture. */
    public void addArrangements(DockArea dock, CommandRegistry commands) {
        arrangement.addTo(dock, commands);
    }

    /** Shows what changes by itself; to be called a few times a second. */
    public void refresh() {
        boats.refresh();
        boat.refresh();
        map.refresh();
        decisions.refresh();
        asking.setWaiting(decisionUnseen().isPresent());
        empty.forEach((panel, isEmpty) -> panel.setEmpty(isEmpty.getAsBoolean()));
        communication.refresh();
        gantt.refresh();
        missions.refresh();
    }

    /** What the most urgent decision asks, where one waits and the decisions lie behind another panel. */
    public Optional<String> decisionUnseen() {
        return decisions.waitingUnseen();
    }

    /** Shows the plans of the newest project. */
    public void reloadPlans() {
        missions.reloadPlans();
    }

    /** Puts the focus where the first thing is done. */
    public void focusFirst() {
        missions.focusFirst();
    }

    @Override
    public void close() {
        boat.close();
        map.close();
        pictures.close();
    }
}
