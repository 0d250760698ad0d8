package org.sami.ui.dock;

import java.awt.Component;
import java.awt.event.ComponentAdapter;
import java.awt.event.ComponentEvent;
import javax.swing.JSplitPane;

/**
 * Keeps the proportions of split panes when their size changes: a divider stands where it stood, measured in parts of the pane. Swing's
 * resize weight cannot do that: it shares out only the change, in whole pixels, and the second side takes what is left over. On the
 * event thread.
 */
final class SplitProportions {
    private SplitProportions() {}

    /** Keeps the proportions of all split panes below a component, and of those that are added to it later. */
    static void keep(Component component) {
        ComponentWatch.on(component, found -> {
            if (found instanceof JSplitPane pane) {
                new Keeper(pane).install();
            }
        });
    }

    /** One pane's proportion; not known (NaN) until the divider has a place in a pane with a size. */
    private static final class Keeper extends ComponentAdapter {
        private final JSplitPane pane;
        private int size;
        private double proportion = Double.NaN;
        private boolean moving;

        Keeper(JSplitPane pane) {
            this.pane = pane;
        }

        void install() {
            size = free();
            remember();
            pane.addComponentListener(this);
            pane.addPropertyChangeListener(JSplitPane.DIVIDER_LOCATION_PROPERTY, change -> dividerMoved());
        }

        /** A divider that moves in a pane of the same size was moved by someone; else the pane's layout did it. */
        private void dividerMoved() {
            if (!moving && free() == size) {
                remember();
            }
        }

        @Override
        public void componentResized(ComponentEvent resized) {
            if (free() == size) {
                return;
            }
            size = free();
            if (Double.isNaN(proportion)) {
                remember();
            } else if (size > 0) {
                moving = true;
                pane.setDividerLocation((int) Math.round(proportion * size));
                moving = false;
            }
        }

        private void remember() {
            if (size > 0 && pane.getDividerLocation() >= 0) {
                proportion = Math.min(1, pane.getDividerLocation() / (double) size);
            }
        }

        /** What both sides have together, in pixels. */
        private int free() {
            boolean beside = pane.getOrientation() == JSplitPane.HORIZONTAL_SPLIT;
            return Math.max(0, (beside ? pane.getWidth() : pane.getHeight()) - pane.getDividerSize());
        }
    }
}
