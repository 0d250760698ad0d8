package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_DELETE;
import static java.awt.event.KeyEvent.VK_DOWN;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_SPACE;

import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.JList;
import javax.swing.JTextField;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.palette.PaletteItem;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.net.NetView;

/** Draws in the net of the window that is open: palette, pointer and keys, whatever the lesson. */
final class NetGestures {
    private static final int MOST_ZOOMS = 12;
    private static final int ROW = 60; // of a plan's layout, in which a vertex has room
    private static final int SAMPLES = 24; // points of an edge that are looked at
    private static final double CROWDED = 14; // pixels between an edge and its neighbour at which a click may go astray

    private final WindowRobot robot;
    private final Supplier<DreammContext> context;

    NetGestures(WindowRobot robot, Supplier<DreammContext> context) {
        this.robot = robot;
        this.context = context;
    }

    /** The plan that is open. */
    Plan plan() {
        return WindowRobot.ask(this::planNow);
    }

    private Plan planNow() {
        return context.get().editor().plan().orElseThrow();
    }

    private NetView net() {
        return robot.find(NetView.class, net -> !"comparison-net".equals(net.getName()));
    }

    /** Waits until the plan is so. */
    void until(String what, java.util.function.Predicate<Plan> so) {
        robot.until(what, () -> context.get().editor().plan().filter(so).isPresent());
    }

    // ---- The palette

    /** Marks an item of the palette by typing its label. */
    void mark(String item, String label) {
        robot.press(VK_SPACE, VK_CONTROL);
        robot.untilFocused("palette-search");
        JTextField search = robot.find(JTextField.class, "palette-search");
        if (!WindowRobot.ask(search::getText).equals(label)) {
            robot.press(java.awt.event.KeyEvent.VK_A, VK_CONTROL);
            robot.type(label.toLowerCase(java.util.Locale.ROOT));
        }
        JList<?> list = list();
        for (int row = 0; !isMarked(list, item); row++) {
            if (row > WindowRobot.ask(() -> list.getModel().getSize())) {
                throw new AssertionError("the palette does not offer " + label + " (" + item + ")");
            }
            robot.press(VK_DOWN);
        }
    }

    private JList<?> list() {
        return robot.find(JList.class, "palette-list");
    }

    private static boolean isMarked(JList<?> list, String item) {
        return WindowRobot.ask(() -> list.getSelectedValue() instanceof PaletteItem marked
                && marked.id().equals(item));
    }

    /** Drags an item of the palette to a point of the plan; the id of the vertex that it becomes. */
    String drag(String item, String label, LayoutPoint to) {
        mark(item, label);
        Set<String> before = vertices(plan());
        JList<?> list = list();
        Rectangle cell = WindowRobot.ask(() -> list.getCellBounds(list.getSelectedIndex(), list.getSelectedIndex()));
        LayoutPoint free = free(to);
        for (int i = 0; i < MOST_ZOOMS && !areInSight(List.of(free)); i++) {
            robot.click("net-zoom-out");
        }
        robot.drag(list, new Point(cell.x + 40, cell.y + cell.height / 2), net().canvas(), pixel(free));
        until(label + " is in the net", plan -> vertices(plan).size() > before.size());
        Set<String> made = vertices(plan());
        made.removeAll(before);
        return made.iterator().next();
    }

    /** A point near another where no vertex stands. */
    private LayoutPoint free(LayoutPoint at) {
        List<LayoutPoint> taken = List.copyOf(plan().layout().values());
        for (int away = 0; ; away++) {
            for (int sign : new int[] {1, -1}) {
                LayoutPoint point = new LayoutPoint(at.x(), at.y() + sign * away * ROW);
                if (taken.stream().noneMatch(each -> Math.hypot(each.x() - point.x(), each.y() - point.y()) < ROW)) {
                    return point;
                }
            }
        }
    }

    /** Adds an item of the palette to the vertex that is selected. */
    void addToSelected(String item, String label) {
        mark(item, label);
        if (context.get().profile().shows("wizard-sequence")) {
            robot.click("wizard-sequence-alone");
        }
        Plan before = plan();
        robot.press(VK_ENTER);
        until(label + " is added", plan -> !plan.equals(before));
    }

    /** Adds a plan of the project as a sub-mission to the place that is selected. */
    void addSubMission(String item, String label) {
        mark(item, label);
        Plan before = plan();
        robot.press(VK_ENTER);
        until(label + " is added", plan -> !plan.equals(before));
    }

    static Set<String> vertices(Plan plan) {
        Set<String> ids = new LinkedHashSet<>();
        plan.places().forEach(place -> ids.add(place.id()));
        plan.transitions().forEach(transition -> ids.add(transition.id()));
        return ids;
    }

    // ---- Where things are

    /** Zooms out until points of the plan can be seen. */
    void show(List<LayoutPoint> points) {
        if (context.get().profile().shows("net-mode-all")) {
            robot.click("net-mode-all"); // recovery parts are not seen otherwise
        }
        robot.click("net-fit");
        for (int i = 0; i < MOST_ZOOMS && !areInSight(points); i++) {
            robot.click("net-zoom-out");
        }
    }

    private boolean areInSight(List<LayoutPoint> points) {
        Rectangle room = WindowRobot.ask(() -> net().canvas().getVisibleRect());
        room.grow(-30, -30);
        return points.stream().map(this::pixel).allMatch(room::contains);
    }

    private Point pixel(LayoutPoint at) {
        NetView net = net();
        return WindowRobot.still(() -> {
            double scale = net.drawing().scale();
            return point(net.pixel(at.x() * scale, at.y() * scale));
        });
    }

    private static Point point(Point2D at) {
        return new Point((int) Math.round(at.getX()), (int) Math.round(at.getY()));
    }

