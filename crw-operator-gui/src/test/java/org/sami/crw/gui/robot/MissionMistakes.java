package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_9;
import static java.awt.event.KeyEvent.VK_A;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_F4;
import static java.awt.event.KeyEvent.VK_F9;
import static java.awt.event.KeyEvent.VK_N;
import static java.awt.event.KeyEvent.VK_O;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_Z;
import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import javax.swing.AbstractButton;
import javax.swing.JComponent;
import javax.swing.JTable;
import org.sami.crw.gui.mission.DividedTasks;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TaskId;

/** What operators do wrong with missions, their interrupts and their ends. */
final class MissionMistakes {
    /** The rows. */
    static final List<RobotRow> ROWS = List.of(
            new RobotRow(
                    "An interrupt pressed twice",
                    "it asks once; the second press says so; every button of the mission keeps its place",
                    MissionMistakes::interruptTwice),
            new RobotRow(
                    "An interrupt pressed by mistake and withdrawn",
                    "nothing was done; boats go on; the button is as before",
                    MissionMistakes::interruptWithdrawn),
            new RobotRow(
                    "The key of an interrupt that no mission has",
                    "the strip says so; nothing else happens",
                    MissionMistakes::keyOfNoInterrupt),
            new RobotRow(
                    "A double click on an interrupt that cannot be undone",
                    "it asks for confirmation in place; nothing is pressed",
                    MissionMistakes::finalInterruptTwice),
            new RobotRow(
                    "The wrong mission aborted, and withdrawn by Escape",
                    "both missions run on, boats go on",
                    MissionMistakes::wrongMission),
            new RobotRow(
                    "Ctrl+Enter with no plan in sight that is selected",
                    "nothing begins; the plan is shown and the strip says so",
                    MissionMistakes::nothingSelected),
            new RobotRow("A double click on Start mission", "one mission begins", MissionMistakes::startTwice),
            new RobotRow(
                    "Start with values, one ticked and left empty",
                    "the form says which is missing; no mission begins",
                    MissionMistakes::startWithout),
            new RobotRow(
                    "Start with a value that cannot be",
                    "refused in the form before the start, in the words of the decision panel",
                    MissionMistakes::startWithWrong),
            new RobotRow(
                    "A task dragged away from the table",
                    "nobody takes it; every boat keeps its tasks",
                    MissionMistakes::taskDraggedAway),
            new RobotRow(
                    "Alt+F4 with missions running",
                    "the window asks in place what boats shall do, with the focus on the answer that closes nothing",
                    MissionMistakes::closeWindow),
            new RobotRow(
                    "A text loaded as a project while missions run",
                    "the strip says what is wrong with it; missions run on",
                    MissionMistakes::textAsProject));

    private static final ListValue TASKS = new ListValue(List.of(
            GeoPoint.of(25.3590, 51.5290),
            GeoPoint.of(25.3592, 51.5294),
            GeoPoint.of(25.3594, 51.5298),
            GeoPoint.of(25.3596, 51.5302),
            GeoPoint.of(25.3598, 51.5306)));

    private MissionMistakes() {}

    private static Map<String, Rectangle> buttons(RobotWorld world) {
        return List.of("interrupt-team-avoid-boat", "interrupt-battery-swap", "interrupt-proxy-abort").stream()
                .collect(Collectors.toMap(name -> name, name -> {
                    Component button = world.find(name);
                    return onEventThread(button::getBounds);
                }));
    }

    private static void interruptTwice(RobotWorld world) throws Exception {
        world.explore(2);
        Map<String, Rectangle> before = buttons(world);
        AbstractButton swap = (AbstractButton) world.find("interrupt-battery-swap");
        world.robot.scrollTo(swap);
        world.robot.click("interrupt-battery-swap");
        world.robot.untilShown("interrupt-battery-swap-withdraw");
        world.robot.clickAt(swap, 12, 12);
        world.until("one question waits", () -> world.decisions().size() == 1);
        assertThat(onEventThread(() -> swap.getToolTipText().contains("it asks already")))
                .isTrue();
        Map<String, Rectangle> after = buttons(world);
        before.keySet()
                .forEach(name -> assertThat(after.get(name).getLocation())
                        .as(name)
                        .isEqualTo(before.get(name).getLocation()));
    }

    private static void interruptWithdrawn(RobotWorld world) throws Exception {
        world.explore(2);
        world.robot.scrollTo((JComponent) world.find("interrupt-battery-swap"));
        world.robot.click("interrupt-battery-swap");
        world.robot.untilShown("interrupt-battery-swap-withdraw");
        world.robot.press(VK_Z, VK_CONTROL, VK_SHIFT);
        world.says("notice", "nothing was done");
        world.until("nothing waits", () -> world.decisions().isEmpty());
        assertThat(world.boats().stream().filter(boat -> boat.points() > 0)).hasSize(2);
        world.until("it can be pressed again", () -> world.isOn("interrupt-battery-swap"));
    }

    private static void keyOfNoInterrupt(RobotWorld world) throws Exception {
        world.explore(1);
        world.robot.press(VK_F9, VK_CONTROL);
        world.says("notice", "no mission has an interrupt with this key");
        assertThat(world.decisions()).isEmpty();
    }

