package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_1;
import static java.awt.event.KeyEvent.VK_ALT;

import java.awt.Rectangle;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JTree;
import org.sami.dreamm.context.DreammContext;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.wizard.PaletteIds;
import org.sami.ui.check.WindowRobot;

/**
 * Does a job as a learner does it: draws what its solution has and the plan that is open has not, by palette, pointer, keys and inspector alone.
 * What the course does not need for a plan to be right, such as names that the job does not give and recovery mode, is left out.
 */
final class JobGestures {
    private final WindowRobot robot;
    private final Supplier<DreammContext> context;
    private final NetGestures net;
    private final InspectorGestures inspector;
    private final String words;

    /** The ids of the solution's vertices and events, and the names of its variables, in the window's plan. */
    private final Map<String, String> mine = new HashMap<>();

    /**
     * A hand for one job.
     *
     * @param words all that the job's file says: names that it does not say need not be given
     */
    JobGestures(WindowRobot robot, Supplier<DreammContext> context, String words) {
        this.robot = robot;
        this.context = context;
        this.words = words;
        net = new NetGestures(robot, context);
        inspector = new InspectorGestures(robot);
    }

    /** Draws the solution. */
    void draw(Project solution) {
        String first = net.plan().id();
        for (Plan wanted : solution.plans()) {
            Plan there = WindowRobot.ask(
                    () -> context.get().document().project().plan(wanted.id()).orElseThrow());
            if (!alike(there, wanted)) {
                open(wanted);
                mine.clear();
                draw(wanted);
            }
        }
        open(solution.plan(first).orElseThrow());
    }

    private static boolean alike(Plan there, Plan wanted) {
        return there.places().equals(wanted.places())
                && there.transitions().equals(wanted.transitions())
                && there.inEdges().equals(wanted.inEdges())
                && there.outEdges().equals(wanted.outEdges());
    }

    private void open(Plan plan) {
        if (net.plan().id().equals(plan.id())) {
            return;
        }
        robot.press(VK_1, VK_ALT); // the mission tree may be behind the palette
        JTree tree = robot.find(JTree.class, "mission-tree-lines");
        int row = WindowRobot.ask(() -> {
            for (int i = 0; i < tree.getRowCount(); i++) {
                String line = tree.getPathForRow(i).getLastPathComponent().toString();
                if (line.startsWith("TreeItem[kind=PLAN, plan=" + plan.id() + ",")) {
                    return i;
                }
            }
            throw new AssertionError("the mission tree has no line " + plan.title());
        });
        Rectangle bounds = WindowRobot.ask(() -> tree.getRowBounds(row));
        robot.clickAt(tree, bounds.x + 30, bounds.y + bounds.height / 2);
        net.until(plan.title() + " is open", open -> open.id().equals(plan.id()));
    }

    private void draw(Plan wanted) {
        remember(net.plan(), wanted);
        remove(wanted);
        net.show(points(wanted));
        wanted.places().forEach(place -> vertex(wanted, place));
        wanted.transitions().forEach(transition -> vertex(wanted, transition));
        robot.click("net-fit");
        wanted.inEdges().forEach(this::edge);
        wanted.outEdges().forEach(this::edge);
        wanted.inEdges().forEach(this::require);
        wanted.outEdges().forEach(this::require);
        EventGestures events = new EventGestures(robot, context, net, inspector, mine);
        wanted.transitions().forEach(events::write);
        wanted.places().forEach(events::fill);
    }

    private static List<LayoutPoint> points(Plan plan) {
        return NetGestures.vertices(plan).stream()
                .flatMap(id -> Optional.ofNullable(plan.layout().get(id)).stream())
                .toList();
    }

    /** What stands in both under the same id is the same. */
    private void remember(Plan there, Plan wanted) {
        Stream.concat(NetGestures.vertices(wanted).stream(), events(wanted))
                .filter(id -> NetGestures.vertices(there).contains(id)
                        || events(there).anyMatch(id::equals))
                .forEach(id -> mine.put(id, id));
        there.variables().forEach(variable -> mine.put(variable.name(), variable.name()));
    }

    private static Stream<String> events(Plan plan) {
        return Stream.concat(
                plan.places().stream()
                        .flatMap(place -> Stream.concat(
                                place.outputs().stream().map(OutputEventSpec::id),
                                place.subMissions().stream().map(SubMissionSpec::id))),
                plan.transitions().stream()
                        .flatMap(transition -> transition.inputs().stream().map(InputEventSpec::id)));
    }

    private void remove(Plan wanted) {
        for (String edge : NetGestures.edges(net.plan())) {
            if (!NetGestures.edges(wanted).contains(edge)) {
                net.clickEdge(edge);
                net.delete(edge);
            }
        }
        for (String vertex : NetGestures.vertices(net.plan())) {
            if (!NetGestures.vertices(wanted).contains(vertex)) {
                net.click(vertex);
                net.delete(vertex);
            }
        }
    }

    private String mine(String id) {
        return Optional.ofNullable(mine.get(id)).orElseThrow(() -> new AssertionError(id + " is not drawn yet"));
    }

    // ---- Vertices