    private Optional<Vertex> drawn(String vertex) {
        return net().drawing().vertices().stream()
                .filter(each -> each.id().equals(vertex))
                .findFirst();
    }

    private Point middle(String vertex) {
        NetView net = net();
        robot.until(vertex + " is drawn", () -> drawn(vertex).isPresent());
        return WindowRobot.still(() -> {
            Vertex there = drawn(vertex).orElseThrow();
            return point(net.pixel(there.centre().x(), there.centre().y()));
        });
    }

    // ---- Gestures

    /** Selects a vertex by a click. */
    void click(String vertex) {
        if (isSelected(vertex)) {
            return;
        }
        Point at = middle(vertex);
        robot.clickAt(net().canvas(), at.x, at.y);
        robot.until(vertex + " is selected", () -> isSelectedNow(vertex));
    }

    private boolean isSelected(String element) {
        return WindowRobot.ask(() -> isSelectedNow(element));
    }

    private boolean isSelectedNow(String element) {
        return context.get().editor().selection().equals(Set.of(element));
    }

    /** Draws an edge from a vertex's handle; its id. */
    String connect(String from, String to) {
        click(from);
        NetView net = net();
        Point over = middle(from);
        robot.moveTo(net.canvas(), over.x, over.y); // the handle is there while the pointer is near
        Set<String> before = edges(plan());
        Point handle = WindowRobot.still(() -> {
            Vertex there = drawn(from).orElseThrow();
            Point right = point(net.pixel(there.box().maxX(), there.centre().y()));
            return new Point(right.x + 15, right.y - 12);
        });
        robot.draw(net.canvas(), handle, middle(to));
        until("an edge leads from " + from + " to " + to, plan -> edges(plan).size() == before.size() + 1);
        Set<String> made = edges(plan());
        made.removeAll(before);
        String edge = made.iterator().next();
        robot.until("the edge is selected", () -> isSelectedNow(edge));
        return edge;
    }

    static Set<String> edges(Plan plan) {
        Set<String> ids = new LinkedHashSet<>();
        plan.inEdges().forEach(edge -> ids.add(edge.id()));
        plan.outEdges().forEach(edge -> ids.add(edge.id()));
        return ids;
    }

    /** Selects an edge by a click where nothing else is near. */
    void clickEdge(String edge) {
        if (isSelected(edge)) {
            return;
        }
        robot.until(
                edge + " is drawn",
                () -> net().drawing().edges().stream()
                        .anyMatch(each -> each.id().equals(edge)));
        List<Point> clear = WindowRobot.still(() -> clearPoints(edge));
        for (Point at : clear) {
            robot.clickAt(net().canvas(), at.x, at.y);
            if (isSelected(edge)) {
                return;
            }
        }
        throw new AssertionError("no point of the edge " + edge + " can be clicked");
    }

    /** Points on an edge, those first that lie farthest from all else. */
    private List<Point> clearPoints(String edge) {
        NetView net = net();
        List<Spot> spots = new ArrayList<>();
        for (Edge each : net.drawing().edges()) {
            if (each.id().equals(edge)) {
                for (int line = 0; line + 1 < each.points().size(); line++) {
                    for (int i = 1; i < SAMPLES; i++) {
                        Point2D at =
                                between(each.points().get(line), each.points().get(line + 1), i);
                        spots.add(new Spot(
                                point(net.pixel(at.getX(), at.getY())), Math.min(CROWDED, room(net, edge, at))));
                    }
                }
            }
        }
        spots.sort((a, b) -> Double.compare(b.room(), a.room()));
        return spots.stream()
                .map(Spot::at)
                .filter(at -> net.canvas().getVisibleRect().contains(at))
                .limit(4)
                .toList();
    }

    private record Spot(Point at, double room) {}

    private static Point2D between(LayoutPoint a, LayoutPoint b, int i) {
        double part = i / (double) SAMPLES;
        return new Point2D.Double(a.x() + (b.x() - a.x()) * part, a.y() + (b.y() - a.y()) * part);
    }

    /** How far the nearest other element is from a point, in pixels. */
    private static double room(NetView net, String edge, Point2D at) {
        double nearest = Double.MAX_VALUE;
        for (Edge other : net.drawing().edges()) {
            for (int line = 0;
                    !other.id().equals(edge) && line + 1 < other.points().size();
                    line++) {
                LayoutPoint a = other.points().get(line);
                LayoutPoint b = other.points().get(line + 1);
                nearest = Math.min(nearest, Line2D.ptSegDist(a.x(), a.y(), b.x(), b.y(), at.getX(), at.getY()));
            }
        }
        for (Vertex vertex : net.drawing().vertices()) {
            Rectangle box = new Rectangle(
                    (int) vertex.box().x(),
                    (int) vertex.box().y(),
                    (int) vertex.box().width(),
                    (int) vertex.box().height());
            double dx = Math.max(0, Math.max(box.x - at.getX(), at.getX() - box.getMaxX()));
            double dy = Math.max(0, Math.max(box.y - at.getY(), at.getY() - box.getMaxY()));
            nearest = Math.min(nearest, Math.hypot(dx, dy));
        }
        return nearest * net.zoom();
    }

    /** Deletes what is selected. */
    void delete(String element) {
        robot.press(VK_DELETE);
        until(
                element + " is gone",
                plan -> !vertices(plan).contains(element) && !edges(plan).contains(element));
    }

    /** Whether a component stands in one of a name. */
    static boolean isIn(String name, Component component) {
        for (Container at = component.getParent(); at != null; at = at.getParent()) {
            if (name.equals(at.getName())) {
                return true;
            }
        }
        return false;
    }
}
