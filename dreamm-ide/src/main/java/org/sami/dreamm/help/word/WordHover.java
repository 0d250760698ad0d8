package org.sami.dreamm.help.word;

import java.awt.AWTEvent;
import java.awt.Component;
import java.awt.Container;
import java.awt.MouseInfo;
import java.awt.Point;
import java.awt.PointerInfo;
import java.awt.Rectangle;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.AWTEventListener;
import java.awt.event.InputEvent;
import java.awt.event.MouseEvent;
import java.awt.event.WindowEvent;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLayeredPane;
import javax.swing.JList;
import javax.swing.JPopupMenu;
import javax.swing.JRootPane;
import javax.swing.JTable;
import javax.swing.JTree;
import javax.swing.JViewport;
import javax.swing.SwingUtilities;
import javax.swing.Timer;
import javax.swing.ToolTipManager;
import org.sami.lessons.course.Glossary;
import org.sami.lessons.course.Term;
import org.sami.ui.look.Look;

/**
 * Shows what a term means next to it, when the pointer has rested on the term for a moment. The card lies where it hides the fewest of what one can click next, and goes
 * when the pointer leaves for something else. On the event thread.
 */
final class WordHover implements AWTEventListener, AutoCloseable {
    private static final Integer LAYER = JLayeredPane.POPUP_LAYER + 50; // over menus
    private static final int REST_MS = 800;
    private static final int LEAVE_MS = 350; // time to come from the word to the card
    private static final int JUMP = 48;
    private static final int GAP = 6;
    private static final long EVENTS = AWTEvent.MOUSE_EVENT_MASK
            | AWTEvent.MOUSE_MOTION_EVENT_MASK
            | AWTEvent.MOUSE_WHEEL_EVENT_MASK
            | AWTEvent.KEY_EVENT_MASK
            | AWTEvent.WINDOW_EVENT_MASK;

    private final Words words;
    private final Timer rest = new Timer(REST_MS, e -> rested());
    private final Timer leave = new Timer(LEAVE_MS, e -> left());
    private Optional<Shown> shown = Optional.empty();
    private Optional<Window> window = Optional.empty();
    private Point pointer = new Point();
    private boolean on = true;

    /** A card in a window, and the words that it explains, in the window's layered pane. */
    private record Shown(WordCard card, JLayeredPane pane, Rectangle words) {}

    WordHover(Words words) {
        this.words = Objects.requireNonNull(words, "words");
        rest.setRepeats(false);
        leave.setRepeats(false);
        Toolkit.getDefaultToolkit().addAWTEventListener(this, EVENTS);
    }

    boolean isOn() {
        return on;
    }

    void setOn(boolean next) {
        on = next;
        hide();
    }

    @Override
    public void eventDispatched(AWTEvent event) {
        if (event instanceof MouseEvent mouse
                && (mouse.getID() == MouseEvent.MOUSE_MOVED || mouse.getID() == MouseEvent.MOUSE_ENTERED)) {
            moved(mouse);
        } else if (event instanceof MouseEvent mouse) {
            boolean away = mouse.getID() == MouseEvent.MOUSE_EXITED
                    ? window.filter(in -> in.getBounds().contains(mouse.getLocationOnScreen()))
                            .isEmpty()
                    : !isOverCard(mouse.getLocationOnScreen());
            if (away) {
                hide();
            }
        } else if (event instanceof InputEvent || event.getID() == WindowEvent.WINDOW_DEACTIVATED) {
            hide();
        }
    }

    private void moved(MouseEvent mouse) {
        Point now = mouse.getLocationOnScreen();
        if (now.equals(pointer)) {
            return; // another component came below the pointer, which rests
        }
        boolean jumped = now.distance(pointer) > Look.px(JUMP);
        pointer = now;
        window = Optional.ofNullable(
                mouse.getComponent() instanceof Window self
                        ? self
                        : SwingUtilities.getWindowAncestor(mouse.getComponent()));
        if (shown.isPresent()) {
            boolean inCard = isOverCard(now);
            if (jumped) {
                hide(); // nobody who goes to the card comes so fast
            } else if (inCard || isOverWords(now)) {
                leave.stop();
            } else if (!leave.isRunning()) {
                leave.start();
            }
            if (inCard) {
                rest.stop();
                return;
            }
        }
        if (on) {
            rest.restart();
        }
    }

    /** Takes the card away, unless the pointer has come to it and the window was too busy to see it come. */
    private void left() {
        PointerInfo info = MouseInfo.getPointerInfo();
        if (info == null || !isOverCard(info.getLocation())) {
            hide();
        }
    }

    private boolean isOverCard(Point screen) {
        return shown.filter(now -> contains(now.pane(), now.card().getBounds(), screen))
                .isPresent();
    }