    private static void finalInterruptTwice(RobotWorld world) throws Exception {
        long mission = world.explore(2);
        AbstractButton abort = (AbstractButton) world.find("interrupt-proxy-abort");
        world.robot.scrollTo(abort);
        int right = onEventThread(abort::getWidth) * 3 / 4; // where what confirms it comes up
        world.robot.doubleClickAt(abort, right, 12);
        world.says("interrupt-confirmation-text", "It cannot be undone");
        world.robot.press(VK_ESCAPE);
        world.until("it is left", () -> !world.isShown("interrupt-confirmation"));
        assertThat(world.running()).anyMatch(one -> one.id() == mission);
        assertThat(world.decisions()).isEmpty();
    }

    private static void wrongMission(RobotWorld world) throws Exception {
        long explores = world.explore(2);
        long monitors = world.start("communications-monitoring");
        world.robot.press(VK_A, VK_CONTROL, VK_SHIFT);
        world.says("mission-ending-title", "Abort ");
        world.robot.press(VK_ESCAPE);
        world.until("it is withdrawn", () -> !world.isShown("mission-ending"));
        assertThat(world.running()).extracting(one -> one.id()).contains(explores, monitors);
        assertThat(world.boats().stream().filter(boat -> boat.points() > 0)).hasSize(2);
    }

    private static void nothingSelected(RobotWorld world) throws Exception {
        world.start("communications-monitoring");
        world.until("its tab is shown", () -> !world.isShown("plans-table"));
        world.robot.press(VK_ENTER, VK_CONTROL);
        world.robot.untilShown("plans-table");
        world.says("notice", "Nothing has begun");
        assertThat(world.running()).hasSize(1);
    }

    private static void startTwice(RobotWorld world) throws Exception {
        world.robot.clickRow("plans-table", "Explore Area with interrupts");
        AbstractButton start = world.robot.find(AbstractButton.class, "mission-start");
        world.robot.doubleClickAt(start, 12, 12);
        world.until("a mission asks", () -> !world.decisions().isEmpty());
        int begun = RobotWorld.get(world.session().ask(view -> view.missions().size()));
        world.until("the engine's missions are shown", () -> world.running().size() <= begun);
        assertThat(world.running()).hasSize(1);
    }

    private static void openStart(RobotWorld world, String plan) {
        world.robot.clickRow("plans-table", plan);
        world.robot.press(VK_N, VK_CONTROL, VK_SHIFT);
        world.robot.untilShown("mission-values");
    }

    private static void startWithout(RobotWorld world) throws Exception {
        openStart(world, "Explore Area with interrupts");
        world.tick("value-start-area-given");
        world.says("mission-values-wrong", "Click its corners on the map");
        world.robot.press(VK_ENTER);
        assertThat(world.isOn("mission-values-start")).isFalse();
        assertThat(world.running()).isEmpty();
    }

    private static void startWithWrong(RobotWorld world) throws Exception {
        openStart(world, "Add simulated boats");
        world.tick("value-start-make-number-to-create-given");
        world.type("value-start-make-number-to-create-text", "99999");
        world.says("mission-values-wrong", "1 to 250 simulated boats are added at once, not 99,999");
        assertThat(world.isOn("mission-values-start")).isFalse();
        assertThat(world.running()).isEmpty();
    }

    private static Map<String, List<TaskId>> queues(RobotWorld world) {
        return world.session().models().allocation().snapshot().queues();
    }

    private static void taskDraggedAway(RobotWorld world) throws Exception {
        DividedTasks.of(world.session(), TASKS);
        world.robot.press(VK_9, VK_ALT);
        JTable table = world.robot.find(JTable.class, "allocation-table");
        Map<String, List<TaskId>> before = queues(world);
        String from = before.entrySet().stream()
                .filter(boat -> !boat.getValue().isEmpty())
                .findFirst()
                .orElseThrow()
                .getKey();
        world.robot.draw(
                table, world.robot.rowAt(table, from), onEventThread(() -> new Point(table.getWidth() / 2, -260)));
        assertThat(queues(world)).isEqualTo(before);
    }

    private static void closeWindow(RobotWorld world) throws Exception {
        long mission = world.explore(1);
        world.robot.press(VK_F4, VK_ALT);
        if (!world.isShown("closing")) { // a window manager without that key: what it would send
            onEventThread(() -> {
                world.opened()
                        .window()
                        .frame()
                        .dispatchEvent(new WindowEvent(world.opened().window().frame(), WindowEvent.WINDOW_CLOSING));
                return null;
            });
        }
        world.robot.untilFocused("closing-stay");
        world.says("closing-missions", "1 mission runs");
        world.robot.press(VK_ESCAPE);
        world.until("it is closed", () -> !world.isShown("closing"));
        assertThat(world.opened().hasEnded()).isFalse();
        assertThat(world.running()).anyMatch(one -> one.id() == mission);
    }

    private static void textAsProject(RobotWorld world) throws Exception {
        long mission = world.start("communications-monitoring");
        Path notes = Files.writeString(world.folder.resolve("notes.json"), "no project");
        world.robot.press(VK_O, VK_CONTROL);
        world.typeFile("project-file", notes);
        world.says("notice", "notes.json");
        assertThat(world.running()).anyMatch(one -> one.id() == mission);
    }
}
