package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.swing.JTable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.start.StartOptions;
import org.sami.palette.Theme;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;

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

            int below = WindowRobot.ask(() -> table().getLocationOnScreen().y);
            WindowRobot.ask(() -> {
                opened.window().commands().get("arrangement-aims").run();
                return true;
            });
            robot.until(
                    "the copters stand at the top left",
                    () -> table().isShowing() && table().getLocationOnScreen().y < below);
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

    private JTable table() {
        return robot.find(JTable.class, "boats-table");
    }
}
