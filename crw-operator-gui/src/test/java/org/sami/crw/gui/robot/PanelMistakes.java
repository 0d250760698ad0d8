package org.sami.crw.gui.robot;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_F1;
import static java.awt.event.KeyEvent.VK_G;
import static java.awt.event.KeyEvent.VK_HOME;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_TAB;
import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.crw.gui.EventThreadCall.onEventThread;

import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import javax.swing.JMenuItem;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import org.sami.crw.gui.EscapedWindow;
import org.sami.crw.gui.start.DataDirectory;
import org.sami.crw.gui.start.SessionOpener;
import org.sami.crw.session.Session;
import org.sami.spn.testing.JavaProcess;

/** What operators do wrong with panels, sheets and files. */
final class PanelMistakes {
    /** The rows. */
    static final List<RobotRow> ROWS = List.of(
            new RobotRow("Tab pressed in every table", "the focus leaves each of them", PanelMistakes::tabInTables),
            new RobotRow(
                    "A panel closed",
                    "its command brings it back; all panels are put back by one key",
                    PanelMistakes::panelClosed),
            new RobotRow(
                    "A click while a sheet is open",
                    "the click does what it does without the sheet; the sheet stays",
                    PanelMistakes::clickBesideSheet),
            new RobotRow(
                    "Letters and digits typed where nothing takes them",
                    "nothing starts, nothing is commanded",
                    PanelMistakes::typedNowhere),
            new RobotRow(
                    "A global place set into a no-go area",
                    "the panel says how far inside it lies, before it is set",
                    PanelMistakes::globalInNoGo),
            new RobotRow(
                    "Escape at the question whether a session goes on",
                    "the program ends, and the session is on offer the next time",
                    PanelMistakes::escapeAtTheStart));

    private PanelMistakes() {}

    private static void tabInTables(RobotWorld world) {
        for (String panel : List.of("missions", "boats", "messages", "alarms", "health", "communication", "log")) {
            world.run("panel-" + panel);
            List<JTable> tables = world.tables(panel);
            for (JTable table : tables) {
                onEventThread(() -> {
                    table.requestFocusInWindow();
                    return null;
                });
                world.until(table.getName() + " has the focus", table::isFocusOwner);
                world.robot.press(VK_TAB);
                world.until("the focus has left " + table.getName(), () -> !table.isFocusOwner());
            }
            assertThat(tables).as("tables of " + panel).isNotEmpty();
        }
        world.run("panel-boats");
        world.run("panel-messages");
    }

    private static void panelClosed(RobotWorld world) {
        world.robot.click("messages-menu");
        JMenuItem close = world.robot.find(JMenuItem.class, item -> "Close".equals(item.getText()));
        world.robot.clickAt(close, 12, 12);
        world.until("it is closed", () -> !world.isShown("messages-table"));
        world.run("panel-messages");
        world.until("it is back", () -> world.isShown("messages-table"));
        world.robot.press(VK_HOME, VK_ALT);
        world.until("all are back", () -> world.isShown("messages-table") && world.isShown("map-canvas"));
    }

    private static void clickBesideSheet(RobotWorld world) {
        world.robot.press(VK_F1);
        world.robot.untilShown("command-keys-window");
        world.robot.clickRow("boats-table", "anna");
        JTable boats = world.robot.find(JTable.class, "boats-table");
        world.until(
                "anna is selected",
                () -> boats.getSelectedRow() >= 0 && "anna".equals(boats.getValueAt(boats.getSelectedRow(), 0)));
        assertThat(world.isShown("command-keys-window")).isTrue();
    }

    private static void typedNowhere(RobotWorld world) {
        for (String name : List.of("map-canvas", "decisions", "boats-table")) {
            Component at = world.find(name);
            onEventThread(() -> {
                at.requestFocusInWindow();
                return null;
            });
            world.robot.type("hold all 123");
        }
        assertThat(world.running()).isEmpty();
        assertThat(world.boats()).allMatch(boat -> boat.command().isEmpty());
    }

    private static void globalInNoGo(RobotWorld world) {
        JTabbedPane tabs = world.robot.find(JTabbedPane.class, "mission-tabs");
        onEventThread(() -> {
            tabs.setSelectedIndex(1);
            return null;
        });
        world.robot.clickRow("globals-table", "@station");
        world.type("value-global-station-text", "25.3576, 51.5266");
        world.says("global-problem", "inside a no-go area");
        world.type("value-global-station-text", "25.3576, nowhere");
        world.robot.press(VK_G, VK_CONTROL, VK_SHIFT);
        assertThat(world.running()).isEmpty();
    }

    private static void escapeAtTheStart(RobotWorld world) throws Exception {
        Path data = world.folder.resolve("asked");
        unfinished(data);
        String named = Files.readString(data.resolve("open-session"));
        for (int i = 0; i < 2; i++) {
            Process program = JavaProcess.builder(world.folder, EscapedWindow.class, data.toString())
                    .redirectErrorStream(true)
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            try {
                assertThat(program.waitFor(60, TimeUnit.SECONDS)).isTrue();
                assertThat(program.exitValue()).isZero();
            } finally {
                program.destroyForcibly();
            }
            assertThat(Files.readString(data.resolve("open-session"))).isEqualTo(named);
        }
    }

    /** Leaves a session behind that did not end. */
    static void unfinished(Path data) throws Exception {
        try (DataDirectory earlier = DataDirectory.open(data);
                Session session = new SessionOpener(earlier, List.of(), Optional.empty()).openNew()) {
            session.begin();
        }
    }
}
