package org.sami.crw.gui.value;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.Scrollable;
import org.sami.ui.look.Look;

/** Scrolls what is in it upwards and downwards only: it is as wide as the pane, and as high as long as what is in it can be. */
public final class WidthTrackingPanel extends JPanel implements Scrollable {
    private static final int STEP = 16;

    public WidthTrackingPanel(JComponent content) {
        super(new BorderLayout());
        setOpaque(false);
        add(content);
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        return getPreferredSize();
    }

    @Override
    public int getScrollableUnitIncrement(Rectangle visible, int orientation, int direction) {
        return Look.px(STEP);
    }

    @Override
    public int getScrollableBlockIncrement(Rectangle visible, int orientation, int direction) {
        return Math.max(1, visible.height - Look.px(STEP));
    }

    @Override
    public boolean getScrollableTracksViewportWidth() {
        return true;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent() != null && getParent().getHeight() >= getMinimumSize().height;
    }
}
