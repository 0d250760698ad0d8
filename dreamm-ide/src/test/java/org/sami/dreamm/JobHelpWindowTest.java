package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_F3;
import static java.awt.event.KeyEvent.VK_F4;
import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import javax.swing.JButton;
import javax.swing.JLabel;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.progress.LearnerProgress;
import org.sami.lessons.progress.Learners;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.command.CommandRegistry;

/** What a learner has after a plan of a job was refused: the run that went wrong, hints, an example, and at last a solution to compare with. */
@Tag("window")
class JobHelpWindowTest {
    @TempDir
    private Path folder;

    private LearnerRobot at(CourseFiles course, String lesson, String step) throws Exception {
        new Learners(folder.resolve("learners")).keep(LearnerProgress.of("ada").movedTo(new StepAddress(lesson, step)));
        return LearnerRobot.open(folder, course, "ada");
    }

    @Test
    void theRunThatWentWrongIsPlayedInTryItOnTheLearnersPlan() throws Exception {
        try (LearnerRobot learner = at(LearnerRobot.COURSE, "02-two", "job")) {
            WindowRobot robot = learner.robot;
            learner.untilStep("Let it end");
            learner.check();
            robot.untilSaid("learn-verdict-head", "Not yet");
            robot.press(VK_F4, VK_CONTROL);
            robot.untilShown("try-out-panel");
            CommandRegistry commands = learner.window().context().commands();
            robot.until(
                    "steps of the run were taken",
                    () -> commands.get("try-back").whyNot().isEmpty());
        }
    }

    @Test
    void theSolutionComesLastAndIsComparedWithTheLearnersPlan() throws Exception {
        try (LearnerRobot learner = at(LearnerRobot.COURSE, "02-two", "job")) {
            WindowRobot robot = learner.robot;
            learner.untilStep("Let it end");
            askForAllHelp(learner);
            robot.untilShown("comparison");
            robot.untilSaid("comparison-title", "one difference from the solution");
        }
    }

    @Test
    void aModeWithoutTheComparisonShowsItOverThePanels() throws Exception {
        try (LearnerRobot learner = at(CourseFiles.SHIPPED, "02-places", "job-visit")) {
            WindowRobot robot = learner.robot;
            robot.untilShown("learn-job");
            askForAllHelp(learner);
            robot.untilShown("comparison-sheet");
            robot.untilFocused("comparison-differences");
            JLabel title = robot.find(JLabel.class, "comparison-title");
            assertThat(title.getText()).contains("from the solution");
            robot.press(VK_ESCAPE);
            robot.until("the sheet is closed", () -> !title.isShowing());
            robot.press(VK_F3, VK_CONTROL);
            robot.until("it is shown again", title::isShowing);
        }
    }

    @Test
    void checkingIsTheFirstButtonUntilTheJobHasPassed() throws Exception {
        try (LearnerRobot learner = at(LearnerRobot.COURSE, "02-two", "job")) {
            WindowRobot robot = learner.robot;
            learner.untilStep("Let it end");
            JButton check = robot.find(JButton.class, "learn-check");
            JButton next = robot.find(JButton.class, "learn-next");
            assertThat(WindowRobot.ask(() -> isFirst(check))).isTrue();
            assertThat(WindowRobot.ask(() -> isFirst(next))).isFalse();
            learner.select("end");
            robot.untilShown("inspector-end");
            robot.click("inspector-end");
            learner.check();
            robot.untilSaid("learn-verdict-head", "Passed");
            robot.until("the way on comes first", () -> isFirst(next) && !isFirst(check));
        }
    }

    private static boolean isFirst(JButton button) {
        return button.getClientProperty("FlatLaf.style") != null;
    }

    private static void askForAllHelp(LearnerRobot learner) {
        CommandRegistry commands = learner.window().context().commands();
        learner.robot.until("a hint can be asked for", () -> canHint(commands));
        while (WindowRobot.ask(() -> canHint(commands))) {
            learner.robot.press(VK_F3);
        }
    }

    private static boolean canHint(CommandRegistry commands) {
        return commands.get("learn-hint").whyNot().isEmpty();
    }
}
