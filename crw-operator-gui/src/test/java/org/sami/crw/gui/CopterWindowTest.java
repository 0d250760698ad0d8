package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JTabbedPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.start.StartOptions;
import org.sami.palette.Theme;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.dock.DockArea;
import org.sami.ui.dock.DockPanel;
import org.sami.ui.look.Look;

/** The operator's window on the second domain: five simulated copters, the aircraft's plans, and their words on its panels and commands. */
@Tag("window")
class CopterWindowTest {
    private final WindowRobot robot = new WindowRobot();

    @TempDir
    private Path folder;

    @Test
    void opensOnFiveCoptersAndCallsThemSo() throws Exception {
        RealDisplay.assumed();
        try (OpenedWindow opened = OpenedWindow.open(options("uav"), folder)) {
            robot.untilSaid("boats-count", "5 of 5 copters");

            List<String> texts = WindowRobot.ask(() -> opened.window().commands().all().stream()
                    .flatMap(command ->
                            Stream.of(command.title(), command.whyNot().orElse("")))
                    .toList());
            assertThat(texts).noneMatch(text -> text.matches("(?is).*\\bboats?\\b.*"));
            List<String> columns = WindowRobot.ask(() -> IntStream.range(0, table().getColumnCount())
                    .mapToObj(table()::getColumnName)
                    .toList());
            assertThat(columns).contains("Copter", "Altitude");

            JTable lines = table();
            int below = WindowRobot.ask(() -> lines.getLocationOnScreen().y);
            WindowRobot.ask(() -> {
                opened.window().commands().get("arrangement-aims").run();
                return true;
            });
            JList<?> cards = robot.find(JList.class, "boat-cards");
            robot.until(
                    "the copters stand at the top left, each with its newest picture",
                    () -> cards.isShowing()
                            && cards.getLocationOnScreen().y < below
                            && cards.getModel().getSize() == 5);
            assertThat(lines.isShowing()).isFalse();
            assertThat(tabsWith("missions")).containsExactly("Plan", "Gantt", "Detect", "Decisions");

            opened.window().session().start("search", "search", Map.of());
            WindowRobot.ask(() -> {
                opened.window().commands().get("panel-gantt").run();
                return true;
            });
            JComponent chart = robot.find(JComponent.class, "gantt-chart");
            robot.until(
                    "the chart has the mission and its phases",
                    () -> chart.isShowing()
                            && chart.getAccessibleContext()
                                    .getAccessibleDescription()
                                    .equals("Search of an area; Get locations; Task assignment; Task execution"));

            WindowRobot.ask(() -> {
                Look.apply(Theme.LIGHT, 150);
                return true;
            });
            JComponent map = robot.find(DockPanel.class, "map");
            JComponent all = robot.find(DockArea.class, "dock-area");
            robot.until("the map has all of the height", () -> map.getHeight() > 0.8 * all.getHeight());
            robot.until("the chart is still in front", chart::isShowing);
            WindowRobot.ask(() -> {
                Look.apply(Theme.LIGHT, 100);
                opened.window().commands().get("mission-abort").run();
                return true;
            });
            robot.untilShown("mission-ending"); // in front of the chart, to be read before it is confirmed

            WindowRobot.ask(() -> {
                opened.window().commands().get("arrangement-first").run();
                return true;
            });
            assertThat(tabsWith("map")).containsExactly("Map", "Pictures", "Gantt");
            assertThat(robot.find(DockPanel.class, "missions").title()).isEqualTo("Missions");
            robot.until("the copters are a line each again", () -> lines.isShowing() && !cards.isShowing());

            DockPanel alone = robot.find(DockPanel.class, "missions");
            int begins = WindowRobot.ask(() -> below(alone));
            WindowRobot.ask(() -> {
                Look.apply(Theme.DARK, 100);
                return true;
            });
            assertThat(WindowRobot.ask(() -> below(alone)))
                    .as("no line is drawn around it after a change of theme")
                    .isEqualTo(begins);
        }
    }

    @Test
    void copterIsCheckedForItsTakeOffAndOffersNeitherMotorTrialNorStickNorGains() throws Exception {
        RealDisplay.assumed();
        try (OpenedWindow opened = OpenedWindow.open(options("uav"), folder)) {
            robot.untilSaid("boats-count", "5 of 5 copters");
            robot.clickRow("boats-table", "copter1");
            WindowRobot.ask(() -> {
                opened.window().commands().get("panel-boat").run();
                return true;
            });
            JTabbedPane tabs = robot.find(JTabbedPane.class, "boat-tabs");
            assertThat(WindowRobot.ask(() -> IntStream.range(0, tabs.getTabCount())
                            .mapToObj(tabs::getTitleAt)
                            .toList()))
                    .containsExactly("Commands", "Before take-off", "Settings");
            WindowRobot.ask(() -> {
                tabs.setSelectedIndex(1);
                return true;
            });

            robot.untilSaid("boat-launch-summary", "✓ may take off: 7 of 7 good");
            for (String absent : List.of("boat-try-motor", "boat-by-hand", "phone-add", "boats-ground-station")) {
                assertThat(opened.window().commands().find(absent)).as(absent).isEmpty();
            }
            WindowRobot.ask(() -> {
                tabs.setSelectedIndex(2);
                return true;
            });
            JComponent gains = robot.find(JComponent.class, any -> "boat-lost-link".equals(any.getName()));
            assertThat(WindowRobot.ask(() -> Stream.of(gains.getParent().getComponents())
                            .filter(Component::isVisible)
                            .map(Component::getName)
                            .filter(Objects::nonNull)
                            .toList()))
                    .contains("boat-velocity-now", "boat-lost-link-now")
                    .doesNotContain("boat-heading-now", "boat-speed-now");
        }
    }

    /** In the window's least size: each row has its mark, what it is, and its name. */
    @Test
    void namesOfATeamAreWhole() throws Exception {
        RealDisplay.assumed();
        try (OpenedWindow opened = OpenedWindow.open(options("team"), folder)) {
            robot.untilSaid("boats-count", "5 of 5 robots");
            WindowRobot.ask(() -> {
                opened.window().frame().setSize(1280, 800);
                opened.window().frame().validate();
                return true;
            });

            robot.until(
                    "names have room",
                    () -> IntStream.range(0, table().getRowCount())
                            .allMatch(row -> table().prepareRenderer(table().getCellRenderer(row, 0), row, 0)
                                            .getPreferredSize()
                                            .width
                                    <= table().getColumnModel().getColumn(0).getWidth()));
        }
    }

    private static StartOptions options(String domain) {
        return new StartOptions(
                List.of(),
                Optional.empty(),
                Optional.of(Theme.LIGHT),
                Optional.of(100),
                Optional.of(false),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                StartOptions.Near.WHEN_ASKED,
                domain);
    }

    private List<String> tabsWith(String panel) throws Exception {
        DockPanel shown = robot.find(DockPanel.class, panel);
        return WindowRobot.ask(() -> {
            JTabbedPane tabs = (JTabbedPane) SwingUtilities.getAncestorOfClass(JTabbedPane.class, shown);
            return IntStream.range(0, tabs.getTabCount())
                    .mapToObj(tabs::getTitleAt)
                    .toList();
        });
    }

    /** How far a panel lies below the upper edge of its window. */
    private static int below(DockPanel panel) {
        return SwingUtilities.convertPoint(panel, 0, 0, SwingUtilities.getRootPane(panel)).y;
    }

    private JTable table() {
        return robot.find(JTable.class, "boats-table");
    }
}
