package org.sami.ui.dock;

import java.awt.Component;
import java.awt.Container;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import javax.swing.JSplitPane;
import org.sami.ui.look.Look;

/**
 * The sides that lie one above the other in an area, and how they share its height: a side whose panels are all empty has only the room in which it says
 * so, and what it leaves goes to the sides with panels that make use of room ({@link DockPanel#withUseOfRoom()}), where there are none to all
 * that are not empty. Below a divider that somebody has moved meanwhile, and above it, sides share among themselves. Made for one look: what lies where may change.
 * On the event thread.
 */
final class DockColumn {
    private static final int EMPTY_HEIGHT = 120; // title, tabs, and two lines that say what would be here

    private final PaneKeeper topmost;
    private final Map<JSplitPane, PaneKeeper> keepers;
    private final Part top;
    private final List<Part> leaves = new ArrayList<>();

    /** A pane with what is above and below its divider, or a side. */
    private static final class Part {
        private final Component side;
        private final Optional<PaneKeeper> keeper; // of a pane
        private final List<Part> parts; // of a pane: the upper and the lower one
        private double natural; // height while nothing is empty, in pixels

        Part(Component side, Optional<PaneKeeper> keeper, List<Part> parts) {
            this.side = side;
            this.keeper = keeper;
            this.parts = parts;
        }
    }

    /**
     * The column below a pane.
     *
     * @param topmost its uppermost pane
     * @param keepers of all panes
     */
    DockColumn(PaneKeeper topmost, Map<JSplitPane, PaneKeeper> keepers) {
        this.topmost = topmost;
        this.keepers = keepers;
        top = part(topmost.pane());
    }

    private Part part(Component side) {
        Optional<PaneKeeper> keeper = split(side).map(keepers::get).filter(one -> !one.isSideBySide());
        if (keeper.isEmpty()) {
            Part leaf = new Part(side, keeper, List.of());
            leaves.add(leaf);
            return leaf;
        }
        JSplitPane pane = keeper.get().pane();
        return new Part(side, keeper, List.of(part(pane.getLeftComponent()), part(pane.getRightComponent())));
    }

    /** Whether the places of all its dividers are known. */
    boolean isKnown() {
        return isKnown(top);
    }

    private static boolean isKnown(Part part) {
        return part.keeper.map(PaneKeeper::isKnown).orElse(true)
                && part.parts.stream().allMatch(DockColumn::isKnown);
    }

    /** The sides that are to leave their room to the others: those that are empty; none where all are. */
    Set<Component> due() {
        Set<Component> empty = new HashSet<>();
        leaves.stream().filter(leaf -> isEmpty(leaf.side)).forEach(leaf -> empty.add(leaf.side));
        return empty.size() == leaves.size() ? Set.of() : empty;
    }

    /** Whether its dividers stand where they are to stand. */
    boolean isShown() {
        boolean[] shown = {true};
        share((keeper, place) -> shown[0] &= keeper.pane().getDividerLocation() == place);
        return shown[0];
    }

    /** Has its dividers stand where they are to stand now. */
    void show() {
        share(PaneKeeper::move);
    }

    /** Has these sides leave their room to the others, wherever somebody has moved a divider before. */
    void give(Set<Component> emptied) {
        topmost.setEmptied(emptied);
        keepers(top).forEach(PaneKeeper::unpin);
        show();
    }

    /** How it stands now; to be run where it is to stand so again. */
    Runnable mark() {
        Set<Component> emptied = topmost.emptied();
        List<Runnable> dividers = keepers(top).map(PaneKeeper::mark).toList();
        return () -> {
            topmost.setEmptied(emptied);
            dividers.forEach(Runnable::run);
        };
    }

    /** Places its dividers and lays it out: the outer panes first, as a divider cannot stand beyond the pane that is to become larger. */
    void layOut(Runnable places) {
        keepers(top).forEach(pane -> {
            places.run();
            topmost.pane().validate();
        });
    }

    private static Stream<PaneKeeper> keepers(Part part) {
        return Stream.concat(part.keeper.stream(), part.parts.stream().flatMap(DockColumn::keepers));
    }

