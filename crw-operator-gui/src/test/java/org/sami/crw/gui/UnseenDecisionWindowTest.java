package org.sami.crw.gui;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.event.KeyEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.AbstractButton;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.crw.gui.start.StartOptions;
import org.sami.crw.gui.window.OperatorWindow;
import org.sami.palette.Theme;
import org.sami.ui.check.Layout;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.dock.DockPanel;

/** A decision comes while another panel lies before the decisions, in a small window with large letters. */
@Tag("window")
class UnseenDecisionWindowTest {
    private final WindowRobot robot = new WindowRobot();

    @TempDir
    private Path folder;

    @Test
    void aDecisionBehindAnotherPanelIsSaidAtTheTopAndTakesNoFocus() throws Exception {
        RealDisplay.assumed();
        try (LoopbackFleet fleet = new LoopbackFleet(List.of("anna", "bert", "carl"))) {
            StartOptions options = new StartOptions(
                    fleet.addresses(),
                    Optional.empty(),
                    Optional.of(Theme.LIGHT),
                    Optional.of(200),
                    Optional.of(false));
            try (OpenedWindow opened = OpenedWindow.open(options, folder)) {
                OperatorWindow window = opened.window();
                WindowRobot.ask(() -> {
                    window.frame().setSize(1280, 800);
                    window.frame().validate();
                    return null;
                });
                robot.untilSaid("boats-count", "3");
                robot.until("few panels are beside one another", () -> !isSeen(window, "messages"));
                robot.press(KeyEvent.VK_8, KeyEvent.VK_ALT);
                robot.until("interrupts are in front", () -> isSeen(window, "interrupts"));

                window.session().start("explore-team", "", Map.of());
                robot.untilShown("decision-unseen");

                AbstractButton unseen = robot.find(AbstractButton.class, "decision-unseen");
                assertThat(WindowRobot.ask(unseen::getText)).isEqualTo("▲ Draw the area");
                assertThat(WindowRobot.ask(() -> isSeen(window, "interrupts"))).isTrue();
                robot.click("decision-unseen");
                robot.until("decisions are in front", () -> isSeen(window, "decisions"));
                robot.until("nothing is said of it", () -> !unseen.isVisible());
                robot.press(KeyEvent.VK_8, KeyEvent.VK_ALT);
                robot.press(KeyEvent.VK_4, KeyEvent.VK_ALT);
                robot.clickRow("boats-table", "anna");
                robot.untilFocused("boats-table");
                robot.untilShown("decision-unseen");
                robot.untilFocused("boats-table");
            }
        }
    }

    /** On the event thread. */
    private static boolean isSeen(OperatorWindow window, String panel) {
        return Layout.find(window.frame(), panel, DockPanel.class)
                .filter(DockPanel::isShowing)
                .isPresent();
    }
}
