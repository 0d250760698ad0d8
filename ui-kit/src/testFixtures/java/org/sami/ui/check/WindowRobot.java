package org.sami.ui.check;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Container;
import java.awt.Dimension;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.swing.JLabel;
import javax.swing.JTable;
import org.sami.ui.EventThread;

/** Drives windows as a person does: looks for components by their names, moves the pointer, clicks, types. */
public final class WindowRobot {
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(50);
    private static final int PATIENCE_S = 30;

    private final Robot robot;

    /** A robot on this display.
     *
     * @throws IllegalStateException if the display takes no input
     */
    public WindowRobot() {
        try {
            robot = new Robot();
        } catch (AWTException noInput) {
            throw new IllegalStateException("this display takes no input", noInput);
        }
        robot.setAutoWaitForIdle(true);
    }

    /** Asks something on the event thread. */
    public static <T> T ask(Supplier<T> question) {
        CompletableFuture<T> answer = new CompletableFuture<>();
        EventThread.later(() -> {
            try {
                answer.complete(question.get());
            } catch (RuntimeException | Error fault) {
                answer.completeExceptionally(fault);
            }
        });
        return answer.join();
    }

    /** Waits until something is so; looked at on the event thread. */
    public void until(String what, Supplier<Boolean> so) {
        until(what, PATIENCE_S, so);
    }

    /** Waits until something is so that takes its time. */
    public void until(String what, int withinS, Supplier<Boolean> so) {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(withinS);
        while (!ask(so)) {
            if (System.nanoTime() > end) {
                throw new AssertionError("not within " + withinS + " s: " + what + picture());
            }
            LockSupport.parkNanos(LOOK_NANOS);
        }
    }

    /** What the screen shows, in a file that the failure names. */
    private String picture() {
        Path file = Path.of("build", "window-failure.png").toAbsolutePath();
        Rectangle screen = new Rectangle(Toolkit.getDefaultToolkit().getScreenSize());
        try {
            ImageIO.write(robot.createScreenCapture(screen), "png", file.toFile());
            return "; the screen is in " + file;
        } catch (IOException full) {
            return "; the screen could not be written to " + file + ": " + full.getMessage();
        }
    }

    /** The component of a name that is on the screen; waits for it. */
    public <C extends Component> C find(Class<C> type, String name) {
        return find(type, name, component -> true);
    }

    /** The component of a kind that is on the screen and has no name of ours, such as of a dialog of Swing's; waits for it. */
    public <C extends Component> C find(Class<C> type, Predicate<C> fit) {
        until(
                "a " + type.getSimpleName(),
                () -> look(type, Optional.empty(), fit).isPresent());
        return ask(() -> look(type, Optional.empty(), fit).orElseThrow());
    }

    private <C extends Component> C find(Class<C> type, String name, Predicate<C> fit) {
        until("a component " + name, () -> look(type, Optional.of(name), fit).isPresent());
        return ask(() -> look(type, Optional.of(name), fit).orElseThrow());
    }

    private static <C extends Component> Optional<C> look(Class<C> type, Optional<String> name, Predicate<C> fit) {
        for (Window window : Window.getWindows()) {
            if (window.isShowing()) {
                Optional<C> found = below(window, type, name, fit);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    private static <C extends Component> Optional<C> below(
            Component at, Class<C> type, Optional<String> name, Predicate<C> fit) {
        if (name.map(wanted -> wanted.equals(at.getName())).orElse(true)
                && type.isInstance(at)
                && at.isShowing()
                && fit.test(type.cast(at))) {
            return Optional.of(type.cast(at));
        }
        if (at instanceof Container container) {
            for (Component child : container.getComponents()) {
                Optional<C> found = below(child, type, name, fit);
                if (found.isPresent()) {
                    return found;
                }
            }
        }
        return Optional.empty();
    }

    /** Waits until a component is on the screen. */
    public void untilShown(String name) {
        find(Component.class, name);
    }

    /** Waits until a component has the keyboard's focus. */
    public void untilFocused(String name) {
        find(Component.class, name, Component::isFocusOwner);
    }

    /** Waits until a label says something. */
    public void untilSaid(String label, String text) {
        find(
                JLabel.class,
                label,
                shown -> shown.getText() != null && shown.getText().contains(text));
    }

    /** Clicks into the middle of a component that can be used; waits for it. */
    public void click(String name) {
        Component component = find(Component.class, name, Component::isEnabled);
        Dimension size = ask(component::getSize);
        clickAt(component, size.width / 2, size.height / 2);
    }

    /** Clicks at a place of a component. */
    public void clickAt(Component component, int x, int y) {
        Point at = ask(component::getLocationOnScreen);
        robot.mouseMove(at.x + x, at.y + y);
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    /** Clicks the row of a table whose first column says this. */
    public void clickRow(String table, String first) {
        JTable found = find(JTable.class, table);
        until("a row " + first, () -> rowOf(found, first) >= 0);
        Point at = ask(() -> found.getCellRect(rowOf(found, first), 0, true).getLocation());
        clickAt(found, at.x + 20, at.y + 8);
    }

    private static int rowOf(JTable table, String first) {
        for (int i = 0; i < table.getRowCount(); i++) {
            if (first.equals(table.getValueAt(i, 0))) {
                return i;
            }
        }
        return -1;
    }

    /** Presses a key with others held: {@code press(VK_G, VK_CONTROL)}. */
    public void press(int key, int... held) {
        robot.setAutoWaitForIdle(false); // what a key does may take long, and a held key repeats
        for (int each : held) {
            robot.keyPress(each);
        }
        robot.keyPress(key);
        robot.keyRelease(key);
        for (int i = held.length - 1; i >= 0; i--) {
            robot.keyRelease(held[i]);
        }
        robot.setAutoWaitForIdle(true);
        robot.waitForIdle();
    }

    /** Types small letters, digits, spaces, points and commas. */
    public void type(String text) {
        text.chars().forEach(letter -> press(KeyEvent.getExtendedKeyCodeForChar(letter)));
    }
}