    private void vertex(Plan plan, Place place) {
        List<String> types = place.outputs().stream().map(OutputEventSpec::type).toList();
        drag(plan, place.id(), PaletteIds.BLANK_PLACE, "Blank place", types);
        name(place.id(), place.name());
        for (OutputEventSpec event : place.outputs()) {
            event(place.id(), event.id(), event.type());
        }
        for (SubMissionSpec sub : place.subMissions()) {
            subMission(place.id(), sub);
        }
        Place there = net.plan().place(mine(place.id())).orElseThrow();
        if (place.start() && !there.start()) {
            net.click(there.id());
            inspector.tick("inspector-start");
            net.until(
                    "it is the start",
                    now -> now.place(there.id()).orElseThrow().start());
        }
        if (place.end() != there.end()) {
            net.click(there.id());
            inspector.tick("inspector-end");
            net.until("it is an end", now -> now.place(there.id()).orElseThrow().end() == place.end());
        }
    }

    private void vertex(Plan plan, Transition transition) {
        List<String> types =
                transition.inputs().stream().map(InputEventSpec::type).toList();
        drag(plan, transition.id(), PaletteIds.BLANK_TRANSITION, "Blank transition", types);
        name(transition.id(), transition.name());
        for (InputEventSpec event : transition.inputs()) {
            event(transition.id(), event.id(), event.type());
        }
    }

    /** Drags a new vertex out of the palette: with its event where events come alone. */
    private void drag(Plan plan, String id, String blank, String label, List<String> events) {
        if (mine.containsKey(id)) {
            return;
        }
        LayoutPoint at = Optional.ofNullable(plan.layout().get(id)).orElseThrow();
        boolean alone = !context.get().profile().shows("wizard-sequence");
        if (alone && !events.isEmpty()) {
            EventType type = type(events.get(0));
            mine.put(id, net.drag(PaletteIds.event(type), type.label(), at));
        } else {
            mine.put(id, net.drag(blank, label, at));
        }
    }

    private EventType type(String name) {
        return context.get()
                .vocabulary()
                .event(name)
                .orElseThrow(() -> new AssertionError("the lesson does not have the event " + name));
    }

    private void name(String id, String name) {
        String there = nameOf(mine(id));
        if (!name.equals(there) && words.contains("name:" + name)) {
            net.click(mine(id));
            inspector.name(name);
            robot.until("it is called " + name, () -> nameNow(mine(id)).equals(name));
        }
    }

    private String nameOf(String vertex) {
        return WindowRobot.ask(() -> nameNow(vertex));
    }

    private String nameNow(String vertex) {
        Plan plan = context.get().editor().plan().orElseThrow();
        return plan.place(vertex)
                .map(Place::name)
                .orElseGet(() -> plan.transition(vertex).orElseThrow().name());
    }

    private void event(String vertex, String id, String type) {
        if (mine.containsKey(id)) {
            return;
        }
        Map<String, String> there = EventGestures.eventsOf(net.plan(), mine(vertex));
        Optional<String> came = there.entrySet().stream()
                .filter(each -> each.getValue().equals(type) && !mine.containsValue(each.getKey()))
                .map(Map.Entry::getKey)
                .findFirst();
        if (came.isEmpty()) {
            net.click(mine(vertex));
            EventType of = type(type);
            net.addToSelected(PaletteIds.event(of), of.label());
            Map<String, String> now = EventGestures.eventsOf(net.plan(), mine(vertex));
            now.keySet().removeAll(there.keySet());
            came = now.keySet().stream().findFirst();
        }
        mine.put(id, came.orElseThrow());
    }

    private void subMission(String vertex, SubMissionSpec sub) {
        if (mine.containsKey(sub.id())) {
            return;
        }
        net.click(mine(vertex));
        String label = context.get().document().plan(sub.plan()).orElseThrow().title();
        net.addSubMission(PaletteIds.subMission(sub.plan()), label);
        mine.put(sub.id(), sub.id());
    }

    // ---- Edges

    private Optional<InEdge> there(InEdge wanted) {
        return net.plan().inEdges().stream()
                .filter(each -> each.place().equals(mine(wanted.place()))
                        && each.transition().equals(mine(wanted.transition())))
                .findFirst();
    }

    private Optional<OutEdge> there(OutEdge wanted) {
        return net.plan().outEdges().stream()
                .filter(each -> each.place().equals(mine(wanted.place()))
                        && each.transition().equals(mine(wanted.transition())))
                .findFirst();
    }

    private void edge(InEdge wanted) {
        if (there(wanted).isEmpty()) {
            net.connect(mine(wanted.place()), mine(wanted.transition()));
            require(wanted);
        }
    }

    private void edge(OutEdge wanted) {
        if (there(wanted).isEmpty()) {
            net.connect(mine(wanted.transition()), mine(wanted.place()));
            require(wanted);
        }
    }

    private boolean hasRequirements() {
        return context.get().profile().shows("inspector-edge");
    }

    private void require(InEdge wanted) {
        InEdge edge = there(wanted).orElseThrow();
        if (hasRequirements() && !same(edge.requirements(), wanted.requirements())) {
            net.clickEdge(edge.id());
            inspector.requireIn(
                    wanted.requirements(), () -> there(wanted).orElseThrow().requirements());
        }
    }

    private void require(OutEdge wanted) {
        OutEdge edge = there(wanted).orElseThrow();
        if (hasRequirements() && !same(edge.requirements(), wanted.requirements())) {
            net.clickEdge(edge.id());
            inspector.requireOut(
                    wanted.requirements(), () -> there(wanted).orElseThrow().requirements());
        }
    }

    private static <R> boolean same(List<R> there, List<R> wanted) {
        return there.size() == wanted.size() && there.containsAll(wanted);
    }
}
