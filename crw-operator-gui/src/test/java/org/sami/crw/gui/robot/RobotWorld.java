package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_DELETE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JFileChooser;
import javax.swing.JLabel;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.JTextField;
import javax.swing.SwingUtilities;
import javax.swing.text.JTextComponent;
import org.sami.boat.link.BoatMode;
import org.sami.boat.server.testing.Await;
import org.sami.crw.gui.LoopbackFleet;
import org.sami.crw.gui.OpenedWindow;
import org.sami.crw.gui.SessionWorld;
import org.sami.crw.operator.alarm.Alarm;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.crw.operator.health.HealthEntry;
import org.sami.crw.operator.health.HealthKind;
import org.sami.crw.operator.mission.MissionSnapshot;
import org.sami.crw.session.Session;
import org.sami.crw.session.SessionRuntime;
import org.sami.spn.protocol.Answer;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.ui.check.Layout;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.sheet.WindowSheet;

/** The window that a robot run is about: does rows, looks at what must always hold after each, and tidies up. */
final class RobotWorld implements AutoCloseable {
    /** The boats of the built-in fleet. */
    static final List<String> BUILT_IN = List.of("anna", "bert", "carl", "dora", "emil");

    private static final int WITHIN_S = 300;

    final WindowRobot robot = new WindowRobot();
    final Path folder;
    private final ErrorWatch errors;
    private final OpenedWindow opened;
    private final FixedControls controls;
    private final List<String> boats;
    private Optional<LoopbackFleet> fleet = Optional.empty();

    /**
     * A world.
     *
     * @param errors is closed with it
     * @param boats that are linked while nothing is wrong
     * @param folder of the rows' files
     */
    RobotWorld(ErrorWatch errors, OpenedWindow opened, List<String> boats, Path folder) {
        this.errors = errors;
        this.opened = opened;
        this.boats = List.copyOf(boats);
        this.folder = folder;
        controls = new FixedControls(opened.window().frame());
        robot.untilSaid("boats-count", boats.size() + " of " + boats.size());
    }

    /** A world with the built-in fleet, and all plans. */
    static RobotWorld withBuiltInFleet(Path folder) throws Exception {
        ErrorWatch errors = new ErrorWatch(); // before the first log is written
        Path project = OpenedWindow.writeBeachWithLibrary(folder.resolve("beach.json"));
        return new RobotWorld(
                errors,
                OpenedWindow.open(List.of(), Optional.of(project), false, folder.resolve("data")),
                BUILT_IN,
                folder);
    }

    /** A world with boats behind loopback sockets of their own, each of which can be ended. */
    static RobotWorld withLoopbackFleet(List<String> boats, boolean resume, Path folder) throws Exception {
        ErrorWatch errors = new ErrorWatch();
        LoopbackFleet fleet = new LoopbackFleet(boats);
        Path project = OpenedWindow.writeBeachWithLibrary(folder.resolve("beach.json"));
        RobotWorld world = new RobotWorld(
                errors,
                OpenedWindow.open(fleet.addresses(), Optional.of(project), resume, folder.resolve("data")),
                boats,
                folder);
        world.fleet = Optional.of(fleet);
        return world;
    }

    /** The boats behind loopback sockets. */
    LoopbackFleet fleet() {
        return fleet.orElseThrow();
    }

    /** Does a row and looks at all that must hold after each. */
    void go(RobotRow row) throws Exception {
        int traces = errors.traces().size();
        Map<String, Rectangle> before = controls.places();
        try {
            row.act().on(this);
            assertThat(errors.traces().stream().skip(traces)).as("stack traces").isEmpty();
            assertThat(controls.underTheStop())
                    .as("under the pointer on the fleet stop")
                    .isEqualTo("fleet-stop");
            Map<String, Rectangle> after = new TreeMap<>(controls.places());
            after.keySet().retainAll(before.keySet());
            Map<String, Rectangle> same = new TreeMap<>(before);
            same.keySet().retainAll(after.keySet());
            assertThat(after).as("where controls lie").isEqualTo(same);
            assertThat(faults(HealthKind.ENGINE, HealthKind.THREAD, HealthKind.MEMORY))
                    .isEmpty();
            String answered = get(session().ask(view -> view.project().id()));
            assertThat(answered).as("what the engine answers").isNotEmpty();
        } finally {
            tidy();
        }
    }

