package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_B;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_F12;
import static java.awt.event.KeyEvent.VK_P;
import static java.awt.event.KeyEvent.VK_Q;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_W;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Dialog;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.WindowEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import javax.swing.JMenu;
import javax.swing.JRootPane;
import javax.swing.JTextArea;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.api.TestInstance.Lifecycle;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.link.BoatMode;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.crw.operator.boat.BoatSnapshot;
import org.sami.palette.Theme;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.look.Look;

/** The pointer reaches the fleet stop whatever is asked or shown, and Escape closes what was opened. */
@Tag("window")
@TestInstance(Lifecycle.PER_CLASS)
class FleetStopReachWindowTest {
    private OpenedWindow opened;
    private WindowRobot robot;
    private OperatorWindow window;
    private Path folder;

    @BeforeAll
    void open(@TempDir Path data) throws Exception {
        RealDisplay.assumed();
        folder = data;
        robot = new WindowRobot();
        opened = OpenedWindow.onBuiltInFleet(data);
        window = opened.window();
        robot.untilSaid("boats-count", "5 of 5");
    }

    @AfterAll
    void close() throws Exception {
        if (window != null) {
            opened.end();
        }
    }

    @ParameterizedTest
    @CsvSource({
        "base map, base-map-file, 1500, 950, 100",
        "replay a journal, replay-file, 1500, 950, 100",
        "load a project, project-file, 1280, 800, 150",
        "connect a boat, boat-connect-sheet, 1280, 800, 150",
        "start mission with values, mission-values-window, 1280, 800, 150",
        "commands and keys, command-keys-window, 1280, 800, 150",
        "find a command, command-search-sheet, 1280, 800, 150"
    })
    void whatIsOpenedLeavesTheFleetStopToThePointerAndEscapeClosesIt(
            String command, String sheet, int width, int height, int percent) {
        look(width, height, percent);
        search(command);

        Component opened = robot.find(Component.class, sheet);

        stopByPointer();
        assertThat(WindowRobot.ask(FleetStopReachWindowTest::modalDialogs)).isEmpty();
        release();
        if (WindowRobot.ask(opened::isShowing)) { // a search closes when something else is pressed
            robot.clickAt(opened, 12, 12); // nothing lies there
            robot.press(VK_ESCAPE);
        }
        robot.until("it is closed", () -> !opened.isShowing());
    }

    @Test
    void anOpenMenuLeavesTheFleetStopToThePointer() {
        look(1500, 950, 100);
        for (String menu : List.of("menu-session", "menu-view")) {
            robot.click(menu);
            robot.until("the menu is open", () -> robotMenu(menu).isPopupMenuVisible());

            stopByPointer();

            release();
            robot.press(VK_ESCAPE);
        }
        robot.click("map-layers");
        robot.untilShown("layer-boats");

        stopByPointer();
        release();
    }

    private JMenu robotMenu(String name) {
        return Arrays.stream(window.frame().getJMenuBar().getComponents())
                .filter(each -> name.equals(each.getName()))
                .map(JMenu.class::cast)
                .findFirst()
                .orElseThrow();
    }

    @Test
    void theWindowAsksInPlaceWhatBoatsShallDoAsItIsClosedWhileMissionsRun() {
        look(1500, 950, 100);
        window.session().start("communications-monitoring", "monitoring of the bay", Map.of());
        robot.untilSaid("missions-count", "1 mission");

        WindowRobot.ask(() -> {
            window.frame().dispatchEvent(new WindowEvent(window.frame(), WindowEvent.WINDOW_CLOSING));
            return null;
        });
        Component asked = robot.find(Component.class, "closing");
        robot.untilFocused("closing-stay");
        untilWritten("closing-missions", "1 mission runs: Communications Monitoring");
        untilWritten("closing-without-link", "anna, bert, carl, dora, emil:");
        stopByPointer();
        release();
        robot.click("closing-stay");

        robot.until("it is closed", () -> !asked.isShowing());
        assertThat(opened.hasEnded()).isFalse();
        robot.press(VK_Q, VK_CONTROL);
        robot.untilFocused("closing-stay");
        robot.press(VK_ESCAPE);
        robot.until("it is closed", () -> window.frame().isShowing() && !showsClosing());
        window.session().abortAll();
        robot.untilSaid("missions-count", "0 missions");
        robot.press(VK_W, VK_CONTROL);
    }

