package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_5;
import static java.awt.event.KeyEvent.VK_6;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_DELETE;
import static java.awt.event.KeyEvent.VK_END;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_F11;
import static java.awt.event.KeyEvent.VK_F5;
import static java.awt.event.KeyEvent.VK_F6;
import static java.awt.event.KeyEvent.VK_F7;
import static java.awt.event.KeyEvent.VK_F9;
import static java.awt.event.KeyEvent.VK_J;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_Z;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import javax.swing.JMenuItem;
import javax.swing.JTable;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.replay.RecordedSession;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TestCase;
import org.sami.ui.check.WindowRobot;

/** A plan that ships is tried, checked and looked at again in the real window, by pointer and keys. */
@Tag("window")
class TryOutWindowTest {
    private static final String PLAN = "clv";

    private AuthorRobot author;
    private WindowRobot robot;

    @Test
    void planIsTriedCheckedMendedAndAJournalReplayedOnIt(@TempDir Path folder) throws Exception {
        Path journal = RecordedSession.write(folder.resolve("session.journal"));
        try (AuthorRobot opened =
                AuthorRobot.open(folder.resolve("data"), Optional.of(PLAN), Optional.empty(), Profile.ALL)) {
            author = opened;
            robot = opened.robot;
            robot.press(VK_6, VK_ALT);
            robot.untilShown("try-out-panel");
            stepOnAndBack();
            stopAtABreakpoint();
            putAnOccurrenceIn();
            startFromAMarkingAndKeepIt();
            mendAnIssue();
            playWhatADeepCheckFound();
            replay(journal);
        }
    }

    private void stepOnAndBack() {
        robot.press(VK_F5);
        robot.untilSaid("try-where", "step 0");
        author.click("boats-chosen");
        robot.press(VK_F6, VK_CONTROL);
        robot.untilSaid("notice", "Boats chosen: ");
        robot.press(VK_F6);
        robot.untilSaid("try-where", "step 1");
        robot.until("the net shows where the boats are", () -> tokens().contains("locations"));
        robot.press(VK_F7);
        robot.untilSaid("try-where", "step 0");
        robot.until("the tokens are back", () -> tokens().equals(Set.of("select")));
    }

    private void stopAtABreakpoint() {
        author.click("choose");
        robot.press(VK_F9, VK_CONTROL);
        robot.press(VK_F9);
        robot.untilSaid("notice", "Stopped at the breakpoint at Choose allocation");
        robot.until("the boats stand there", () -> tokens().contains("choose"));
        robot.press(VK_F9, VK_CONTROL);
    }

    /** What robots answer is left to the author, who lets a path fail. */
    private void putAnOccurrenceIn() {
        robot.press(VK_F6);
        robot.until("the boats are under way", () -> tokens().contains("execute"));
        robot.click("try-robots-answer");
        JTable possibleSteps = robot.find(JTable.class, "try-possible-steps");
        int row = row(possibleSteps, 1, "Proxy Path Failed");
        robot.clickCell(possibleSteps, row, 1);
        robot.click("try-happen");
        robot.until("the boat has stopped", () -> tokens().contains("stopped"));
        robot.click("try-robots-answer");
        robot.press(VK_F5, VK_SHIFT);
        robot.until("nothing is tried", () -> tokens().isEmpty());
    }

    private void startFromAMarkingAndKeepIt() {
        author.tab("try-tab-marking");
        author.click("locations");
        robot.click("marking-robot-1");
        robot.click("marking-robot-2");
        robot.click("try-start-at");
        robot.untilSaid("try-where", "step 0");
        robot.until("the run begins there", () -> tokens().equals(Set.of("locations")));
        robot.press(VK_F6);
        robot.untilSaid("try-where", "step 1");
        int cases = plan().testCases().size();
        author.tab("try-tab-cases");
        author.write("case-name", "from the middle");
        robot.until("the run is kept", () -> plan().testCases().size() == cases + 1);
        assertThat(WindowRobot.ask(() -> plan().testCases()))
                .last()
                .satisfies(kept -> assertThat(kept.start()).isPresent())
                .extracting(TestCase::name)
                .isEqualTo("from the middle");
        robot.press(VK_F11, VK_CONTROL);
        robot.untilSaid("cases-message", cases + 1 + " passed, 0 failed");
    }

    /** An edge is drawn that asks for nothing: the counter tells it, a click shows it, a key mends it. */
    private void mendAnIssue() {
        robot.press(VK_5, VK_ALT);
        robot.untilShown("issues-panel");
        robot.untilSaid("count-errors", "0");
        author.connect("boats-chosen", "finished");
        robot.untilSaid("count-errors", "1");
        robot.clickRow("issues-table", "E-NO-REQUIREMENT");
        robot.until("the edge is marked", () -> context().editor().highlight().size() == 1);
        robot.press(VK_ENTER, VK_ALT);
        robot.untilSaid("count-errors", "0");
        robot.press(VK_Z, VK_CONTROL);
        robot.untilSaid("count-errors", "1");
        robot.press(VK_Z, VK_CONTROL);
        robot.untilSaid("count-errors", "0");
    }

    /** Nobody is asked any more what becomes of a boat that has stopped: the search finds the way to where the mission hangs, and plays it. */
    private void playWhatADeepCheckFound() {
        robot.click("net-mode-all"); // the answers are recovery parts
        author.showAll();
        for (String answer : List.of("leave-out", "not-left-out")) {
            author.click(answer);
            robot.press(VK_DELETE);
            robot.until(answer + " is gone", () -> plan().transition(answer).isEmpty());
        }
        robot.untilSaid("count-errors", "0");
        robot.click("deep-checks");
        JMenuItem stuck = robot.find(JMenuItem.class, item -> "Stuck states".equals(item.getText()));
        robot.clickAt(stuck, 20, 10);
        robot.clickRow("issues-table", "W-STUCK");
        robot.press(VK_ENTER, VK_ALT, VK_SHIFT);
        robot.untilShown("try-out-panel");
        robot.until("the run leads to where it hangs", () -> tokens().contains("stopped"));
        robot.press(VK_F5, VK_SHIFT);
        robot.press(VK_Z, VK_CONTROL);
        robot.press(VK_Z, VK_CONTROL);
        robot.until("the answers are back", () -> plan().transition("leave-out").isPresent());
    }

    private void replay(Path journal) {
        robot.press(VK_J, VK_CONTROL, VK_SHIFT);
        author.giveFile(journal);
        robot.untilSaid("replay-file", "session.journal");
        robot.untilFocused("time-line");
        robot.press(VK_END);
        robot.until("the boats stand where they stood at the end", () -> tokens().contains("locations"));
        JTable missions = robot.find(JTable.class, "replay-missions");
        assertThat(WindowRobot.ask(() -> missions.getValueAt(0, 0))).isEqualTo("Visit");
    }

    private DreammContext context() {
        return author.window().context();
    }

    private Plan plan() {
        return context().document().plan(PLAN).orElseThrow();
    }

    private Set<String> tokens() {
        return context().overlay().shown().marking().tokens().keySet();
    }

    private int row(JTable table, int column, String words) {
        robot.until(words + " can happen", () -> rowOf(table, column, words) >= 0);
        return WindowRobot.ask(() -> rowOf(table, column, words));
    }

    private static int rowOf(JTable table, int column, String words) {
        for (int i = 0; i < table.getRowCount(); i++) {
            if (table.getValueAt(i, column).toString().startsWith(words)) {
                return i;
            }
        }
        return -1;
    }
}
