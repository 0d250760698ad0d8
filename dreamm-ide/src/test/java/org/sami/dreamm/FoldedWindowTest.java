package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_1;
import static java.awt.event.KeyEvent.VK_2;
import static java.awt.event.KeyEvent.VK_4;
import static java.awt.event.KeyEvent.VK_6;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_F11;
import static java.awt.event.KeyEvent.VK_HOME;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Dimension;
import java.nio.file.Path;
import java.util.Optional;
import javax.swing.JComponent;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.profile.Profile;
import org.sami.ui.check.WindowRobot;

/** The net alone in the window, with the panels folded to its edge, by keys. */
@Tag("window")
class FoldedWindowTest {
    private static Dimension size(JComponent canvas) {
        return WindowRobot.ask(canvas::getSize);
    }

    private static long area(JComponent canvas) {
        return (long) canvas.getWidth() * canvas.getHeight();
    }

    @Test
    void atFirstTheNetHasMostOfTheWindowAndPanelsOpenByOnePressAndFoldAgain(@TempDir Path data) throws Exception {
        try (AuthorRobot author = AuthorRobot.open(data, Optional.of("clv"), Optional.empty(), Profile.ALL)) {
            WindowRobot robot = author.robot;
            JComponent canvas = author.net().canvas();
            openAndFold(robot, canvas);
            giveTheNetAllTheRoom(robot, canvas);
        }
    }

    private static void openAndFold(WindowRobot robot, JComponent canvas) {
        robot.until("the canvas has the focus", canvas::isFocusOwner);
        long first = WindowRobot.ask(() -> area(canvas));

        robot.press(VK_6, VK_ALT);
        robot.untilShown("try-out-panel");
        robot.click("folded-issues");
        robot.untilShown("issues-panel");
        robot.click("issues-fold");
        robot.untilShown("folded-issues");
        robot.click("try-out-fold");
        robot.until("the net has its room again", () -> Math.abs(area(canvas) - first) < first / 50);

        robot.click("panels-unfold");
        robot.until("all panels lie beside the net", () -> first > 1.3 * area(canvas));
        robot.press(VK_1, VK_ALT);
        robot.untilShown("mission-tree-lines");

        robot.press(VK_HOME, VK_ALT);
        robot.until("they lie as at first", () -> Math.abs(area(canvas) - first) < first / 50);
    }

    private static void giveTheNetAllTheRoom(WindowRobot robot, JComponent canvas) {
        robot.press(VK_4, VK_ALT);
        robot.until("the inspector has the focus", () -> !canvas.isFocusOwner());
        robot.press(VK_2, VK_ALT);
        robot.until("the canvas has the focus", canvas::isFocusOwner);

        Dimension before = size(canvas);
        robot.press(VK_F11);
        robot.until("the net has more room", () -> area(canvas) > 1.2 * before.width * before.height);
        robot.until("the canvas has the focus", canvas::isFocusOwner);
        Dimension folded = size(canvas);

        robot.press(VK_4, VK_ALT);
        robot.untilShown("inspector-panel");
        assertThat(size(canvas))
                .as("nothing moves as a panel opens over the edge")
                .isEqualTo(folded);
        robot.untilFocused("plan-name");
        robot.press(VK_ESCAPE);
        robot.until("the canvas has the focus again", canvas::isFocusOwner);

        robot.press(VK_F11);
        robot.until(
                "the panels are back",
                () -> Math.abs(canvas.getWidth() - before.width) < 12
                        && Math.abs(canvas.getHeight() - before.height) < 12);
        robot.untilShown("inspector-panel");
    }
}
