package org.sami.dreamm;

import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.KeyEvent;
import java.awt.geom.Point2D;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import javax.swing.JCheckBox;
import javax.swing.JFileChooser;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.start.DreammOptions;
import org.sami.dreamm.start.FirstProject;
import org.sami.dreamm.window.DreammWindow;
import org.sami.palette.Theme;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.net.NetView;

/** An author at the real window: works by pointer and keys alone, and looks at what came of it. */
final class AuthorRobot implements AutoCloseable {
    final WindowRobot robot = new WindowRobot();

    private final DreammWindow window;
    private final CompletableFuture<Integer> ended;

    private AuthorRobot(DreammWindow window, CompletableFuture<Integer> ended) {
        this.window = window;
        this.ended = ended;
    }

    /** Opens a window; the test is skipped where there is no display. */
    static AuthorRobot open(Path data, Optional<String> open, Optional<Path> domain, Profile profile)
            throws IOException {
        RealDisplay.assumed();
        DreammOptions options = new DreammOptions(open, domain, profile, Optional.of(Theme.LIGHT), Optional.of(100));
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        AuthorDirectory known = AuthorDirectory.open(data);
        Files.writeString(known.settings(), ""); // who has worked here before is offered no course
        AuthorRobot author =
                new AuthorRobot(DreammStart.open(options, FirstProject.open(options), known, ended::complete), ended);
        author.robot.untilShown("model-view");
        return author;
    }

    DreammWindow window() {
        return window;
    }

    ProjectDocument document() {
        return window.context().document();
    }

    /** The plan that is open now. */
    Plan plan() {
        return WindowRobot.ask(() -> window.context().editor().plan().orElseThrow());
    }

    /** The project as a file would say it now. */
    String text() {
        return WindowRobot.ask(
                () -> new ProjectWriter(document().vocabulary()).text(document().project()));
    }

    /** What a file says. */
    Project read(Path file) {
        return new ProjectReader(document().vocabulary()).read(file).orThrow();
    }

    // ---- Looking

    /** The place with an output event of a type. */
    String place(String event) {
        return placeWhere(
                event, p -> p.outputs().stream().anyMatch(o -> o.type().equals(event)));
    }

    /** The place of a name. */
    String named(String name) {
        return placeWhere("the name " + name, p -> p.name().equals(name));
    }

