package org.sami.ui.dock;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import org.sami.ui.look.Look;

/**
 * Keeps the proportion of one split pane when its size changes: a divider stands where it stood, measured in parts of the pane. Swing's
 * resize weight cannot do that: it shares out only the change, in whole pixels, and the second side takes what is left over. While all panels of
 * the upper or the lower side are empty, that side has only the room in which it says so; sides that lie beside one another keep the width that
 * their tabs need. On the event thread.
 */
final class PaneKeeper extends ComponentAdapter {
    private static final int EMPTY_HEIGHT = 120; // title, tabs, and two lines that say what would be here

    private final JSplitPane pane;
    private final Component area;
    private final Runnable moved;
    private int size;
    private double proportion = Double.NaN; // not known until the divider has a place in a pane with a size
    private boolean moving;
    private Given given = Given.NOTHING;
    private Given settled = Given.NOTHING; // what was given, or what somebody has moved the divider against

    /** Which side leaves its room to the other one. */
    private enum Given {
        NOTHING,
        LEFT, // of a pane with one side above the other: the upper one
        RIGHT,
        /** Both leave their room to what lies beside the pane. */
        BOTH
    }

    /**
     * The keeper of a pane.
     *
     * @param area in which it lies, at any depth
     * @param moved is told when somebody has moved the divider
     */
    PaneKeeper(JSplitPane pane, Component area, Runnable moved) {
        this.pane = pane;
        this.area = area;
        this.moved = moved;
    }

    void install() {
        size = free();
        remember();
        pane.addComponentListener(this);
        pane.addPropertyChangeListener(JSplitPane.DIVIDER_LOCATION_PROPERTY, change -> dividerMoved());
    }

    /** Whether the pane is in the area no longer. */
    boolean isGone() {
        return !SwingUtilities.isDescendingFrom(pane, area);
    }

    /**
     * A divider that moves in a pane of the same size was moved by someone; else the pane's layout did it. Modern Docking puts it to its proportion,
     * a while after it has restored an arrangement.
     */
    private void dividerMoved() {
        if (!moving && free() == size && !(leavesRoom() && isAtProportion())) {
            given = Given.NOTHING;
            remember();
            moved.run();
        }
    }

    private boolean isAtProportion() {
        return Math.abs(pane.getDividerLocation() - proportion * size) <= 2;
    }

    @Override
    public void componentResized(ComponentEvent resized) {
        if (free() == size) {
            return;
        }
        size = free();
        if (Double.isNaN(proportion)) {
            remember();
        } else {
            showShared();
        }
    }

    private void remember() {
        if (size > 0 && pane.getDividerLocation() >= 0) {
            proportion = Math.min(1, pane.getDividerLocation() / (double) size);
        }
    }

    /** Shares the room anew, where that is due and allowed. */
    void share(Predicate<JSplitPane> mayShrink, Predicate<JSplitPane> mayReturn) {
        if (Double.isNaN(proportion) || size <= 0 || isGone()) {
            return;
        }
        Given due = due();
        if (due != settled && (due == Given.NOTHING ? mayReturn : mayShrink).test(pane)) {
            settled = due;
            given = due;
            showShared();
        } else if (given != Given.NOTHING && place() != pane.getDividerLocation() && mayShrink.test(pane)) {
            showShared(); // a panel has come to the side, or has left it
        }
    }

    private Given due() {
        if (isBeside(pane)) {
            return Given.NOTHING;
        }
        boolean left = isEmpty(pane.getLeftComponent());
        boolean right = isEmpty(pane.getRightComponent());
        if (left && right) {
            return Given.BOTH;
        }
        return left ? Given.LEFT : right ? Given.RIGHT : Given.NOTHING;
    }

    private static boolean isEmpty(Component side) {
        List<DockPanel> panels = panels(side);
        return !panels.isEmpty() && panels.stream().allMatch(DockPanel::isEmpty);
    }

    private static List<DockPanel> panels(Component side) {
        List<DockPanel> found = new ArrayList<>();
        if (side instanceof DockPanel panel) {
            found.add(panel);
        } else if (side instanceof Container container) {
            for (Component child : container.getComponents()) {
                found.addAll(panels(child));
            }
        }
        return found;
    }

    boolean leavesRoom() {
        return given != Given.NOTHING;
    }

    /** Has the divider stand as it does while no side is empty. */
    void showProportion() {
        move((int) Math.round(proportion * size));
    }

    /** Has the divider stand where it is to stand now. */
    void showShared() {
        move(place());
    }

    private void move(int place) {
        if (size > 0) {
            moving = true;
            pane.setDividerLocation(place);
            moving = false;
        }
    }

    private int place() {
        int kept = (int) Math.round(proportion * size);
        int left = emptyHeight(pane.getLeftComponent());
        int right = emptyHeight(pane.getRightComponent());
        return switch (given) {
            case NOTHING -> kept;
            case LEFT -> Math.min(kept, left);
            case RIGHT -> Math.max(kept, size - right);
            case BOTH -> size > left + right + pane.getDividerSize() ? kept : left * size / (left + right);
        };
    }

    private static boolean isBeside(JSplitPane pane) {
        return pane.getOrientation() == JSplitPane.HORIZONTAL_SPLIT;
    }

    /** How much room an empty side needs, in pixels. */
    private static int emptyHeight(Component side) {
        JSplitPane inner = split(side);
        if (inner == null) {
            return Look.px(EMPTY_HEIGHT);
        }
        int upper = emptyHeight(inner.getLeftComponent());
        int lower = emptyHeight(inner.getRightComponent());
        return isBeside(inner) ? Math.max(upper, lower) : upper + inner.getDividerSize() + lower;
    }

    /** The outermost split pane of a side; null where its panels lie behind one another. */
    private static JSplitPane split(Component side) {
        if (side instanceof JSplitPane found) {
            return found;
        }
        if (side instanceof DockPanel || !(side instanceof Container container)) {
            return null;
        }
        for (Component child : container.getComponents()) {
            JSplitPane found = split(child);
            if (found != null) {
                return found;
            }
        }
        return null;
    }

    /** What both sides have together, in pixels. */
    private int free() {
        return Math.max(0, (isBeside(pane) ? pane.getWidth() : pane.getHeight()) - pane.getDividerSize());
    }
}
