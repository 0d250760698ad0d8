package org.sami.ui.check;

import java.awt.AWTException;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.Toolkit;
import java.awt.dnd.DragSource;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Predicate;
import java.util.function.Supplier;
import javax.imageio.ImageIO;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.SwingUtilities;
import org.sami.ui.EventThread;

/** Drives windows as a person does: looks for components by their names, moves the pointer, clicks, types. */
public final class WindowRobot {
    private static final long LOOK_NANOS = TimeUnit.MILLISECONDS.toNanos(20);
    private static final int PATIENCE_S = 300;
    private static final int STEPS = 8;
    private static final int DRAG_STEP_PX = 8; // the display tells of no drag until the pointer is 4 px away
    private static final int GLIDE_PX = 20;
    private static final int GLIDE_MS = 5;
    private static final int STEP_HANDLED_WITHIN_MS = 200; // outside of the windows of this process no step is seen
    private static final int EDGE_PX = 4; // as near to a pane's edge something counts as out of sight
    private static final int TWICE_WITHIN_MS = 120; // as a hand does
    private static final int HANDLED_WITHIN_MS =
            3_000; // what comes to no window of this process is waited for no longer

    private final Robot robot;
    private final HandledInput handled = HandledInput.instance();
    private int struck;

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
    }

    /** Strikes keys once they come to a window of this process, and returns once the last of them has been handled. */
    private void keys(Runnable input) {
        until("a window has the keyboard", ShownComponents::haveTheKeyboardOrAreNone);
        long before = handled.counted(KeyEvent.KEY_RELEASED);
        struck = 0;
        input.run();
        await(KeyEvent.KEY_RELEASED, before + struck);
    }

    /** Does something with the pointer, and returns once what is expected of it has been handled. */
    private void act(int event, int times, Runnable input) {
        long before = handled.counted(event);
        input.run();
        await(event, before + times);
    }

    private void await(int event, long many) {
        if (!handled.await(event, many, HANDLED_WITHIN_MS)) {
            robot.waitForIdle();
        }
        settle();
    }

    /** Where a component lies on the screen, once it lies still. */
    private static Point placeOf(Component component) {
        return still(component::getLocationOnScreen);
    }

    /** What is seen on the event thread, once it is the same after all that was under way there. */
    public static <T> T still(Supplier<T> look) {
        T at = ask(look);
        settle();
        T now = ask(look);
        while (!now.equals(at)) {
            at = now;
            settle();
            now = ask(look);
        }
        return now;
    }

    /** Returns once what is queued for the event thread is done, and what that has queued. */
    private static void settle() {
        ask(() -> null);
        ask(() -> null);
    }

    /** Asks something on the event thread; there, at once. */
    public static <T> T ask(Supplier<T> question) {
        if (SwingUtilities.isEventDispatchThread()) {
            return question.get();
        }
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
        boolean isLast = false; // a look that began in time may have waited for the event thread until long after
        while (!ask(so)) {
            if (isLast) {
                throw new AssertionError("not within " + withinS + " s: " + what + picture());
            }
            LockSupport.parkNanos(LOOK_NANOS);
            isLast = System.nanoTime() > end;
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
                () -> ShownComponents.find(type, Optional.empty(), fit).isPresent());
        return ask(() -> ShownComponents.find(type, Optional.empty(), fit).orElseThrow());
    }

    private <C extends Component> C find(Class<C> type, String name, Predicate<C> fit) {
        until(
                "a component " + name,
                () -> ShownComponents.find(type, Optional.of(name), fit).isPresent());
        return ask(() -> ShownComponents.find(type, Optional.of(name), fit).orElseThrow());
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
        click(find(Component.class, name, Component::isEnabled));
    }

    /** Clicks into the middle of a component. */
    public void click(Component component) {
        Dimension size = ask(component::getSize);
        clickAt(component, size.width / 2, size.height / 2);
    }

    /** Clicks at a place of a component, once it is in sight: a panel may still have to get its room. */
    public void clickAt(Component component, int x, int y) {
        untilInSight(component, x, y);
        Point at = placeOf(component);
        act(MouseEvent.MOUSE_RELEASED, 1, () -> {
            robot.mouseMove(at.x + x, at.y + y);
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
        });
    }

    /** Moves the pointer to a place of a component. */
    public void moveTo(Component component, int x, int y) {
        Point at = placeOf(component);
        act(MouseEvent.MOUSE_MOVED, 0, () -> robot.mouseMove(at.x + x, at.y + y));
    }

    /** Moves the pointer to a place of a component as a hand does, in small steps, and lets it rest there, once that is in sight. */
    public void restAt(Component component, int x, int y) {
        untilInSight(component, x, y);
        Point to = placeOf(component);
        to.translate(x, y);
        Point from = MouseInfo.getPointerInfo().getLocation();
        int steps = Math.max(1, (int) (from.distance(to) / GLIDE_PX));
        act(MouseEvent.MOUSE_MOVED, 1, () -> {
            for (int i = 1; i <= steps; i++) {
                long before = handled.counted(MouseEvent.MOUSE_MOVED);
                robot.mouseMove(from.x + (to.x - from.x) * i / steps, from.y + (to.y - from.y) * i / steps);
                robot.delay(GLIDE_MS);
                // a busy window makes one event of many small steps, and sees the pointer jump
                handled.await(MouseEvent.MOUSE_MOVED, before + 1, STEP_HANDLED_WITHIN_MS);
            }
        });
    }

    /** Clicks twice at a place of a component, as fast as a hand does that means one click. */
    public void doubleClickAt(Component component, int x, int y) {
        untilInSight(component, x, y);
        Point at = placeOf(component);
        act(MouseEvent.MOUSE_RELEASED, 2, () -> {
            robot.mouseMove(at.x + x, at.y + y);
            for (int i = 0; i < 2; i++) { // the second press does not wait for what the first one does
                robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
                robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
                robot.delay(TWICE_WITHIN_MS);
            }
        });
    }

    private void untilInSight(Component component, int x, int y) {
        until(
                "the place " + x + ", " + y + " of the component " + component.getName() + " in sight",
                () -> !(component instanceof JComponent drawn)
                        || drawn.getVisibleRect().contains(x, y));
    }

    /** Presses a key twice, as fast as a hand does that means once. */
    public void pressTwice(int key, int... held) {
        keys(() -> {
            strike(key, held);
            robot.delay(TWICE_WITHIN_MS);
            strike(key, held);
        });
    }

    /** The middle of the row of a table whose first column says this. */
    public Point rowAt(JTable table, String first) {
        until("a row " + first, () -> rowOf(table, first) >= 0);
        Rectangle cell = ask(() -> table.getCellRect(rowOf(table, first), 0, true));
        return new Point(cell.x + 20, cell.y + cell.height / 2);
    }

    /** Clicks the row of a table whose first column says this. */
    public void clickRow(String table, String first) {
        JTable found = find(JTable.class, table);
        until("a row " + first, () -> rowOf(found, first) >= 0);
        clickCell(found, ask(() -> rowOf(found, first)), 0);
    }

    /** Clicks a cell of a table, once it is in sight. */
    public void clickCell(JTable table, int row, int column) {
        Rectangle cell = ask(() -> table.getCellRect(row, column, true));
        scrollTo(table, cell);
        clickAt(table, cell.x + Math.min(20, cell.width / 2), cell.y + cell.height / 2);
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
        keys(() -> strike(key, held));
    }

    private void strike(int key, int... held) {
        struck += 1 + held.length;
        for (int each : held) {
            robot.keyPress(each);
        }
        robot.keyPress(key);
        robot.keyRelease(key);
        for (int i = held.length - 1; i >= 0; i--) {
            robot.keyRelease(held[i]);
        }
    }

    /** Types letters, digits, spaces, and what stands in addresses and in the names of files; a line's end is the Enter key. */
    public void type(String text) {
        keys(() -> text.chars().forEach(this::strikeLetter));
    }

    private void strikeLetter(int letter) {
        if (Character.isUpperCase(letter)) {
            strike(KeyEvent.getExtendedKeyCodeForChar(Character.toLowerCase(letter)), KeyEvent.VK_SHIFT);
        } else if (letter == '_') {
            strike(KeyEvent.VK_MINUS, KeyEvent.VK_SHIFT);
        } else if (letter == ':') {
            strike(KeyEvent.VK_SEMICOLON, KeyEvent.VK_SHIFT);
        } else if (letter == '\n') {
            strike(KeyEvent.VK_ENTER);
        } else {
            strike(KeyEvent.getExtendedKeyCodeForChar(letter));
        }
    }

    /** Turns the wheel, over the scroll bar as maps and lists have their own use for it, until the middle of a component is in sight. */
    public void scrollTo(JComponent component) {
        scrollTo(component, ask(() -> new Rectangle(component.getSize())));
    }

    /** Turns the wheel, over the scroll bar, until the middle of a part of a component is in sight. */
    public void scrollTo(JComponent component, Rectangle part) {
        JScrollPane pane = (JScrollPane) ask(() -> SwingUtilities.getAncestorOfClass(JScrollPane.class, component));
        if (pane == null || !ask(() -> pane.getVerticalScrollBar().isShowing())) {
            return;
        }
        JComponent view = ask(pane::getViewport);
        until("room in which " + component.getName() + " can be seen", () -> view.getHeight() > 2 * EDGE_PX);
        int away = ask(() -> away(component, part, view));
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
        while (away != 0 && System.nanoTime() < end) {
            Point at = ask(() -> pane.getVerticalScrollBar().getLocationOnScreen());
            Dimension size = ask(() -> pane.getVerticalScrollBar().getSize());
            int notches = away;
            act(MouseEvent.MOUSE_WHEEL, 1, () -> {
                robot.mouseMove(at.x + size.width / 2, at.y + size.height / 2);
                robot.mouseWheel(notches);
            });
            away = ask(() -> away(component, part, view));
        }
    }

    /** In which direction the middle of a part lies out of sight; 0 where it is in sight. */
    private static int away(JComponent component, Rectangle part, JComponent view) {
        Rectangle at = SwingUtilities.convertRectangle(component, part, view);
        double middle = at.getCenterY();
        return middle < EDGE_PX ? -1 : middle > view.getHeight() - EDGE_PX ? 1 : 0;
    }

    /** Chooses what a box says that opens when it is clicked. */
    public void choose(String box, String words) {
        choose(find(JComboBox.class, box), words);
    }

    /** Chooses what a box says that opens when it is clicked. */
    public void choose(JComboBox<?> box, String words) {
        scrollTo(box);
        click(box);
        JList<?> list = find(JList.class, each -> "ComboBox.list".equals(each.getName()));
        until(box.getName() + " offers " + words, () -> rowOf(list, words) >= 0);
        ask(() -> {
            list.ensureIndexIsVisible(rowOf(list, words));
            return null;
        });
        Rectangle row = ask(() -> list.getCellBounds(rowOf(list, words), rowOf(list, words)));
        clickAt(list, row.x + 12, row.y + row.height / 2);
    }

    private static <T> int rowOf(JList<T> list, String words) {
        for (int i = 0; i < list.getModel().getSize(); i++) {
            T row = list.getModel().getElementAt(i);
            Component shown = list.getCellRenderer().getListCellRendererComponent(list, row, i, false, false);
            if (shown instanceof JLabel label && words.equals(label.getText())) {
                return i;
            }
        }
        return -1;
    }

    /** Presses a button of the pointer here and lets it go there, without anything being carried: draws, moves, connects. */
    public void draw(Component on, Point from, Point to) {
        Point at = placeOf(on);
        act(MouseEvent.MOUSE_PRESSED, 1, () -> {
            robot.mouseMove(at.x + from.x, at.y + from.y);
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        });
        int away = Math.max(Math.abs(to.x - from.x), Math.abs(to.y - from.y));
        int steps = Math.max(1, Math.min(STEPS, away / DRAG_STEP_PX));
        int told = away < DRAG_STEP_PX ? 0 : 1;
        for (int i = 1; i <= steps; i++) {
            Point next =
                    new Point(at.x + from.x + (to.x - from.x) * i / steps, at.y + from.y + (to.y - from.y) * i / steps);
            act(MouseEvent.MOUSE_DRAGGED, told, () -> robot.mouseMove(next.x, next.y));
        }
        act(MouseEvent.MOUSE_RELEASED, 1, () -> robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK));
    }

    /**
     * Drags something from one component onto another, and lets it go once that is ready to take it.
     *
     * @return whether it was taken
     */
    public boolean drag(Component from, Point at, Component to, Point there) {
        SeenDrag seen = new SeenDrag();
        Point end = onScreen(to, there);
        return drag(seen, onScreen(from, at), end, () -> seen.isAt(end));
    }

    /**
     * Drags something onto a component that does not take it, and lets it go once that has said so.
     *
     * @param refused whether it has said so; looked at on the event thread
     * @return whether it was taken
     */
    public boolean dragInVain(Component from, Point at, Component to, Point there, Supplier<Boolean> refused) {
        return drag(new SeenDrag(), onScreen(from, at), onScreen(to, there), () -> ask(refused));
    }

    private static Point onScreen(Component component, Point at) {
        Point point = placeOf(component);
        point.translate(at.x, at.y);
        return point;
    }

    private boolean drag(SeenDrag seen, Point start, Point end, BooleanSupplier arrived) {
        DragSource.getDefaultDragSource().addDragSourceListener(seen);
        robot.setAutoWaitForIdle(true); // of what is dragged by the display no events come
        try {
            robot.mouseMove(start.x, start.y);
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            for (int i = 1; i <= STEPS; i++) {
                robot.mouseMove(start.x + (end.x - start.x) * i / STEPS, start.y + (end.y - start.y) * i / STEPS);
            }
            long until = System.nanoTime() + TimeUnit.SECONDS.toNanos(PATIENCE_S);
            for (int i = 0; !arrived.getAsBoolean(); i++) {
                if (System.nanoTime() > until) {
                    robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
                    throw new AssertionError("nothing saw the drag" + picture());
                }
                robot.mouseMove(end.x + i % 2, end.y);
                LockSupport.parkNanos(LOOK_NANOS);
            }
            robot.setAutoWaitForIdle(false); // a busy window is never idle, and the end of the drag is waited for below
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            until("what is dragged is let go", seen::isOver);
            return seen.isTaken();
        } finally {
            robot.setAutoWaitForIdle(false);
            DragSource.getDefaultDragSource().removeDragSourceListener(seen);
        }
    }
}
