package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_1;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_BACK_SPACE;
import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_DELETE;
import static java.awt.event.KeyEvent.VK_DOWN;
import static java.awt.event.KeyEvent.VK_END;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_F3;
import static java.awt.event.KeyEvent.VK_F4;
import static java.awt.event.KeyEvent.VK_HOME;
import static java.awt.event.KeyEvent.VK_L;
import static java.awt.event.KeyEvent.VK_LEFT;
import static java.awt.event.KeyEvent.VK_PAGE_DOWN;
import static java.awt.event.KeyEvent.VK_Q;
import static java.awt.event.KeyEvent.VK_RIGHT;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_SPACE;
import static java.awt.event.KeyEvent.VK_T;
import static java.awt.event.KeyEvent.VK_UP;
import static java.awt.event.KeyEvent.VK_W;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Rectangle;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.swing.JList;
import javax.swing.JToggleButton;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.window.DreammWindow;
import org.sami.lessons.course.CourseFiles;
import org.sami.lessons.progress.LearnerProgress;
import org.sami.lessons.progress.Learners;
import org.sami.spn.testing.JavaProcess;
import org.sami.ui.check.WindowRobot;

/** Learners go through the course in the real window, by keys and pointer. */
@Tag("window")
class LearnWindowTest {
    private static final int DECORATION_PX = 40;

    @TempDir
    private Path folder;

    private LearnerRobot learner;
    private WindowRobot robot;

    @Test
    void lessonsAreTakenByKeysAndEachKindOfQuizIsAnsweredWronglyAndRightly() throws Exception {
        try (LearnerRobot opened = LearnerRobot.open(folder, LearnerRobot.COURSE, "ada")) {
            learner = opened;
            robot = opened.robot;
            learner.untilStep("Places");
            learner.next();
            chooseOne();
            markElements();
            play();
            DreammWindow first = learner.window();
            Rectangle bounds = bounds();
            learner.next();
            learner.untilStep("Several");
            assertThat(learner.window()).isNotSameAs(first);
            DreammWindow second = learner.window();
            robot.until(
                    "it lies where the first one lay",
                    () -> isAbout(bounds, second.frame().getBounds()));
            chooseSeveral();
            learner.next();
            learner.untilStep("Where");
            learner.next();
            putTokens();
            typeNumber();
            goByContentsAndGlossary();
        }
        LearnerProgress kept =
                new Learners(folder.resolve("learners")).open("ada").progress();
        assertThat(kept.at()).contains("01-one/places");
        assertThat(kept.steps().get("01-one/which").attempts()).isEqualTo(2);
        assertThat(kept.steps().get("02-two/how-many").rightAtOnce()).isFalse();
        assertThat(kept.steps().values().stream().filter(step -> step.done())).hasSize(9);
    }

    private Rectangle bounds() {
        DreammWindow window = learner.window();
        return WindowRobot.ask(() -> window.frame().getBounds());
    }

    /** A window manager may move a window by its title bar or border when it decorates it. */
    private static boolean isAbout(Rectangle one, Rectangle other) {
        return Math.abs(one.x - other.x) <= DECORATION_PX
                && Math.abs(one.y - other.y) <= DECORATION_PX
                && Math.abs(one.width - other.width) <= DECORATION_PX
                && Math.abs(one.height - other.height) <= DECORATION_PX;
    }

    private void choose(String text) {
        for (int i = 1; i <= 3; i++) {
            JToggleButton button = robot.find(JToggleButton.class, "learn-choice-" + i);
            if (text.equals(WindowRobot.ask(() -> button.getAccessibleContext().getAccessibleName()))) {
                robot.click("learn-choice-" + i);
                return;
            }
        }
        throw new AssertionError("nothing says " + text);
    }

    private void chooseOne() {
        learner.untilStep("Which?");
        choose("an edge");
        learner.check();
        learner.untilText("learn-feedback-words-1", "An edge is an arrow.");
        choose("a place");
        learner.check();
        learner.untilText("learn-feedback-words-1", "Places are circles.");
        learner.next();
    }