    private void untilWritten(String area, String text) {
        JTextArea found = robot.find(JTextArea.class, area);
        robot.until(area + " says " + text, 10, () -> found.getText().contains(text));
    }

    private boolean showsClosing() {
        return org.sami.ui.sheet.WindowSheet.in(window.frame().getRootPane())
                .name()
                .equals("closing-sheet");
    }

    @Test
    void anAddressThatIsNoneIsSaidInPlaceBeforeItIsConnected() {
        look(1500, 950, 100);
        robot.press(VK_B, VK_CONTROL);
        robot.untilFocused("boat-connect-address");
        robot.press(VK_ENTER);
        untilWritten("boat-connect-said", "Type the address");
        robot.type("127.0.0.1");
        Component connect = robot.find(Component.class, "boat-connect-do");
        robot.until("there is nothing to connect to", () -> !connect.isEnabled());
        robot.press(VK_ESCAPE);
    }

    @Test
    void focusGoesToNoButtonWhereWhatHadItIsOutOfSight() {
        look(1280, 800, 150);
        Component before = robot.find(Component.class, "map-layers");
        WindowRobot.ask(before::requestFocusInWindow);
        robot.untilFocused("map-layers");
        robot.press(VK_B, VK_CONTROL);
        robot.untilFocused("boat-connect-address");
        show(before, false);

        robot.press(VK_ESCAPE);

        JRootPane root = window.frame().getRootPane();
        robot.until("the focus is at no button", root::isFocusOwner);
        show(before, true);
        WindowRobot.ask(before::requestFocusInWindow);
        robot.untilFocused("map-layers");
        robot.press(VK_B, VK_CONTROL);
        robot.untilFocused("boat-connect-address");
        robot.press(VK_ESCAPE);
        robot.untilFocused("map-layers");
    }

    private static void show(Component component, boolean shown) {
        WindowRobot.ask(() -> {
            component.setVisible(shown);
            return null;
        });
    }

    @Test
    void theKeyOfACommandThatCannotBeRunSaysWhy() {
        look(1500, 950, 100);
        robot.press(VK_ENTER, VK_CONTROL, VK_SHIFT);

        robot.untilSaid("notice", "Release: boats go on: press 'Release fleet' first");
    }

    @Test
    void theKeyOfTheFleetStopWorksWhileAFileIsChosen() throws Exception {
        look(1500, 950, 100);
        Files.writeString(folder.resolve("notes.txt"), "no map");
        robot.press(VK_B, VK_ALT, VK_SHIFT);
        robot.untilShown("base-map-file");

        robot.press(VK_F12);

        robot.until("all boats are stopped", () -> boats().stream().allMatch(FleetStopReachWindowTest::isStopped));
        release();
        robot.press(VK_ESCAPE);
    }

    private void search(String command) {
        robot.press(VK_P, VK_CONTROL, VK_SHIFT);
        robot.untilFocused("command-search-text");
        if (!command.equals("find a command")) {
            robot.type(command);
            robot.press(VK_ENTER);
        }
    }

    private void stopByPointer() {
        Component stop = robot.find(Component.class, "fleet-stop");
        Rectangle at = WindowRobot.ask(stop::getBounds);
        robot.clickAt(stop, at.width / 2, at.height / 2);
        robot.until("all boats are stopped", () -> boats().stream().allMatch(FleetStopReachWindowTest::isStopped));
    }

    private void release() {
        window.session().fleet().releaseAll();
        robot.until("all boats are released", () -> boats().stream().noneMatch(FleetStopReachWindowTest::isStopped));
    }

    private void look(int width, int height, int percent) {
        WindowRobot.ask(() -> {
            if (Look.scalePercent() != percent) {
                Look.apply(Theme.LIGHT, percent);
            }
            window.frame().setSize(width, height);
            window.frame().validate();
            return null;
        });
        robot.until("the window has its size", () -> window.frame().getWidth() == width);
    }

    private static List<Window> modalDialogs() {
        return Arrays.stream(Window.getWindows())
                .filter(each -> each.isShowing() && each instanceof Dialog dialog && dialog.isModal())
                .toList();
    }

    private List<BoatSnapshot> boats() {
        return window.session().models().fleet().snapshot();
    }

    private static boolean isStopped(BoatSnapshot boat) {
        return boat.mode().map(mode -> mode == BoatMode.FLEET_STOP).orElse(false);
    }
}
