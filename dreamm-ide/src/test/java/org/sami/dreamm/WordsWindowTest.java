package org.sami.dreamm;

import static java.awt.event.KeyEvent.VK_CONTROL;
import static java.awt.event.KeyEvent.VK_ESCAPE;
import static java.awt.event.KeyEvent.VK_F1;
import static java.awt.event.KeyEvent.VK_SPACE;
import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.Container;
import java.awt.Rectangle;
import java.awt.Window;
import java.nio.file.Path;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JFrame;
import javax.swing.JList;
import javax.swing.SwingUtilities;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.dreamm.palette.PaletteItem;
import org.sami.dreamm.start.AuthorDirectory;
import org.sami.dreamm.window.DreammWindow;
import org.sami.lessons.course.CourseFiles;
import org.sami.ui.check.WindowRobot;
import org.sami.ui.window.WindowSettings;

/** The words of the course are explained anywhere in the window, under the pointer and by a key. */
@Tag("window")
class WordsWindowTest {
    private static final int TRIES = 5;

    @TempDir
    private Path folder;

    @Test
    void aTermUnderThePointerIsExplainedWithALinkToItsLesson() throws Exception {
        try (LearnerRobot opened = LearnerRobot.openForTheFirstTime(folder, CourseFiles.SHIPPED)) {
            WindowRobot robot = opened.robot;
            Rectangle row = palette(robot, "Proxy Execute Path");
            JList<?> list = robot.find(JList.class, "palette-list");
            robot.restAt(list, row.x + row.width / 2, row.y + row.height / 2);
            opened.untilText("word-term", "output event");
            opened.untilText("word-text", "place");
            Component card = robot.find(Component.class, "word-card");
            assertThat(WindowRobot.ask(() -> covers(card, list)))
                    .as("other rows are hidden")
                    .isFalse();

            // the card goes where the pointer takes too long to come to it, as on a busy machine: one points at the
            // word again
            for (int i = 0; i < TRIES && !reached(robot, "word-go"); i++) {
                robot.restAt(list, row.x + row.width / 2, row.y + row.height / 2);
                opened.untilText("word-term", "output event");
            }
            robot.click("word-go");
            opened.untilStep("Output events");
        }
    }

    @Test
    void aKeyExplainsTheWordsOfWhatHasTheFocus() throws Exception {
        try (LearnerRobot opened = LearnerRobot.openForTheFirstTime(folder, CourseFiles.SHIPPED)) {
            WindowRobot robot = opened.robot;
            robot.press(VK_SPACE, VK_CONTROL);
            robot.untilFocused("palette-search");
            robot.type("execute path");
            robot.press(VK_F1, VK_CONTROL);
            opened.untilText("word-term", "output event");
            robot.untilFocused("word-go");
            robot.press(VK_ESCAPE);
            robot.until("the words are gone", () -> !isShown("word-card"));
            robot.untilFocused("palette-search");
            robot.press(VK_F1, VK_CONTROL);
            robot.untilFocused("word-go");
            robot.press(VK_SPACE);
            opened.untilStep("Output events");
        }
    }

    @Test
    void explainingUnderThePointerCanBeTurnedOff() throws Exception {
        try (LearnerRobot opened = LearnerRobot.openForTheFirstTime(folder, CourseFiles.SHIPPED)) {
            DreammWindow window = opened.window();
            WindowRobot.ask(() -> {
                window.context().commands().get("words-hover").run();
                return null;
            });
            assertThat(new WindowSettings(AuthorDirectory.open(folder).settings()).text("words-hover"))
                    .isEqualTo("off");
        }
    }

    /** Moves the pointer as a hand does onto what goes away by itself; whether it is still there then. */
    private static boolean reached(WindowRobot robot, String name) {
        Optional<JFrame> frame = WindowRobot.ask(() -> shown(name)
                .map(SwingUtilities::getWindowAncestor)
                .filter(JFrame.class::isInstance)
                .map(JFrame.class::cast));
        Optional<Rectangle> at = WindowRobot.ask(() -> shown(name)
                .filter(found -> frame.isPresent())
                .map(found -> SwingUtilities.convertRectangle(
                        found.getParent(), found.getBounds(), frame.get().getContentPane())));
        at.ifPresent(target -> robot.restAt(
                frame.orElseThrow().getContentPane(), (int) target.getCenterX(), (int) target.getCenterY()));
        return at.isPresent() && isShown(name);
    }

    private static boolean isShown(String name) {
        return WindowRobot.ask(() -> shown(name).isPresent());
    }

    private static Optional<Component> shown(String name) {
        return Stream.of(Window.getWindows())
                .filter(Window::isShowing)
                .flatMap(window -> below(window, name))
                .findFirst();
    }

    private static Stream<Component> below(Component at, String name) {
        Stream<Component> self = name.equals(at.getName()) && at.isShowing() ? Stream.of(at) : Stream.empty();
        return at instanceof Container container
                ? Stream.concat(self, Stream.of(container.getComponents()).flatMap(each -> below(each, name)))
                : self;
    }

    private static Rectangle palette(WindowRobot robot, String label) {
        JList<?> list = robot.find(JList.class, "palette-list");
        return WindowRobot.ask(() -> {
            for (int i = 0; i < list.getModel().getSize(); i++) {
                if (list.getModel().getElementAt(i) instanceof PaletteItem item
                        && item.label().equals(label)) {
                    list.ensureIndexIsVisible(i);
                    return list.getCellBounds(i, i);
                }
            }
            throw new AssertionError("the palette has no " + label);
        });
    }

    private static boolean covers(Component card, Component list) {
        return new Rectangle(card.getLocationOnScreen(), card.getSize())
                .intersects(new Rectangle(
                        list.getParent().getLocationOnScreen(), list.getParent().getSize()));
    }
}
