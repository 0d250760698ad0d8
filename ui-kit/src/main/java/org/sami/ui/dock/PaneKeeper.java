package org.sami.ui.dock;

import java.awt.Component;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.JSplitPane;
import javax.swing.SwingUtilities;
import org.sami.ui.EventThread;

/**
 * Keeps the proportion of one split pane when its size changes: a divider stands where it stood, measured in parts of the pane. Swing's
 * resize weight cannot do that: it shares out only the change, in whole pixels, and the second side takes what is left over. On the event thread.
 */
final class PaneKeeper extends ComponentAdapter {
    private final JSplitPane pane;
    private final Consumer<PaneKeeper> show;
    private final Predicate<PaneKeeper> leavesRoom;
    private final Runnable moved;
    private int size; // that it has heard of
    private int laidOut; // size at which the divider was seen last
    private double proportion = Double.NaN; // not known until the divider has a place in a pane with a size
    private boolean moving;
    private boolean pinned; // somebody has moved the divider since panels of its column became empty
    private Set<Component> emptied = Set.of(); // of the uppermost pane of a column
    private Optional<Refusal> refused = Optional.empty(); // last one, of the uppermost pane of a column

    /** Sides that may not leave their room while this is pointed at. */
    private record Refusal(Set<Component> sides, PointerRest.Pressable pointedAt) {}

    /**
     * The keeper of a pane.
     *
     * @param show has the dividers of the pane's column stand where they are to stand now
     * @param leavesRoom whether some side in the pane's column leaves its room to another one
     * @param moved is called when somebody has moved the divider
     */
    PaneKeeper(JSplitPane pane, Consumer<PaneKeeper> show, Predicate<PaneKeeper> leavesRoom, Runnable moved) {
        this.pane = pane;
        this.show = show;
        this.leavesRoom = leavesRoom;
        this.moved = moved;
    }

    void install() {
        size = free();
        laidOut = size;
        remember();
        pane.addComponentListener(this);
        pane.addPropertyChangeListener(JSplitPane.DIVIDER_LOCATION_PROPERTY, change -> dividerMoved());
    }

    JSplitPane pane() {
        return pane;
    }

    /** Whether the pane is in an area no longer. */
    boolean isGoneFrom(Component area) {
        return !SwingUtilities.isDescendingFrom(pane, area);
    }

    /** Whether it has a size, and its divider a place. */
    boolean isKnown() {
        return !Double.isNaN(proportion) && size > 0;
    }

    /** Whether the divider stays where somebody has put it, whatever is empty. */
    boolean isPinned() {
        return pinned;
    }

    void unpin() {
        pinned = false;
    }

    /** Where its divider stands now; to be run where it is to stand there again. */
    Runnable mark() {
        int place = pane.getDividerLocation();
        boolean byHand = pinned;
        return () -> {
            pinned = byHand;
            move(place);
        };
    }

    /** Whether it is known that a button under the pointer would move if sides of its column left their room; of the uppermost pane of a column. */
    boolean isRefused(Set<Component> sides, PointerRest.Pressable pointedAt) {
        return refused.equals(Optional.of(new Refusal(sides, pointedAt)));
    }

    void refuse(Set<Component> sides, PointerRest.Pressable pointedAt) {
        refused = Optional.of(new Refusal(sides, pointedAt));
    }

    /** The sides of its column that leave their room to others now; of the uppermost pane of a column. */
    Set<Component> emptied() {
        return emptied;
    }

    void setEmptied(Set<Component> sides) {
        emptied = sides;
    }

    /**
     * A divider that moves in a pane of the same size was moved by someone; else the pane's layout did it, maybe for a size that nobody has heard of and that
     * it has no longer. Modern Docking puts it to its proportion, a while after it has restored an arrangement.
     */
    private void dividerMoved() {
        int now = free();
        boolean byLayout = now != laidOut;
        laidOut = now;
        if (moving || now != size) {
            return;
        }
        if (byLayout) {
            EventThread.later(() -> show.accept(this));
        } else if (!(leavesRoom.test(this) && isAtProportion())) {
            pinned = leavesRoom.test(this);
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
        laidOut = size;
        if (Double.isNaN(proportion)) {
            remember();
        } else {
            show.accept(this);
        }
    }

    private void remember() {
        if (size > 0 && pane.getDividerLocation() >= 0) {
            proportion = Math.min(1, pane.getDividerLocation() / (double) size);
        }
    }

    /** Where the divider stands in a pane of a size while no panel is empty. */
    int placeIn(double height) {
        return (int) Math.round(proportion * height);
    }

    /** Has the divider stand as it does while no panel is empty. */
    void showProportion() {
        move(placeIn(size));
    }

    /** Moves the divider; not beyond the pane, whose layout would take it back: a pane that is to become larger is shown again as it does. */
    void move(int place) {
        if (size > 0 && place <= free()) {
            moving = true;
            pane.setDividerLocation(place);
            moving = false;
        }
    }

    boolean isSideBySide() {
        return pane.getOrientation() == JSplitPane.HORIZONTAL_SPLIT;
    }

    /** What both sides have together, in pixels. */
    int free() {
        return Math.max(0, (isSideBySide() ? pane.getWidth() : pane.getHeight()) - pane.getDividerSize());
    }
}
