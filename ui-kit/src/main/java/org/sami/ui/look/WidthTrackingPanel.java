package org.sami.ui.look;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Rectangle;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.Scrollable;

/** Scrolls what is in it upwards and downwards only: it is as wide as the pane, and as high as long as what is in it can be. */
public final class WidthTrackingPanel extends JPanel implements Scrollable {
    private static final int STEP = 16;

    private final boolean toLeast;

    public WidthTrackingPanel(JComponent content) {
        this(content, false);
    }

    private WidthTrackingPanel(JComponent content, boolean toLeast) {
        super(new BorderLayout());
        this.toLeast = toLeast;
        setOpaque(false);
        add(content);
    }

    /** A pane in which a panel is as high as the pane, and scrolls at its least height where the pane is lower than that. */
    public static JScrollPane fromLeastHeight(JComponent content) {
        JScrollPane pane = new JScrollPane(
                new WidthTrackingPanel(content, true),
                JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED,
                JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        pane.setBorder(BorderFactory.createEmptyBorder());
        return pane;
    }

    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return toLeast ? new Dimension(size.width, getMinimumSize().height) : size;
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
