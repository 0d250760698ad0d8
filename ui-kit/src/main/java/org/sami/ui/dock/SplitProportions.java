package org.sami.ui.dock;

import java.awt.Component;
import java.awt.Container;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import javax.swing.JSplitPane;

/**
 * The split panes of an area: each keeps its proportion, and sides of a column whose panels are all empty leave their room to the others of that
 * column (docs/windows.md). On the event thread.
 */
final class SplitProportions {
    private final Map<JSplitPane, PaneKeeper> keepers = new LinkedHashMap<>();
    private final Component area;
    private final Runnable moved;

    private SplitProportions(Component area, Runnable moved) {
        this.area = area;
        this.moved = moved;
    }

    /**
     * Keeps the proportions of all split panes below a component, and of those that are added to it later.
     *
     * @param moved is called when somebody has moved a divider
     */
    static SplitProportions keep(Component component, Runnable moved) {
        SplitProportions all = new SplitProportions(component, moved);
        ComponentWatch.on(component, found -> {
            if (found instanceof JSplitPane pane) {
                all.add(pane);
            }
        });
        return all;
    }

    private void add(JSplitPane pane) {
        PaneKeeper keeper = new PaneKeeper(pane, this::show, this::leavesRoom, moved);
        keeper.install();
        keepers.put(pane, keeper);
    }

    /**
     * Has each side whose panels are all empty leave its room to the others of its column, and take it back where it is empty no longer.
     *
     * @param mayShrink whether what is in a column may move because something has gone; given its uppermost pane
     * @param mayReturn the same, because something has come
     * @param pointedAt what in a column can be pressed where the pointer is: something that has gone does not move it
     */
    void share(
            Predicate<JSplitPane> mayShrink,
            Predicate<JSplitPane> mayReturn,
            Function<JSplitPane, Optional<PointerRest.Pressable>> pointedAt) {
        keepers.values().removeIf(keeper -> keeper.isGoneFrom(area));
        List<PaneKeeper> now = List.copyOf(keepers.values());
        for (PaneKeeper keeper : now) {
            PaneKeeper top = top(keeper);
            if (top != keeper && !keeper.emptied().isEmpty()) { // panels were put above its column
                top.setEmptied(keeper.emptied());
                keeper.setEmptied(Set.of());
            }
        }
        for (PaneKeeper keeper : now) {
            if (!keeper.isSideBySide() && top(keeper) == keeper) {
                share(keeper, mayShrink, mayReturn, pointedAt);
            }
        }
    }

    private void share(
            PaneKeeper top,
            Predicate<JSplitPane> mayShrink,
            Predicate<JSplitPane> mayReturn,
            Function<JSplitPane, Optional<PointerRest.Pressable>> pointedAt) {
        DockColumn column = new DockColumn(top, keepers);
        if (!column.isKnown()) {
            return;
        }
        Set<Component> due = column.due();
        if (!due.equals(top.emptied())) {
            if (!due.containsAll(top.emptied())) { // something has come
                if (mayReturn.test(top.pane())) {
                    column.give(due);
                }
            } else if (mayShrink.test(top.pane())) {
                shrink(column, top, due, pointedAt);
            }
        } else if (!due.isEmpty() && !column.isShown() && mayShrink.test(top.pane())) {
            column.show(); // a panel has come to a side, or has left it
        }
    }

    /** Gives the room of empty sides to the others, unless a button under the pointer would become another one: the pointer may rest on one before it is pressed. */
    private static void shrink(
            DockColumn column,
            PaneKeeper top,
            Set<Component> due,
            Function<JSplitPane, Optional<PointerRest.Pressable>> pointedAt) {
        Optional<PointerRest.Pressable> before = pointedAt.apply(top.pane());
        if (before.isPresent() && top.isRefused(due, before.get())) {
            return;
        }
        Runnable back = column.mark();
        column.give(due);
        if (before.isPresent()) {
            column.layOut(column::show); // nothing is painted before this has returned
            if (!before.equals(pointedAt.apply(top.pane()))) {
                column.layOut(back);
                top.refuse(due, before.get());
            }
        }
    }

    /** The uppermost pane of the column that a pane is in; the pane itself where its sides lie side by side. */
    private PaneKeeper top(PaneKeeper keeper) {
        PaneKeeper top = keeper;
        for (Container at = keeper.pane().getParent(); at != null && at != area; at = at.getParent()) {
            if (at instanceof DockPanel) {
                break; // a pane in a panel
            }
            if (at instanceof JSplitPane pane) {
                PaneKeeper outer = keepers.get(pane);
                if (outer == null || outer.isSideBySide() || keeper.isSideBySide()) {
                    break;
                }
                top = outer;
            }
        }
        return top;
    }

    /** Whether some side in the column of a pane leaves its room to another one. */
    private boolean leavesRoom(PaneKeeper keeper) {
        return !top(keeper).emptied().isEmpty();
    }

    /** Has the dividers of the column of a pane stand where they are to stand now. */
    private void show(PaneKeeper keeper) {
        DockColumn column = new DockColumn(top(keeper), keepers);
        if (!keeper.isSideBySide() && column.isKnown()) {
            column.show();
        } else {
            keeper.showProportion();
        }
    }

    /** Runs something, such as a look at the proportions, while no side leaves any room to another. */
    void inProportion(Runnable look) {
        List<PaneKeeper> shared =
                keepers.values().stream().filter(this::leavesRoom).toList();
        shared.forEach(PaneKeeper::showProportion);
        try {
            look.run();
        } finally {
            shared.forEach(this::show);
        }
    }
}
