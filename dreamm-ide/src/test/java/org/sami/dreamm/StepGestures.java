package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_1;
import static java.awt.event.KeyEvent.VK_ALT;
import static java.awt.event.KeyEvent.VK_DELETE;
import static java.awt.event.KeyEvent.VK_DOWN;
import static java.awt.event.KeyEvent.VK_ENTER;
import static java.awt.event.KeyEvent.VK_PAGE_DOWN;
import static java.awt.event.KeyEvent.VK_RIGHT;
import static java.awt.event.KeyEvent.VK_SHIFT;
import static java.awt.event.KeyEvent.VK_T;
import static java.awt.event.KeyEvent.VK_UP;

import java.awt.Component;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JScrollBar;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.JToggleButton;
import org.sami.dreamm.learn.QuizModel;
import org.sami.dreamm.learn.TokenDraft;
import org.sami.dreamm.learn.view.PicturePoints;
import org.sami.lessons.course.Course;
import org.sami.lessons.course.Lesson;
import org.sami.lessons.course.QuizGrader;
import org.sami.lessons.course.QuizQuestion;
import org.sami.lessons.course.Response;
import org.sami.lessons.course.Step;
import org.sami.lessons.course.TokensAt;
import org.sami.spn.protocol.Token;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.check.WindowRobot;

/** Goes through the steps of a lesson as a learner does: goes to them by the contents, reads on by Enter, plays, and answers quizzes rightly. */
final class StepGestures {
    private static final int SEED = 1;
    private static final int MOST_CLICKS = 40;

    private final LearnerRobot learner;
    private final WindowRobot robot;
    private final Course course;
    private final QuizGrader grader;

    StepGestures(LearnerRobot learner, Course course, Vocabulary vocabulary) {
        this.learner = learner;
        this.robot = learner.robot;
        this.course = course;
        grader = new QuizGrader(course, vocabulary);
    }

    /** Goes to a step by the contents: first to its lesson, where another is taken. */
    void go(Lesson lesson, Step step) {
        Lesson now = lessonNow();
        if (!now.id().equals(lesson.id())) {
            int steps = course.lessons().indexOf(now) < course.lessons().indexOf(lesson)
                    ? now.steps().size()
                    : 0;
            choose(course.lessons().indexOf(lesson) + steps);
            robot.untilSaid("learn-lesson", lesson.heading());
        }
        choose(course.lessons().indexOf(lesson) + 1 + lesson.steps().indexOf(step));
        learner.untilStep(step.title());
    }

    private Lesson lessonNow() {
        JLabel shown = robot.find(JLabel.class, "learn-lesson");
        String heading = WindowRobot.ask(shown::getText);
        return course.lessons().stream()
                .filter(each -> each.heading().equals(heading))
                .findFirst()
                .orElseThrow();
    }

    private void choose(int row) {
        robot.press(VK_T, VK_ALT, VK_SHIFT);
        robot.untilFocused("learn-contents-list");
        JList<?> list = robot.find(JList.class, "learn-contents-list");
        for (int at = WindowRobot.ask(list::getSelectedIndex); at != row; at += at < row ? 1 : -1) {
            robot.press(at < row ? VK_DOWN : VK_UP);
        }
        robot.until("the line " + row + " is marked", () -> list.getSelectedIndex() == row);
        robot.press(VK_ENTER);
        robot.until("the contents are closed", () -> !list.isShowing());
    }

    /** Takes a step that is no job, and goes on to the next one by Enter at the panel's button. */
    void take(Lesson lesson, Step step) {
        learner.untilStep(step.title());
        if (step instanceof Step.Quiz quiz) {
            answer(lesson, quiz);
        } else if (step instanceof Step.Play) {
            robot.press(VK_RIGHT, VK_ALT);
            robot.untilSaid("learn-run-where", "Step 1");
        }
        next();
    }

    void next() {
        Component button = robot.find(Component.class, "learn-next");
        if (WindowRobot.ask(button::isFocusOwner)) {
            robot.press(VK_ENTER);
        } else {
            robot.press(VK_PAGE_DOWN, VK_ALT);
        }
    }

    // ---- Quizzes

