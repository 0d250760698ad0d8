package org.sami.ui.look;

import java.awt.BorderLayout;
import java.awt.Dimension;
import javax.swing.JComponent;
import javax.swing.JScrollPane;

/** Scrolls what is in it upwards and downwards only: it is as wide as the pane, and as high as long as what is in it can be. */
public final class WidthTrackingPanel extends ScrolledPanel {
    private final boolean toLeast;

    public WidthTrackingPanel(JComponent content) {
        this(content, false);
    }

    private WidthTrackingPanel(JComponent content, boolean toLeast) {
        super(new BorderLayout());
        this.toLeast = toLeast;
        add(content);
    }

    /** A pane in which a panel is as high as the pane, and scrolls at its least height where the pane is lower than that. */
    public static JScrollPane fromLeastHeight(JComponent content) {
        return new WidthTrackingPanel(content, true).inPane();
    }

    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return toLeast ? new Dimension(size.width, getMinimumSize().height) : size;
    }

    @Override
    public boolean getScrollableTracksViewportHeight() {
        return getParent() != null && getParent().getHeight() >= getMinimumSize().height;
    }
}