    private void markElements() {
        learner.untilStep("Mark");
        robot.click("learn-picture");
        robot.untilFocused("learn-picture");
        for (int i = 0; i < 4; i++) {
            robot.press(VK_LEFT);
        }
        robot.press(VK_SPACE);
        learner.check();
        learner.untilText("learn-feedback-words-1", "An end place is a place.");
        for (int i = 0; i < 4; i++) {
            robot.press(VK_RIGHT);
        }
        robot.press(VK_SPACE);
        learner.check();
        learner.untilText("learn-feedback-words-1", "Both circles are places.");
        learner.next();
    }

    private void play() {
        learner.untilStep("Play");
        robot.press(VK_RIGHT, VK_ALT);
        robot.untilSaid("learn-run-where", "Step 1 of 2");
        learner.untilText("learn-run-message", "the mission has ended");
        robot.press(VK_LEFT, VK_ALT);
        robot.untilSaid("learn-run-where", "Step 0 of 2");
        learner.next();
        learner.untilStep("Play freely");
        robot.click("learn-run-choice-1");
        robot.untilSaid("learn-run-where", "Step 1");
        robot.press(VK_HOME, VK_ALT, VK_SHIFT);
        robot.untilSaid("learn-run-where", "Step 0");
    }

    private void chooseSeveral() {
        choose("robots");
        learner.check();
        learner.untilText("learn-feedback-words-1", "Circles are places.");
        robot.press(VK_F4, VK_SHIFT);
        learner.untilText("learn-feedback-words-1", "Places and edges.");
    }

    private void putTokens() {
        learner.untilStep("After");
        robot.click("learn-picture");
        robot.untilFocused("learn-picture");
        for (int i = 0; i < 2; i++) {
            robot.press(VK_LEFT);
        }
        robot.press(VK_DELETE);
        robot.press(VK_RIGHT);
        robot.press(VK_1);
        learner.check();
        learner.untilText("learn-feedback-words-1", "The timer has not expired.");
        robot.press(VK_DELETE);
        robot.press(VK_LEFT);
        robot.press(VK_1);
        learner.check();
        learner.untilText("learn-feedback-words-1", "It waits.");
        robot.press(VK_RIGHT, VK_ALT);
        robot.untilSaid("learn-run-where", "Step 1 of 2");
        learner.next();
    }

    private void typeNumber() {
        learner.untilStep("How many");
        robot.click("learn-number");
        robot.type("3");
        learner.check();
        learner.untilText("learn-feedback-words-1", "The bar is no place.");
        robot.press(VK_BACK_SPACE);
        robot.type("2");
        learner.check();
        learner.untilText("learn-feedback-words-1", "Two.");
    }

    private void goByContentsAndGlossary() {
        robot.press(VK_T, VK_ALT, VK_SHIFT);
        robot.untilFocused("learn-contents-list");
        JList<?> contents = robot.find(JList.class, "learn-contents-list");
        assertThat(WindowRobot.ask(() -> contents.getModel().getSize())).isEqualTo(7);
        robot.press(VK_ESCAPE);
        robot.until("the contents are closed", () -> !contents.isShowing());
        robot.press(VK_W, VK_ALT, VK_SHIFT);
        robot.untilFocused("learn-glossary-words");
        robot.type("circle");
        learner.untilText("learn-glossary-text", "A circle of a net.");
        robot.press(VK_DOWN);
        robot.press(VK_UP);
        robot.press(VK_ENTER);
        learner.untilStep("Places");
    }

    @Test
    void aKilledProcessLosesNothingOfWhatWasLearned() throws Exception {
        Process process = JavaProcess.builder(
                        folder, Dreamm.class, "--learn", "--learner", "ada", "--data", folder.toString())
                .inheritIO()
                .start();
        Learners learners = new Learners(folder.resolve("learners"));
        try {
            robot = new WindowRobot();
            robot.until("the first step is shown", () -> at(learners, "01-motivation/"));
            String first = learners.open("ada").progress().at().orElseThrow();
            for (int i = 0;
                    i < 20 && at(learners, first);
                    i++) { // a key before the window has the focus reaches nobody
                robot.press(VK_PAGE_DOWN, VK_ALT);
            }
            robot.until("the next step is shown", () -> !at(learners, first));
        } finally {
            process.destroyForcibly().waitFor();
        }
        String last = learners.open("ada").progress().at().orElseThrow();
        try (LearnerRobot opened = LearnerRobot.open(folder, CourseFiles.SHIPPED, "ada")) {
            opened.robot.untilShown("learn-step-title");
        }
        assertThat(learners.open("ada").progress().at()).contains(last);
        assertThat(learners.open("ada")
                        .progress()
                        .steps()
                        .get("01-motivation/beach")
                        .done())
                .isTrue();
    }