    /** Ends what a row has begun: sheets, missions, stops, values in force. */
    private void tidy() throws Exception {
        onEventThread(() -> {
            WindowSheet.in(opened.window().frame().getRootPane()).close();
            return null;
        });
        get(session().abortAll());
        says("missions-count", "0 missions");
        says("decisions-count", "nothing waits");
        robot.untilShown("decisions-empty"); // until then a click would go to the question that is over
        get(session().fleet().releaseAll());
        for (String boat : boats) {
            get(session().byHand().giveBack(boat));
        }
        run("panel-missions");
        onEventThread(() -> {
            Layout.find(opened.window().frame(), "mission-tabs", JTabbedPane.class)
                    .ifPresent(tabs -> tabs.setSelectedIndex(0));
            Layout.find(opened.window().frame(), "boats-table", JTable.class).ifPresent(JTable::clearSelection);
            return null;
        });
        Await.until("boats are released", () -> boats().stream().noneMatch(RobotWorld::isStopped));
    }

    // ---- what there is

    OpenedWindow opened() {
        return opened;
    }

    Session session() {
        return opened.window().session();
    }

    List<BoatSnapshot> boats() {
        return session().models().fleet().snapshot();
    }

    BoatSnapshot boat(String name) {
        return session().models().fleet().boat(name).orElseThrow();
    }

    boolean allStopped() {
        return boats().stream().filter(boat -> boats.contains(boat.boat())).allMatch(RobotWorld::isStopped);
    }

    static boolean isStopped(BoatSnapshot boat) {
        return boat.mode().filter(BoatMode.FLEET_STOP::equals).isPresent();
    }

    List<MissionSnapshot> running() {
        return session().models().missions().snapshot().running();
    }

    List<PendingDecision> decisions() {
        return session().models().decisions().snapshot();
    }

    List<HealthEntry> faults(HealthKind... kinds) {
        return Stream.of(kinds)
                .flatMap(kind -> session().models().health().snapshot().of(kind).stream())
                .toList();
    }

    static <T> T get(CompletionStage<T> stage) throws Exception {
        return stage.toCompletableFuture().get(WITHIN_S, TimeUnit.SECONDS);
    }

    /** The alarm of a kind about a boat, active or over. */
    Optional<Alarm> alarm(Alarm.Kind kind, String boat) {
        return session().models().alarms().snapshot().stream()
                .filter(one -> one.kind() == kind && one.boat().equals(boat))
                .findFirst();
    }

    /** Waits until the window's list of faults, or of alarms that are over, says something. */
    void warned(String part) {
        until(
                "a fault or alarm says '" + part + "'",
                () -> Stream.concat(
                                session().models().health().snapshot().entries().stream()
                                        .map(entry -> entry.fault().text()),
                                session().models().alarms().snapshot().stream().map(Alarm::text))
                        .anyMatch(text -> text.contains(part)));
    }

    /** What the list of boats says, a row a line. */
    String boatRows() {
        return SessionWorld.rows(opened.window().frame(), "boats-table");
    }

    /** The name under which the session commands boats. */
    String clientId() {
        return ((SessionRuntime.RealTime) session().setup().runtime())
                .links()
                .proxy()
                .clientId();
    }

    // ---- what is done

    /** Runs a command as its key would. */
    void run(String command) {
        onEventThread(() -> {
            opened.window().commands().get(command).run();
            return null;
        });
    }

    /** Starts a mission, and waits until it asks. */
    long start(String plan) throws Exception {
        long mission = get(session().start(plan, plan, Map.of()));
        untilAsked(mission);
        return mission;
    }

    /** Waits until a mission asks; gives its question. */
    PendingDecision untilAsked(long mission) {
        until("mission " + mission + " asks", () -> asked(mission).isPresent());
        return asked(mission).orElseThrow();
    }

    private Optional<PendingDecision> asked(long mission) {
        return decisions().stream()
                .filter(one -> one.decision().mission() == mission)
                .findFirst();
    }

    /** Has the first boats explore a small area, and waits until they are under way and the mission's buttons can be pressed. */
    long explore(int team) throws Exception {
        long mission = start("explore-team");
        PendingDecision area = asked(mission).orElseThrow();
        get(session().answer(area.decision().id(), new Answer.Fields(Map.of("area", SMALL)), "robot"));
        until(
                "it asks for boats",
                () -> asked(mission)
                        .filter(one -> one.decision().id() != area.decision().id())
                        .isPresent());
        get(session()
                .answer(
                        asked(mission).orElseThrow().decision().id(),
                        new Answer.Proxies(boats.subList(0, team)),
                        "robot"));
        until(
                "boats are under way",
                () -> boats().stream().filter(boat -> boat.points() > 0).count() == team);
        until(
                "its interrupts can be pressed",
                () -> session().models().interrupts().snapshot().stream()
                        .anyMatch(choice -> choice.mission() == mission && choice.isEnabled()));
        return mission;
    }

