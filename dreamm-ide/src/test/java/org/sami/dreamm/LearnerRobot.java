package org.sami.dreamm;

import java.awt.Component;
import java.awt.Point;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.document.ProjectDocument;
import org.sami.dreamm.profile.Profile;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.start.DreammOptions;
import org.sami.dreamm.start.FirstProject;
import org.sami.dreamm.start.LearnOptions;
import org.sami.dreamm.window.DreammWindow;
import org.sami.lessons.course.CourseFiles;
import org.sami.palette.Theme;
import org.sami.ui.check.RealDisplay;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.net.NetView;
import org.sami.ui.value.WrappedText;

/** A learner at the real window: goes through lessons by keys and pointer alone, and looks at what is said. */
final class LearnerRobot implements AutoCloseable {
    /** The small course of the tests. */
    static final CourseFiles COURSE = CourseFiles.onClassPath("org/sami/dreamm/learn/course");

    final WindowRobot robot = new WindowRobot();

    private final DreammSession session;
    private final CompletableFuture<Integer> ended;

    private LearnerRobot(DreammSession session, CompletableFuture<Integer> ended) {
        this.session = session;
        this.ended = ended;
    }

    /** Opens the course for a learner; the test is skipped where there is no display. */
    static LearnerRobot open(Path data, CourseFiles course, String learner) throws IOException {
        return open(data, course, new LearnOptions(true, Optional.of(learner)));
    }

    /** Opens the window of an author who has not worked here yet. */
    static LearnerRobot openForTheFirstTime(Path data, CourseFiles course) throws IOException {
        return open(data, course, LearnOptions.NONE);
    }

    private static LearnerRobot open(Path data, CourseFiles course, LearnOptions learn) throws IOException {
        RealDisplay.assumed();
        DreammOptions options = new DreammOptions(
                Optional.empty(), Optional.empty(), Profile.ALL, Optional.of(Theme.LIGHT), Optional.of(100), learn);
        CompletableFuture<Integer> ended = new CompletableFuture<>();
        return new LearnerRobot(
                DreammStart.begin(
                        options, FirstProject.open(options), AuthorDirectory.open(data), course, ended::complete),
                ended);
    }

    /** The window that is open now: another one for each lesson. */
    DreammWindow window() {
        return WindowRobot.ask(session::window);
    }

    /** What the window that is open now works with. */
    DreammContext context() {
        return session.window().context();
    }

    /** The document of the window that is open now. */
    ProjectDocument document() {
        return session.window().context().document();
    }

    /** Clicks a vertex of the net of the editor. */
    void select(String vertex) {
        NetView net = robot.find(NetView.class, "net");
        Point at = WindowRobot.ask(() -> net.drawing().vertices().stream()
                .filter(each -> each.id().equals(vertex))
                .map(each -> net.pixel(each.centre().x(), each.centre().y()))
                .map(pixel -> new Point((int) pixel.getX(), (int) pixel.getY()))
                .findFirst()
                .orElseThrow());
        robot.clickAt(net.canvas(), at.x, at.y);
    }

    /** Goes on by its key. */
    void next() {
        robot.press(KeyEvent.VK_PAGE_DOWN, KeyEvent.VK_ALT);
    }

    /** Goes back by its key. */
    void back() {
        robot.press(KeyEvent.VK_PAGE_UP, KeyEvent.VK_ALT);
    }

    /** Checks the answer, or the plan, by its key. */
    void check() {
        robot.press(KeyEvent.VK_F4);
    }

    /** Waits until a step is shown. */
    void untilStep(String title) {
        untilText("learn-step-title", title);
    }

    /** Waits until a text says something. */
    void untilText(String name, String words) {
        robot.until(name + " says " + words, () -> textNow(name).contains(words));
    }

    /** What a text says. */
    String text(String name) {
        return WindowRobot.ask(() -> textNow(name));
    }

    private static String textNow(String name) {
        StringBuilder all = new StringBuilder();
        for (java.awt.Window window : java.awt.Window.getWindows()) {
            if (window.isShowing()) {
                collect(window, name, all);
            }
        }
        return all.toString();
    }

    private static void collect(Component at, String name, StringBuilder all) {
        if (name.equals(at.getName()) && at.isShowing() && at instanceof WrappedText text) {
            all.append(text.getText()).append('\n');
        }
        if (at instanceof java.awt.Container container) {
            for (Component each : container.getComponents()) {
                collect(each, name, all);
            }
        }
    }

    @Override
    public void close() throws Exception {
        WindowRobot.ask(() -> {
            session.window().end();
            return null;
        });
        ended.get(300, TimeUnit.SECONDS);
    }
}
