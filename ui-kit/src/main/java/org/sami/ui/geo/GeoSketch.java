package org.sami.ui.geo;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/**
 * A point, list of points, path or area while it is drawn: each change can be undone. What it will become is {@link #value}, and why it
 * is not one yet {@link #problem}. An area keeps the holes that it came with.
 *
 * <p>Used by one thread, a window's event thread. Listeners are called after each change, also of the selection.
 */
public final class GeoSketch {
    private record State(List<GeoPoint> points, List<List<GeoPoint>> holes) {}

    private static final State EMPTY = new State(List.of(), List.of());

    private final GeoShape shape;
    private final Deque<State> undone = new ArrayDeque<>();
    private final Deque<State> done = new ArrayDeque<>();
    private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
    private State state = EMPTY;
    private int selected = -1;
    private boolean moving;

    public GeoSketch(GeoShape shape) {
        this.shape = Objects.requireNonNull(shape, "shape");
    }

    /** What is drawn. */
    public GeoShape shape() {
        return shape;
    }

    /** The points so far, in order. */
    public List<GeoPoint> points() {
        return state.points();
    }

    /** The holes of an area, which cannot be changed here. */
    public List<List<GeoPoint>> holes() {
        return state.holes();
    }

    /** The point that keys act on; none where none is chosen. */
    public OptionalInt selected() {
        return selected < 0 ? OptionalInt.empty() : OptionalInt.of(selected);
    }

    /** Chooses the point that keys act on; an index that no point has chooses none. */
    public void select(int index) {
        int chosen = index >= 0 && index < points().size() ? index : -1;
        if (chosen != selected) {
            selected = chosen;
            tell();
        }
    }

    /** Puts a point behind the last one and selects it; a single point takes the place of the earlier one. */
    public void add(GeoPoint point) {
        if (shape == GeoShape.POINT) {
            change(List.of(point), 0);
        } else {
            insert(points().size(), point);
        }
    }

    /** Puts a point before the one of that index, and selects it. */
    public void insert(int index, GeoPoint point) {
        List<GeoPoint> points = new ArrayList<>(points());
        points.add(index, Objects.requireNonNull(point, "point"));
        change(points, index);
    }

    /** Moves a point to another place. */
    public void move(int index, GeoPoint to) {
        if (!points().get(index).equals(to)) {
            List<GeoPoint> points = new ArrayList<>(points());
            points.set(index, to);
            change(points, index);
        }
    }

    /** Begins moving a point by steps that are undone as one, until {@link #endMove}. */
    public void beginMove() {
        moving = true;
        remember();
    }

    /** Ends what {@link #beginMove} began; where nothing moved, nothing is to be undone. */
    public void endMove() {
        if (moving) {
            moving = false;
            if (!done.isEmpty() && done.peek().equals(state)) {
                done.pop();
            }
        }
    }

    /** Takes a point away. */
    public void remove(int index) {
        List<GeoPoint> points = new ArrayList<>(points());
        points.remove(index);
        change(points, Math.min(index, points.size() - 1));
    }

    /** Takes all points and holes away. */
    public void clear() {
        if (!state.equals(EMPTY)) {
            change(EMPTY, -1);
        }
    }

    /**
     * Shows a value instead of what was drawn; can be undone.
     *
     * @throws IllegalArgumentException if it is not a value of this shape
     */
    public void show(Value value) {
        State shown = stateOf(value);
        if (!shown.equals(state)) {
            change(shown, -1);
        }
    }

    private State stateOf(Value value) {
        if (shape == GeoShape.POINT && value instanceof GeoPoint point) {
            return new State(List.of(point), List.of());
        }
        if (shape == GeoShape.PATH && value instanceof GeoPath path) {
            return new State(path.points(), List.of());
        }
        if (shape == GeoShape.AREA && value instanceof GeoArea area) {
            return new State(area.outline(), area.holes());
        }
        if (shape == GeoShape.POINTS
                && value instanceof ListValue list
                && list.items().stream().allMatch(GeoPoint.class::isInstance)) {
            return new State(list.items().stream().map(GeoPoint.class::cast).toList(), List.of());
        }
        throw new IllegalArgumentException("A " + shape.word() + " is drawn here, not " + value);
    }

    private void change(List<GeoPoint> points, int select) {
        change(new State(List.copyOf(points), state.holes()), select);
    }

    private void change(State next, int select) {
        if (!moving) {
            remember();
        }
        state = next;
        selected = select;
        tell();
    }

    private void remember() {
        done.push(state);
        undone.clear();
    }

    /** Whether there is a change to take back. */
    public boolean canUndo() {
        return !done.isEmpty();
    }

    /** Whether there is a change to make again. */
    public boolean canRedo() {
        return !undone.isEmpty();
    }

    /** Takes the last change back; does nothing where there is none. */
    public void undo() {
        step(done, undone);
    }

    /** Makes the last change again that was taken back; does nothing where there is none. */
    public void redo() {
        step(undone, done);
    }

    private void step(Deque<State> from, Deque<State> to) {
        if (!from.isEmpty()) {
            to.push(state);
            state = from.pop();
            selected = Math.min(selected, state.points().size() - 1);
            tell();
        }
    }

    /** What was drawn, as a value; none while {@link #problem} says why not. */
    public Optional<Value> value() {
        if (problem().isPresent()) {
            return Optional.empty();
        }
        return Optional.of(
                switch (shape) {
                    case POINT -> points().get(0);
                    case POINTS -> new ListValue(List.copyOf(points()));
                    case PATH -> new GeoPath(points());
                    case AREA -> new GeoArea(points(), holes());
                });
    }

    /** Why this is not a value yet, in one line that says what to do; none where it is one. */
    public Optional<String> problem() {
        int missing = shape.leastPoints() - points().size();
        if (missing > 0) {
            String more = points().isEmpty() ? "" : " more";
            return Optional.of("Click " + missing + more + (missing == 1 ? " point" : " points") + " on the map");
        }
        if (shape == GeoShape.AREA) {
            return Outline.crossing(points())
                    .map(crossing -> "The outline crosses itself between points " + (crossing.first() + 1) + " and "
                            + (crossing.second() + 1) + ": move one of them");
        }
        return Optional.empty();
    }

    /** Adds a listener that is called after each change. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }

    /** Tells that listener no more. */
    public void removeListener(Runnable listener) {
        listeners.remove(listener);
    }

    private void tell() {
        listeners.forEach(Runnable::run);
    }
}
