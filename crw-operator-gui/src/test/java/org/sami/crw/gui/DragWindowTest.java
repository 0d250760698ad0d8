package org.sami.crw.gui;

import static java.awt.event.KeyEvent.VK_9;
import static java.awt.event.KeyEvent.VK_ALT;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import javax.swing.JLabel;
import javax.swing.JTable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.mission.DividedTasks;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.palette.Theme;
import org.sami.spn.json.ProjectWriter;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TaskId;
import org.sami.ui.check.LabelTexts;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

/** A task is dragged to another boat in the real window. */
@Tag("window")
class DragWindowTest {
    /** One for each of the five boats, so far away that nothing is done while the test looks. */
    private static final ListValue LOCATIONS = new ListValue(List.of(
            GeoPoint.of(25.3697, 51.54),
            GeoPoint.of(25.3687, 51.54),
            GeoPoint.of(25.3677, 51.54),
            GeoPoint.of(25.3667, 51.54),
            GeoPoint.of(25.3657, 51.54)));

    @TempDir
    private Path folder;

    @Test
    void aTaskIsDraggedToTheRowOfAnotherBoat() throws Exception {
        RealDisplay.assumed();
        Path project = Files.writeString(
                folder.resolve("measure.json"),
                new ProjectWriter(SessionWorld.LIBRARY.vocabulary()).text(SessionWorld.library("measure")));
        StartOptions options = new StartOptions(
                List.of(), Optional.of(project), Optional.of(Theme.LIGHT), Optional.of(100), Optional.of(false));
        try (OpenedWindow opened = OpenedWindow.open(options, folder)) {
            OperatorWindow window = opened.window();
            WindowRobot robot = new WindowRobot();
            robot.untilSaid("boats-count", "5 of 5");
            DividedTasks.of(window.session(), LOCATIONS);
            robot.press(VK_9, VK_ALT);
            JTable table = robot.find(JTable.class, "allocation-table");
            robot.until(
                    "a row of each task",
                    () -> tasks(table) == LOCATIONS.items().size());
            Map<String, List<TaskId>> before = queues(window);
            String from = before.entrySet().stream()
                    .filter(boat -> !boat.getValue().isEmpty())
                    .findFirst()
                    .orElseThrow()
                    .getKey();
            String to = from.equals("bert") ? "anna" : "bert";
            TaskId task = before.get(from).get(0);
            LabelTexts notices = LabelTexts.of(robot.find(JLabel.class, "notice"));

            assertThat(robot.drag(table, robot.rowAt(table, from), table, robot.rowAt(table, to)))
                    .isTrue();

            robot.until(
                    to + " has it",
                    () -> queues(window).getOrDefault(to, List.of()).contains(task));
            assertThat(queues(window).getOrDefault(from, List.of())).doesNotContain(task);
            robot.until("the notice names the task", () -> notices.had(task.name()));
        }
    }

    private static long tasks(JTable table) {
        return IntStream.range(0, table.getRowCount())
                .filter(row -> !"no task".equals(table.getValueAt(row, 2)))
                .count();
    }

    private static Map<String, List<TaskId>> queues(OperatorWindow window) {
        return window.session().models().allocation().snapshot().queues();
    }
}