    private void answer(Lesson lesson, Step.Quiz quiz) {
        Response right = grader.right(lesson, quiz);
        if (right instanceof Response.Choice one) {
            choose(quiz, List.of(one.index()));
        } else if (right instanceof Response.Choices several) {
            choose(quiz, List.copyOf(several.indices()));
        } else if (right instanceof Response.Marks marks) {
            marks.ids().forEach(this::clickInPicture);
        } else if (right instanceof Response.Tokens tokens) {
            put(lesson, quiz, tokens.tokens());
        } else if (right instanceof Response.Amount amount) {
            JTextField field = robot.find(JTextField.class, "learn-number");
            robot.scrollTo(field);
            robot.click(field);
            robot.type(Integer.toString(amount.number()));
        }
        learner.check();
        JLabel head = robot.find(JLabel.class, "learn-feedback-head");
        String said = WindowRobot.ask(head::getText);
        if (!said.equals("Right")) {
            throw new AssertionError(quiz.id() + ": the right answer is not taken: " + said);
        }
    }

    private void choose(Step.Quiz quiz, List<Integer> indices) {
        List<QuizQuestion.Choice> choices = quiz.ask() instanceof QuizQuestion.One one
                ? one.choices()
                : ((QuizQuestion.Several) quiz.ask()).choices();
        for (int index : indices) {
            String text = choices.get(index).text();
            JToggleButton button = robot.find(
                    JToggleButton.class,
                    each -> text.equals(each.getAccessibleContext().getAccessibleName()) && isChoice(each));
            robot.scrollTo(button);
            robot.click(button);
        }
    }

    private static boolean isChoice(Component button) {
        return button.getName() != null && button.getName().startsWith("learn-choice-");
    }

    private void clickInPicture(String element) {
        JComponent picture = robot.find(JComponent.class, "learn-picture");
        Point at = WindowRobot.still(() -> PicturePoints.of(picture, element));
        JScrollPane pane = robot.find(JScrollPane.class, "learn-picture-pane");
        aside(pane, picture, at);
        robot.scrollTo(pane, new Rectangle(0, at.y, 1, 1));
        robot.clickAt(picture, at.x, at.y);
    }

    /** Clicks next to the thumb of the bar below a wide picture until a point of it is in sight. */
    private void aside(JScrollPane pane, JComponent picture, Point at) {
        for (int i = 0; i < MOST_CLICKS && !WindowRobot.ask(() -> isBeside(picture, at)); i++) {
            JScrollBar bar = pane.getHorizontalScrollBar();
            robot.scrollTo(pane, WindowRobot.ask(() -> new Rectangle(0, pane.getHeight() - 2, 1, 1)));
            boolean right =
                    WindowRobot.ask(() -> at.x > picture.getVisibleRect().getCenterX());
            Dimension size = WindowRobot.ask(bar::getSize);
            robot.clickAt(bar, right ? size.width - 4 : 4, size.height / 2);
        }
    }

    private static boolean isBeside(JComponent picture, Point at) {
        Rectangle shown = ((JComponent) picture.getParent()).getBounds();
        int x = at.x + picture.getX();
        return x > 4 && x < shown.width - 4;
    }

    private void put(Lesson lesson, Step.Quiz quiz, List<TokensAt> right) {
        List<Token> kinds = new QuizModel(lesson, quiz, grader, SEED).tokenKinds();
        List<TokensAt> begin = quiz.picture().map(picture -> picture.tokens()).orElse(List.of());
        for (TokensAt at : begin) {
            clickInPicture(at.place());
            robot.press(VK_DELETE);
        }
        for (TokensAt at : right) {
            clickInPicture(at.place());
            for (Token token : TokenDraft.marking(List.of(at)).at(at.place())) {
                robot.press(VK_1 + kinds.indexOf(token));
            }
        }
    }

    /** Checks the plan of the job that is shown by the panel's button; what is said of it. */
    String checkPlan() {
        robot.click("learn-check");
        JLabel head = robot.find(JLabel.class, "learn-verdict-head");
        return WindowRobot.ask(head::getText) + ": " + learner.text("learn-verdict-words-1");
    }
}