    private static final GeoArea SMALL = new GeoArea(
            List.of(
                    GeoPoint.of(25.3594, 51.5288),
                    GeoPoint.of(25.3594, 51.5318),
                    GeoPoint.of(25.3608, 51.5318),
                    GeoPoint.of(25.3608, 51.5288)),
            List.of());

    /** A component of a name that is shown; waits for it. */
    Component find(String name) {
        return robot.find(Component.class, name);
    }

    /** The tables of a panel that are shown. */
    List<JTable> tables(String panel) {
        Container root = (Container) find(panel);
        return onEventThread(() -> {
            List<JTable> found = new ArrayList<>();
            tables(root, found);
            return found;
        });
    }

    private static void tables(Container root, List<JTable> found) {
        for (Component child : root.getComponents()) {
            if (child instanceof JTable table && table.isShowing()) {
                found.add(table);
            } else if (child instanceof Container inner) {
                tables(inner, found);
            }
        }
    }

    /** Ticks a box, once it is in sight. */
    void tick(String box) {
        robot.scrollTo(robot.find(JComponent.class, box));
        robot.click(box);
    }

    /** Types a file's name into the sheet that asks for it, and chooses it. */
    void typeFile(String sheet, Path file) {
        robot.untilShown(sheet);
        robot.find(
                JTextField.class,
                name -> name.isFocusOwner() && SwingUtilities.getAncestorOfClass(JFileChooser.class, name) != null);
        robot.type(file.toAbsolutePath() + "\n");
    }

    /** Replaces what stands in a field by typing. */
    void type(String field, String text) {
        JTextComponent into = robot.find(JTextComponent.class, field);
        robot.scrollTo(into);
        robot.click(field);
        robot.untilFocused(field);
        onEventThread(() -> {
            into.selectAll();
            return null;
        });
        robot.press(VK_DELETE);
        robot.type(text);
    }

    // ---- what is looked at

    /** Waits until something is so. */
    void until(String what, Supplier<Boolean> so) {
        robot.until(what, WITHIN_S, so);
    }

    /** Waits until a component that is shown says something. */
    void says(String name, String part) {
        until(
                name + " says '" + part + "'; it says '" + text(name) + "'",
                () -> textNow(name).contains(part));
    }

    /** What components of a name that are shown say, in one. */
    String text(String name) {
        return onEventThread(() -> textNow(name));
    }

    private String textNow(String name) {
        StringBuilder said = new StringBuilder();
        collect(opened.window().frame().getRootPane(), name, said);
        return said.toString();
    }

    private static void collect(Component at, String name, StringBuilder said) {
        if (at.isShowing() && name.equals(at.getName())) {
            if (at instanceof JLabel label) {
                said.append(label.getText());
            } else if (at instanceof JTextComponent written) {
                said.append(written.getText());
            } else if (at instanceof AbstractButton button) {
                said.append(button.getText());
            }
        }
        if (at instanceof Container inner) {
            for (Component child : inner.getComponents()) {
                collect(child, name, said);
            }
        }
    }

    /** Waits until the panel of decisions says why there is no answer, or what is to be minded. */
    void judged(String part) {
        until(
                "the panel of decisions says '" + part + "'; it says: " + judgement(),
                () -> judgementNow().contains(part));
    }

    private String judgement() {
        return onEventThread(this::judgementNow);
    }

    private String judgementNow() {
        return Stream.of("decision-problem", "decision-problem-line", "decision-doubts", "decision-judgement-line")
                .map(this::textNow)
                .reduce("", (all, one) -> all + " " + one);
    }

    /** The titles of the missions' tabs, a line each. */
    String tabTitles() {
        return onEventThread(() -> {
            JTabbedPane tabs = Layout.find(opened.window().frame(), "mission-tabs", JTabbedPane.class)
                    .orElseThrow();
            StringBuilder all = new StringBuilder();
            for (int i = 0; i < tabs.getTabCount(); i++) {
                all.append(tabs.getTitleAt(i)).append('\n');
            }
            return all.toString();
        });
    }

    /** Whether a button can be pressed. */
    boolean isOn(String button) {
        return onEventThread(() -> Layout.find(opened.window().frame(), button, AbstractButton.class)
                .filter(AbstractButton::isEnabled)
                .isPresent());
    }

    /** Whether something of a name is on the screen. */
    boolean isShown(String name) {
        return onEventThread(() -> Layout.find(opened.window().frame(), name, Component.class)
                .filter(Component::isShowing)
                .isPresent());
    }

    @Override
    public void close() throws Exception {
        try {
            opened.close();
            if (fleet.isPresent()) {
                fleet.get().close();
            }
        } finally {
            errors.close();
        }
    }
}
