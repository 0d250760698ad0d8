package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_M;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.nio.file.Path;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.window.DreammWindow;
import org.sami.lessons.course.Course.StepAddress;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.progress.LearnerProgress;
import org.sami.lessons.progress.Learners;
import org.sami.spn.model.Project;
import org.sami.ui.check.WindowRobot;

/** A learner has the window show what a step of the course shows, in the mode of its lesson. */
@Tag("window")
class LessonShowWindowTest {
    @Test
    void theStepOfLessonTwoIsShownByItsKeyAndEndsByEscape(@TempDir Path folder) throws Exception {
        Learners learners = new Learners(folder.resolve("learners"));
        learners.keep(LearnerProgress.of("ada").movedTo(new StepAddress("02-places", "show-add")));
        try (LearnerRobot learner = LearnerRobot.open(folder, CourseFiles.SHIPPED, "ada")) {
            WindowRobot robot = learner.robot;
            learner.untilStep("Show me: adding");
            DreammWindow window = learner.window();
            ProjectDocument document = window.context().document();
            Project mine = WindowRobot.ask(document::project);

            robot.press(VK_M, VK_ALT, VK_SHIFT);
            robot.untilShown("show-bar");
            assertThat(WindowRobot.ask(document::isLent)).isTrue();
            robot.until(
                    "the palette marks the blank transition",
                    () -> marked(window.frame().getContentPane()) > 0);
            robot.until(
                    "an edit is made",
                    () -> document.project().plans().stream()
                            .anyMatch(plan -> !plan.transitions().isEmpty()));
            assertThat(robot.find(JLabel.class, "show-title").getText()).startsWith("Show me: ");

            robot.press(VK_ESCAPE);
            robot.until("it is over", () -> !document.isLent());
            assertThat(WindowRobot.ask(document::project)).isSameAs(mine);
        }
    }

    private static int marked(Container in) {
        for (Component child : in.getComponents()) {
            if (child instanceof JList<?> list && "palette-list".equals(list.getName())) {
                return list.getSelectedIndex();
            }
            int found = child instanceof JComponent inside ? marked(inside) : -1;
            if (found >= 0) {
                return found;
            }
        }
        return -1;
    }
}