    private boolean isOverWords(Point screen) {
        return shown.filter(now -> contains(now.pane(), now.words(), screen)).isPresent();
    }

    private static boolean contains(JLayeredPane pane, Rectangle part, Point screen) {
        Point at = new Point(screen);
        SwingUtilities.convertPointFromScreen(at, pane);
        return part.contains(at);
    }

    private void rested() {
        Optional<Component> at = window.filter(Window::isShowing).flatMap(this::below);
        at.ifPresent(component -> {
            Point inside = new Point(pointer);
            SwingUtilities.convertPointFromScreen(inside, component);
            Point then = new Point(pointer);
            ShownWords.at(component, inside)
                    .ifPresent(spoken -> words.find(spoken, (glossary, terms) -> {
                        if (!terms.isEmpty() && pointer.equals(then) && component.isShowing()) {
                            show(component, inside, spoken, glossary, terms);
                        }
                    }));
        });
    }

    private Optional<Component> below(Window in) {
        Point inside = new Point(pointer);
        SwingUtilities.convertPointFromScreen(inside, in);
        return Optional.ofNullable(SwingUtilities.getDeepestComponentAt(in, inside.x, inside.y));
    }

    private void show(Component component, Point inside, ShownText spoken, Glossary glossary, List<Term> terms) {
        JRootPane root = root(component);
        if (root == null) {
            return;
        }
        hide();
        JLayeredPane pane = root.getLayeredPane();
        Rectangle box = SwingUtilities.convertRectangle(component, spoken.box(), pane);
        WordCard card = new WordCard(words, glossary, terms, tip(component, inside, terms), this::hide);
        card.setLocation(place(card, box, beside(component, pane), pane));
        shown = Optional.of(new Shown(card, pane, box));
        pane.add(card, LAYER);
        pane.repaint(card.getBounds());
        ToolTipManager.sharedInstance().setEnabled(false); // the card says what the tooltip says
    }

    /** A menu may lie in a window of its own: its card belongs into that of the menu bar. */
    private static JRootPane root(Component component) {
        JPopupMenu menu = (JPopupMenu) SwingUtilities.getAncestorOfClass(JPopupMenu.class, component);
        return SwingUtilities.getRootPane(menu == null || menu.getInvoker() == null ? component : menu.getInvoker());
    }

    /** What must not be hidden: the other rows of a list, the other items of a menu. */
    private static Optional<Rectangle> beside(Component component, JLayeredPane pane) {
        Container rows = SwingUtilities.getAncestorOfClass(JPopupMenu.class, component);
        if (rows == null && (component instanceof JList || component instanceof JTable || component instanceof JTree)) {
            rows = SwingUtilities.getAncestorOfClass(JViewport.class, component);
        }
        return Optional.ofNullable(rows)
                .filter(all -> all.getParent() != null)
                .map(all -> SwingUtilities.convertRectangle(all.getParent(), all.getBounds(), pane));
    }

    private static String tip(Component component, Point inside, List<Term> terms) {
        if (!(component instanceof JComponent shown)) {
            return "";
        }
        String tip =
                shown.getToolTipText(new MouseEvent(shown, MouseEvent.MOUSE_MOVED, 0, 0, inside.x, inside.y, 0, false));
        String words = tip == null ? "" : tip.replaceAll("(?<=[^\\n]{60})\\n", " "); // lines broken for a tooltip
        boolean same = terms.stream().anyMatch(term -> words.contains(term.text()));
        return same ? "" : words;
    }

    private static Point place(WordCard card, Rectangle box, Optional<Rectangle> beside, JLayeredPane pane) {
        int gap = Look.px(GAP);
        int most = Math.max(0, pane.getWidth() - card.getWidth());
        int lowest = Math.max(0, pane.getHeight() - card.getHeight());
        if (beside.isPresent()) {
            Rectangle rows = beside.get();
            int right = rows.x + rows.width + gap;
            int left = rows.x - gap - card.getWidth();
            int y = Math.max(0, Math.min(box.y, lowest));
            if (right <= most) {
                return new Point(right, y);
            } else if (left >= 0) {
                return new Point(left, y);
            }
        }
        int x = Math.max(0, Math.min(box.x, most));
        int below = box.y + box.height + gap;
        return new Point(x, below <= lowest ? below : Math.max(0, box.y - gap - card.getHeight()));
    }

    /** Takes the card away. */
    void hide() {
        rest.stop();
        leave.stop();
        shown.ifPresent(now -> {
            shown = Optional.empty();
            now.pane().remove(now.card());
            now.pane().repaint(now.card().getBounds());
            ToolTipManager.sharedInstance().setEnabled(true);
        });
    }

    @Override
    public void close() {
        Toolkit.getDefaultToolkit().removeAWTEventListener(this);
        hide();
    }
}
