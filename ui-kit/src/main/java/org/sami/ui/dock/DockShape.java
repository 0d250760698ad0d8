package org.sami.ui.dock;

import io.github.andrewauclair.moderndocking.layouts.ApplicationLayout;
import io.github.andrewauclair.moderndocking.layouts.DockingLayoutNode;
import io.github.andrewauclair.moderndocking.layouts.DockingSimplePanelNode;
import io.github.andrewauclair.moderndocking.layouts.DockingSplitPanelNode;
import io.github.andrewauclair.moderndocking.layouts.DockingTabPanelNode;
import java.util.stream.Collectors;
import javax.swing.JSplitPane;

/** Which panels lie side by side, below and behind one another, without their sizes: a person who has moved a panel has made another shape. */
final class DockShape {
    private DockShape() {}

    /** The shape in letters, equal for equal ones. */
    static String of(ApplicationLayout layout) {
        boolean whole = layout.getMainFrameLayout().getMaximizedDockable() == null
                || layout.getMainFrameLayout().getMaximizedDockable().isEmpty();
        return of(layout.getMainFrameLayout().getRootNode())
                + " free " + layout.getFloatingFrameLayouts().size()
                + (whole ? "" : " enlarged");
    }

    private static String of(DockingLayoutNode node) {
        if (node instanceof DockingSplitPanelNode split) {
            return (split.getOrientation() == JSplitPane.HORIZONTAL_SPLIT ? "beside(" : "below(") + of(split.getLeft())
                    + ", " + of(split.getRight()) + ")";
        }
        if (node instanceof DockingTabPanelNode stack) {
            return stack.getPersistentIDs().stream()
                    .map(DockingSimplePanelNode::getPersistentID)
                    .collect(Collectors.joining(" ", "behind(", ")"));
        }
        return node instanceof DockingSimplePanelNode panel ? panel.getPersistentID() : "nothing";
    }
}