    @FunctionalInterface
    private interface Places {
        void take(PaneKeeper keeper, int place);
    }

    private void share(Places places) {
        double height = topmost.free() + topmost.pane().getDividerSize();
        measure(top, height);
        share(top, height, places);
    }

    private static void measure(Part part, double height) {
        part.natural = height;
        part.keeper.ifPresent(keeper -> {
            double free = Math.max(0, height - keeper.pane().getDividerSize());
            double upper = keeper.placeIn(free);
            measure(part.parts.get(0), upper);
            measure(part.parts.get(1), free - upper);
        });
    }

    private void share(Part part, double height, Places places) {
        if (part.keeper.isEmpty()) {
            return;
        }
        PaneKeeper keeper = part.keeper.get();
        double free = Math.max(0, height - keeper.pane().getDividerSize());
        int upper = keeper.isPinned()
                ? keeper.placeIn(free)
                : (int) Math.round(upper(part.parts.get(0), part.parts.get(1), free));
        places.take(keeper, upper);
        if (keeper.isPinned()) {
            measure(part.parts.get(0), upper);
            measure(part.parts.get(1), free - upper);
        }
        share(part.parts.get(0), upper, places);
        share(part.parts.get(1), free - upper, places);
    }

    private double upper(Part above, Part below, double free) {
        double spare = free - least(above) - least(below);
        if (spare < 0) {
            return above.natural * free / Math.max(1, above.natural + below.natural);
        }
        ToDoubleFunction<Part> use = use(above, below);
        double both = use.applyAsDouble(above) + use.applyAsDouble(below);
        return least(above) + (both > 0 ? spare * use.applyAsDouble(above) / both : 0);
    }

    /** What a part needs while its empty sides have only the room in which they say so. */
    private double least(Part part) {
        if (part.keeper.isEmpty()) {
            return topmost.emptied().contains(part.side)
                    ? Math.min(part.natural, emptyHeight(part.side))
                    : part.natural;
        }
        return part.keeper.get().isPinned()
                ? part.natural
                : least(part.parts.get(0))
                        + least(part.parts.get(1))
                        + part.keeper.get().pane().getDividerSize();
    }

    /** Into what proportion two parts share what others leave. */
    private ToDoubleFunction<Part> use(Part above, Part below) {
        Predicate<Part> isInUse = leaf -> !topmost.emptied().contains(leaf.side);
        Predicate<Part> usesRoom = leaf -> panels(leaf.side).stream().anyMatch(DockPanel::usesRoom);
        for (Predicate<Part> wanted : List.of(isInUse.and(usesRoom), isInUse)) {
            if (height(above, wanted) + height(below, wanted) > 0) {
                return part -> height(part, wanted);
            }
        }
        return part -> part.natural;
    }

    private static double height(Part part, Predicate<Part> wanted) {
        if (part.keeper.isEmpty()) {
            return wanted.test(part) ? part.natural : 0;
        }
        return part.parts.stream().mapToDouble(one -> height(one, wanted)).sum();
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

    /** How much room an empty side needs, in pixels. */
    private static int emptyHeight(Component side) {
        Optional<JSplitPane> inner = split(side);
        if (inner.isEmpty()) {
            return Look.px(EMPTY_HEIGHT);
        }
        JSplitPane pane = inner.get();
        int upper = emptyHeight(pane.getLeftComponent());
        int lower = emptyHeight(pane.getRightComponent());
        return pane.getOrientation() == JSplitPane.HORIZONTAL_SPLIT
                ? Math.max(upper, lower)
                : upper + pane.getDividerSize() + lower;
    }

    /** The outermost split pane of a side; empty where its panels lie behind one another. */
    private static Optional<JSplitPane> split(Component side) {
        if (side instanceof JSplitPane found) {
            return Optional.of(found);
        }
        if (side instanceof DockPanel || !(side instanceof Container container)) {
            return Optional.empty();
        }
        for (Component child : container.getComponents()) {
            Optional<JSplitPane> found = split(child);
            if (found.isPresent()) {
                return found;
            }
        }
        return Optional.empty();
    }
}