    /** The transition with an input event of a type. */
    String transition(String event) {
        return plan().transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(event)))
                .map(Transition::id)
                .findFirst()
                .orElseThrow(() -> new AssertionError("no transition takes " + event));
    }

    /** The place to which the transition with an input event leads. */
    String behind(String event) {
        String transition = transition(event);
        return plan().outEdges().stream()
                .filter(e -> e.transition().equals(transition))
                .map(e -> e.place())
                .findFirst()
                .orElseThrow(() -> new AssertionError("nothing stands behind " + event));
    }

    private String placeWhere(String what, Predicate<Place> so) {
        return plan().places().stream()
                .filter(so)
                .map(Place::id)
                .findFirst()
                .orElseThrow(() -> new AssertionError("no place has " + what));
    }

    // ---- The net

    NetView net() {
        return robot.find(NetView.class, net -> !"comparison-net".equals(net.getName()));
    }

    /** Where the middle of a vertex is in the net's canvas. */
    Point at(String vertex) {
        NetView net = net();
        untilDrawn(net, vertex);
        return WindowRobot.still(() -> {
            Vertex drawn = drawn(net, vertex).orElseThrow();
            return point(net.pixel(drawn.centre().x(), drawn.centre().y()));
        });
    }

    /** From where an edge is drawn that begins at a vertex, once the pointer is over it. */
    Point handle(String vertex) {
        NetView net = net();
        untilDrawn(net, vertex);
        return WindowRobot.still(() -> {
            Vertex drawn = drawn(net, vertex).orElseThrow();
            Point right = point(net.pixel(drawn.box().maxX(), drawn.centre().y()));
            return new Point(right.x + 15, right.y - 12);
        });
    }

    /** The net is drawn after its plan has changed, and lies elsewhere when it is shown again. */
    private void untilDrawn(NetView net, String vertex) {
        robot.until(vertex + " is drawn", () -> drawn(net, vertex).isPresent());
    }

    private static Optional<Vertex> drawn(NetView net, String vertex) {
        return net.drawing().vertices().stream()
                .filter(v -> v.id().equals(vertex))
                .findFirst();
    }

    private static Point point(Point2D at) {
        return new Point((int) Math.round(at.getX()), (int) Math.round(at.getY()));
    }

    /** Shows the whole net. */
    void showAll() {
        robot.click("net-fit");
    }

    /** Clicks a vertex. */
    void click(String vertex) {
        Point at = at(vertex);
        robot.clickAt(net().canvas(), at.x, at.y);
        robot.until(
                vertex + " is selected",
                () -> window.context().editor().selection().equals(Set.of(vertex)));
    }

    /** Drags a vertex by so many pixels. */
    void move(String vertex, int dx, int dy) {
        Point from = at(vertex);
        LayoutPoint before = plan().layout().get(vertex);
        robot.draw(net().canvas(), from, new Point(from.x + dx, from.y + dy));
        robot.until(
                vertex + " lies elsewhere",
                () -> !before.equals(
                        window.context().editor().plan().orElseThrow().layout().get(vertex)));
    }

    /** Draws an edge from a vertex's handle to another. */
    void connect(String from, String to) {
        click(from);
        int edges = plan().inEdges().size() + plan().outEdges().size();
        robot.draw(net().canvas(), handle(from), at(to));
        robot.until("an edge leads from " + from + " to " + to, () -> {
            Plan now = window.context().editor().plan().orElseThrow();
            return now.inEdges().size() + now.outEdges().size() == edges + 1;
        });
    }

    /** Where an edge is seen best: the middle of its longest line. */
    Point onEdge(String from, String to) {
        NetView net = net();
        untilDrawn(net, from);
        untilDrawn(net, to);
        return WindowRobot.still(() -> {
            List<LayoutPoint> points = net.drawing().edges().stream()
                    .filter(e -> e.from().equals(from) && e.to().equals(to))
                    .findFirst()
                    .orElseThrow()
                    .points();
            int longest = 0;
            for (int i = 1; i < points.size() - 1; i++) {
                longest = length(points, i) > length(points, longest) ? i : longest;
            }
            LayoutPoint a = points.get(longest);
            LayoutPoint b = points.get(longest + 1);
            return point(net.pixel((a.x() + b.x()) / 2, (a.y() + b.y()) / 2));
        });
    }

    /** Clicks an edge. */
    void clickEdge(String from, String to) {
        Point at = onEdge(from, to);
        robot.clickAt(net().canvas(), at.x, at.y);
        robot.until("the edge is selected", () -> {
            Plan now = window.context().editor().plan().orElseThrow();
            Set<String> selected = window.context().editor().selection();
            return now.outEdges().stream()
                            .anyMatch(e -> e.transition().equals(from)
                                    && e.place().equals(to)
                                    && selected.equals(Set.of(e.id())))
                    || now.inEdges().stream()
                            .anyMatch(e -> e.place().equals(from)
                                    && e.transition().equals(to)
                                    && selected.equals(Set.of(e.id())));
        });
    }

    private static double length(List<LayoutPoint> points, int i) {
        return Math.hypot(
                points.get(i + 1).x() - points.get(i).x(),
                points.get(i + 1).y() - points.get(i).y());
    }

    // ---- Palette and inspector

    /** Adds what the palette finds by some words to what is selected, and shows all of the net. */
    void add(String words, String label) {
        mark(words, label);
        addMarked(label);
    }

    private void addMarked(String label) {
        String before = text();
        robot.press(KeyEvent.VK_ENTER);
        robot.until(
                label + " is added",
                () -> !before.equals(new ProjectWriter(document().vocabulary())
                        .text(document().project())));
        showAll();
    }

    /** The same with another sequence than the one that is offered first. */
    void add(String words, String label, String sequence) {
        mark(words, label);
        robot.click("wizard-sequence-" + sequence);
        addMarked(label);
    }

    /** Adds something to the place behind an answer. */
    void addBehind(String answer, String words, String label) {
        click(behind(answer));
        add(words, label);
    }

    /** The same with another sequence. */
    void addBehind(String answer, String words, String label, String sequence) {
        click(behind(answer));
        add(words, label, sequence);
    }

    /** Lets a pattern show what it would draw on what is selected, and draws it. */
    void pattern(int key) {
        robot.press(key, KeyEvent.VK_ALT, KeyEvent.VK_SHIFT);
        robot.untilShown("pattern-draw");
        String before = text();
        robot.click("pattern-draw");
        robot.until(
                "the pattern is drawn",
                () -> !before.equals(new ProjectWriter(document().vocabulary())
                        .text(document().project())));
        showAll();
    }

    /** Lets an answer lead elsewhere than to the place that came with it. */
    void lead(String answer, String place, int dx, int dy) {
        String from = transition(answer);
        click(behind(answer));
        robot.press(KeyEvent.VK_DELETE);
        robot.until(
                "the place is gone",
                () -> window.context()
                        .editor()
                        .plan()
                        .orElseThrow()
                        .outEdgesOf(from)
                        .isEmpty());
        move(from, dx, dy); // its edge would lie on others
        connect(from, place);
        robot.click("inspector-propose-requirement-0");
        robot.until(
                "the edge asks for something",
                () -> !window.context()
                        .editor()
                        .plan()
                        .orElseThrow()
                        .outEdgesOf(from)
                        .get(0)
                        .requirements()
                        .isEmpty());
    }

    /** Finds an item of the palette by typing. */
    void mark(String words, String label) {
        robot.press(KeyEvent.VK_SPACE, KeyEvent.VK_CONTROL);
        robot.untilFocused("palette-search");
        type(robot.find(JTextField.class, "palette-search"), words);
        robot.untilSaid("wizard-title", label);
    }

    /** Types over what stands in a field, again where the display repeated a key because the machine stood still while it was down. */
    private void type(JTextField field, String words) {
        do {
            robot.press(KeyEvent.VK_A, KeyEvent.VK_CONTROL);
            robot.type(words);
        } while (repeats(WindowRobot.ask(field::getText), words));
    }

    private static boolean repeats(String typed, String words) {
        return !typed.equals(words) && typed.replaceAll("(.)\\1+", "$1").equals(words.replaceAll("(.)\\1+", "$1"));
    }

    /** Where the marked item of the palette stands in its list. */
    Point marked() {
        JList<?> list = palette();
        return WindowRobot.ask(() -> {
            var cell = list.getCellBounds(list.getSelectedIndex(), list.getSelectedIndex());
            return new Point(cell.x + 40, cell.y + cell.height / 2);
        });
    }

    JList<?> palette() {
        return robot.find(JList.class, list -> "palette-list".equals(list.getName()));
    }

    /** Drags the item that some words find to a point of the net; says whether the net took it. */
    boolean drag(String words, String label, Point to) {
        mark(words, label);
        return robot.drag(palette(), marked(), net().canvas(), to);
    }

    /** Ticks a box of the inspector, or takes the tick away. */
    void tick(String name) {
        JCheckBox box = robot.find(JCheckBox.class, name);
        robot.scrollTo(box);
        boolean before = WindowRobot.ask(box::isSelected);
        robot.click(name);
        robot.find(JCheckBox.class, now -> name.equals(now.getName()) && now.isSelected() != before);
    }

    /** Writes something into a field, and Enter. */
    void write(String name, String words) {
        JTextField field = robot.find(JTextField.class, name);
        robot.scrollTo(field);
        robot.click(name);
        robot.untilFocused(name);
        type(field, words);
        robot.press(KeyEvent.VK_ENTER);
    }

    /** Shows the tab that holds a view. */
    void tab(String view) {
        JTabbedPane tabs = robot.find(JTabbedPane.class, "try-tabs");
        Rectangle tab = WindowRobot.ask(() -> {
            for (int i = 0; i < tabs.getTabCount(); i++) {
                if (view.equals(tabs.getComponentAt(i).getName())) {
                    return tabs.getBoundsAt(i);
                }
            }
            throw new AssertionError("there is no tab " + view);
        });
        robot.clickAt(tabs, tab.x + tab.width / 2, tab.y + tab.height / 2);
        robot.untilShown(view);
    }

    // ---- Files

    /** Gives a path to the dialog of files that is open. */
    void giveFile(Path file) {
        JTextField name = robot.find(
                JTextField.class,
                field -> SwingUtilities.getAncestorOfClass(JFileChooser.class, field) != null && field.isEditable());
        int middle = WindowRobot.ask(name::getHeight) / 2;
        robot.clickAt(name, middle, middle);
        robot.until("the name is being written", name::isFocusOwner);
        robot.press(KeyEvent.VK_A, KeyEvent.VK_CONTROL);
        robot.type(file.toString());
        robot.press(KeyEvent.VK_ENTER);
    }

    @Override
    public void close() throws Exception {
        WindowRobot.ask(() -> {
            window.end();
            return null;
        });
        ended.get(300, TimeUnit.SECONDS);
    }
}
