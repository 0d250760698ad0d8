package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_9;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_F11;
import static java.awt.event.KeyEvent.VK_F12;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import javax.swing.JTable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.profile.Profile;
import org.sami.ui.check.WindowRobot;

/** A query is written, answered, its run shown on the net and taken on the engine, in the real window. */
@Tag("window")
class QueriesWindowTest {
    private AuthorRobot author;
    private WindowRobot robot;

    @Test
    void queryIsWrittenAnsweredShownAndPlayed(@TempDir Path folder) throws Exception {
        try (AuthorRobot opened = AuthorRobot.open(folder, Optional.of("clv"), Optional.empty(), Profile.ALL)) {
            author = opened;
            robot = opened.robot;
            robot.press(VK_9, VK_ALT);
            robot.untilShown("queries-panel");
            int saved = author.plan().queries().size(); // those that come with the plan
            author.write("query-name", "how many");
            author.write("query-text", "bound execute.robots");
            robot.until("it is kept", () -> author.plan().queries().size() == saved + 1);

            robot.press(VK_F12, VK_CONTROL);
            JTable table = robot.find(JTable.class, "queries-table");
            robot.until("it is answered", () -> "met".equals(String.valueOf(table.getValueAt(saved, 0))));
            robot.clickCell(table, saved, 1);
            robot.press(VK_F12, VK_ALT);
            robot.until("the start is shown", () -> tokens().equals(Set.of("select")));
            robot.press(VK_F12, VK_ALT, VK_SHIFT);
            robot.until("the next marking is shown", () -> tokens().equals(Set.of("locations")));
            robot.press(VK_F11, VK_ALT);
            robot.untilShown("try-out-panel");
            robot.until("the engine has come there", () -> tokens().contains("execute"));
            assertThat(tokens()).containsExactly("execute");
        }
    }

    private Set<String> tokens() {
        return author.window().context().overlay().shown().marking().tokens().keySet();
    }
}
