package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_N;
import static java.awt.event.KeyEvent.VK_P;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_Z;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Point;
import java.awt.Rectangle;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.swing.JLabel;
import javax.swing.JTree;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.profile.Profile;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.ui.check.WindowRobot;

/** What is dragged in the real window: items of the palette onto the net, lines of the mission tree; and what another program wrote. */
@Tag("window")
class DragWindowTest {
    @Test
    void itemsBecomeWhatTheyAreDroppedOntoAndLinesOfTheTreeChangeTheirOrder(@TempDir Path folder) throws Exception {
        try (AuthorRobot author =
                AuthorRobot.open(folder.resolve("data"), Optional.empty(), Optional.empty(), Profile.ALL)) {
            author.robot.press(VK_N, VK_CONTROL);
            author.robot.until(
                    "a new project is open",
                    () -> author.document().project().plans().size() == 1);
            String empty = author.text();
            dropOntoFreeSpace(author);
            dropOntoVertices(author);
            dropARole(author);
            while (WindowRobot.ask(() -> author.document().undoLabel().isPresent())) {
                author.robot.press(VK_Z, VK_CONTROL);
            }
            assertThat(author.text()).as("all of it undone").isEqualTo(empty);

            orderTheTree(author);
            importPositions(author, folder.resolve("beach.txt"));
        }
    }

    private static void dropOntoFreeSpace(AuthorRobot author) {
        assertThat(author.drag("start system timer", "Start System Timer", new Point(150, 120)))
                .isTrue();
        author.robot.until(
                "the place is there with what follows",
                () -> plan(author).transitions().size() == 1);
        assertThat(author.plan().places()).hasSize(2);
        assertThat(author.place("StartSystemTimer")).isNotEmpty();

        assertThat(author.drag("operator interrupt received", "Operator Interrupt Received", new Point(200, 320)))
                .isTrue();
        author.robot.until(
                "the transition is there",
                () -> plan(author).transitions().stream()
                        .anyMatch(
                                t -> t.inputs().stream().anyMatch(i -> i.type().equals("OperatorInterruptReceived"))));
        author.showAll();
    }

    private static void dropOntoVertices(AuthorRobot author) {
        String timer = author.place("StartSystemTimer");

        assertThat(author.drag("display message", "Display Message", author.at(timer)))
                .isTrue();
        author.robot.until(
                "the message stands on the place",
                () -> plan(author).place(timer).orElseThrow().outputs().size() == 2);

        String before = author.text();
        author.mark("timer expired", "Timer Expired");
        JLabel notice = author.robot.find(JLabel.class, "notice");
        assertThat(author.robot.dragInVain(
                        author.palette(),
                        author.marked(),
                        author.net().canvas(),
                        author.at(timer),
                        () -> notice.getText().startsWith("Timer Expired is an input event: it stands on transitions")))
                .isFalse();
        assertThat(author.text()).isEqualTo(before);
    }

    private static void dropARole(AuthorRobot author) {
        String timer = author.place("StartSystemTimer");
        String over = author.transition("TimerExpired");

        assertThat(author.drag("camera", "Task: Camera", author.onEdge(timer, over)))
                .isTrue();

        author.robot.until("the plan has the task", () -> plan(author).tasks().size() == 1);
        assertThat(author.plan().inEdges())
                .filteredOn(e -> e.place().equals(timer) && e.transition().equals(over))
                .allSatisfy(e -> assertThat(e.requirements())
                        .contains(new InRequirement(TokenKind.TASK, Match.AT_LEAST, 1, "Camera")));
        assertThat(author.drag("camera", "Task: Camera", new Point(20, 20))).isTrue();
        author.robot.until(
                "free space declares another", () -> plan(author).tasks().size() == 2);
    }

    private static void orderTheTree(AuthorRobot author) {
        author.robot.press(VK_N, VK_CONTROL, VK_SHIFT);
        author.robot.untilFocused("name-bar-name");
        author.robot.type("second");
        author.robot.press(VK_ENTER);
        author.robot.until("there are two plans", () -> plans(author).equals(List.of("plan", "second")));
        JTree tree = author.robot.find(JTree.class, "mission-tree-lines");
        Rectangle first = WindowRobot.ask(() -> tree.getRowBounds(1));
        Rectangle second = WindowRobot.ask(() -> tree.getRowBounds(2));

        assertThat(author.robot.drag(
                        tree,
                        new Point(second.x + 40, second.y + second.height / 2),
                        tree,
                        new Point(first.x + 40, first.y + 2)))
                .isTrue();

        author.robot.until("the second is the first", () -> plans(author).equals(List.of("second", "plan")));
        author.robot.press(VK_Z, VK_CONTROL);
        author.robot.until("the order is taken back", () -> plans(author).equals(List.of("plan", "second")));
    }

    /** A text file of positions becomes a variable; what its brackets mean is asked. */
    private static void importPositions(AuthorRobot author, Path file) throws Exception {
        Files.writeString(file, "[\n45.7,10.72\n45.701,10.721\n45.7,10.722\n]\n");
        author.robot.press(VK_P, VK_CONTROL, VK_SHIFT);
        author.robot.untilFocused("command-search-text");
        author.robot.type("import locations");
        author.robot.press(VK_ENTER);
        author.giveFile(file);
        author.robot.click("geometry-area");
        author.robot.until(
                "the variable is declared",
                () -> author.document().project().globals().stream()
                        .anyMatch(variable -> variable.name().equals("@beach")
                                && variable.initial().isPresent()));
    }

    private static Plan plan(AuthorRobot author) {
        return author.window().context().editor().plan().orElseThrow();
    }

    private static List<String> plans(AuthorRobot author) {
        return author.document().project().plans().stream().map(Plan::id).toList();
    }
}