    private static boolean at(Learners learners, String step) {
        try {
            return learners.open("ada")
                    .progress()
                    .at()
                    .filter(at -> at.startsWith(step))
                    .isPresent();
        } catch (IOException notYet) {
            return false;
        }
    }

    @Test
    void whoOpensDreammForTheFirstTimeIsOfferedTheCourseAndCanLeaveIt() throws Exception {
        try (LearnerRobot opened = LearnerRobot.openForTheFirstTime(folder, LearnerRobot.COURSE)) {
            robot = opened.robot;
            robot.click("learn-offer-yes");
            opened.untilStep("Places");
            assertThat(opened.window().context().vocabulary().events().keySet()).containsExactly("ProxyStationKeep");
            robot.press(VK_Q, VK_ALT, VK_SHIFT);
            robot.untilShown("palette-search");
            assertThat(opened.window().context().vocabulary().events()).hasSizeGreaterThan(50);
            robot.press(VK_L, VK_CONTROL);
            opened.untilStep("Places");
        }
        assertThat(Files.isDirectory(folder.resolve("learners"))).isTrue();
    }

    @Test
    void aPlanOfAJobIsCheckedFailedMendedAndPassedAndKept() throws Exception {
        try (LearnerRobot opened = LearnerRobot.open(folder, LearnerRobot.COURSE, "ada")) {
            learner = opened;
            robot = opened.robot;
            goToTheJob();
            learner.check();
            robot.untilSaid("learn-verdict-head", "Not yet");
            robot.press(VK_F3);
            learner.untilText("learn-help-1-words-1", "Which place comes last?");
            tickTheEnd();
            robot.until("the edit is kept", () -> kept().contains("\"end\": true"));
            learner.check();
            robot.untilSaid("learn-verdict-head", "Passed");
        }
        assertThat(new Learners(folder.resolve("learners"))
                        .open("ada")
                        .progress()
                        .steps()
                        .get("02-two/job")
                        .attempts())
                .isEqualTo(2);
        try (LearnerRobot again = LearnerRobot.open(folder, LearnerRobot.COURSE, "ada")) {
            again.untilStep("Let it end");
            again.robot.untilShown("net-canvas");
            assertThat(WindowRobot.ask(() -> again.document().project())
                            .plan("wait")
                            .orElseThrow()
                            .place("end")
                            .orElseThrow()
                            .end())
                    .isTrue();
        }
    }

    private void goToTheJob() {
        learner.untilStep("Places");
        robot.press(VK_T, VK_ALT, VK_SHIFT);
        robot.untilFocused("learn-contents-list");
        robot.press(VK_END);
        robot.press(VK_ENTER);
        learner.untilStep("Several");
        robot.press(VK_T, VK_ALT, VK_SHIFT);
        robot.untilFocused("learn-contents-list");
        robot.press(VK_END);
        robot.press(VK_ENTER);
        learner.untilStep("Let it end");
    }

    private void tickTheEnd() {
        learner.select("end");
        robot.untilShown("inspector-end");
        robot.click("inspector-end");
    }

    private String kept() {
        try {
            return Files.readString(folder.resolve("learners/ada/jobs/02-two/end.json"));
        } catch (IOException notYet) {
            return "";
        }
    }

    @Test
    void aTermIsOpenedByItsLink() throws Exception {
        try (LearnerRobot opened = LearnerRobot.open(folder, LearnerRobot.COURSE, "ada")) {
            Component text = opened.robot.find(Component.class, "learn-paragraph");
            WindowRobot.ask(text::requestFocusInWindow);
            opened.robot.untilFocused("learn-paragraph");
            opened.robot.press(VK_ENTER);
            opened.untilText("learn-glossary-title", "place");
            opened.untilText("learn-glossary-text", "A circle of a net. Tokens stand in it.");
        }
    }
}
