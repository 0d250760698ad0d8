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
import java.util.stream.Stream;
import javax.swing.JList;
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

            Component link = robot.find(Component.class, "word-go");
            robot.restAt(link, link.getWidth() / 2, link.getHeight() / 2);
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

    private static boolean isShown(String name) {
        return Stream.of(Window.getWindows()).filter(Window::isShowing).anyMatch(window -> isIn(window, name));
    }

    private static boolean isIn(Component at, String name) {
        return (name.equals(at.getName()) && at.isShowing())
                || (at instanceof Container container
                        && Stream.of(container.getComponents()).anyMatch(each -> isIn(each, name)));
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
