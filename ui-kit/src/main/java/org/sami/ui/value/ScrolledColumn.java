package org.sami.ui.value;

import java.awt.Dimension;
import java.awt.LayoutManager;
import java.awt.Rectangle;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.Scrollable;
import org.sami.ui.look.Look;

/** A column that is as wide as the pane it scrolls in, and shows at most some rows at a time. */
final class ScrolledColumn extends JPanel implements Scrollable {
    private static final int STEP = 40;
    private final int mostHeight;

    ScrolledColumn(LayoutManager layout, int mostHeight) {
        super(layout);
        this.mostHeight = mostHeight;
        setOpaque(false);
    }

    /** The column in a pane that scrolls upwards and downwards only. */
    JScrollPane scrolled() {
        JScrollPane pane =
                new JScrollPane(this, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        pane.getVerticalScrollBar().setUnitIncrement(STEP);
        pane.getViewport().setOpaque(false);
        pane.setOpaque(false);
        return pane;
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        Dimension all = getPreferredSize();
        return new Dimension(all.width, Math.min(all.height, Look.px(mostHeight)));
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return STEP;
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return Math.max(STEP, visible.height - STEP);
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return false;
    }
}
