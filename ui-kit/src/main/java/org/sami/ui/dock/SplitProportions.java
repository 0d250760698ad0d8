package org.sami.ui.dock;

import java.awt.Component;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Predicate;
import javax.swing.JSplitPane;

/**
 * The split panes of an area: each keeps its proportion, and a side whose panels are all empty leaves its room to the other one. On the event thread.
 */
final class SplitProportions {
    private final List<PaneKeeper> keepers = new ArrayList<>();
    private final Component area;
    private final Runnable moved;

    private SplitProportions(Component area, Runnable moved) {
        this.area = area;
        this.moved = moved;
    }

    /**
     * Keeps the proportions of all split panes below a component, and of those that are added to it later.
     *
     * @param moved is told when somebody has moved a divider
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
        PaneKeeper keeper = new PaneKeeper(pane, area, moved);
        keeper.install();
        keepers.add(keeper);
    }

    /**
     * Has each side whose panels are all empty leave its room to the other one, and take it back where it is empty no longer.
     *
     * @param mayShrink whether what is in a pane may move because something has gone
     * @param mayReturn the same, because something has come
     */
    void share(Predicate<JSplitPane> mayShrink, Predicate<JSplitPane> mayReturn) {
        keepers.removeIf(PaneKeeper::isGone);
        keepers.forEach(keeper -> keeper.share(mayShrink, mayReturn));
    }

    /** Runs something, such as a look at the proportions, while no side leaves any room to another. */
    void inProportion(Runnable look) {
        List<PaneKeeper> shared =
                keepers.stream().filter(PaneKeeper::leavesRoom).toList();
        shared.forEach(PaneKeeper::showProportion);
        try {
            look.run();
        } finally {
            shared.forEach(PaneKeeper::showShared);
        }
    }
}
