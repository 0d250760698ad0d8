package org.sami.ui.look;

import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;
import javax.swing.BorderFactory;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.Scrollable;

/** A panel that is as wide as the pane in which it is scrolled, and as high as what it holds. No ground of its own. */
public class ScrolledPanel extends JPanel implements Scrollable {
    private static final int STEP = 24;

    /** A panel in which nothing is yet. */
    public ScrolledPanel(LayoutManager layout) {
        super(layout);
        setOpaque(false);
    }

    /** The panel in a pane that scrolls upwards and downwards only. No frame, no ground of its own. */
    public final JScrollPane inPane() {
        JScrollPane pane =
                new JScrollPane(this, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        pane.setBorder(BorderFactory.createEmptyBorder());
        pane.getVerticalScrollBar().setUnitIncrement(Look.px(STEP));
        pane.getViewport().setOpaque(false);
        pane.setOpaque(false);
        return pane;
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public final int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return Look.px(STEP);
    }

    @Override
    public final int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return Math.max(Look.px(STEP), visible.height - Look.px(STEP));
    }

    @Override
    public final boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return false;
    }
}
