package org.sami.ui.value;

import java.awt.Dimension;
import java.awt.LayoutManager;
import javax.swing.JScrollPane;
import javax.swing.UIManager;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.ScrolledPanel;

/** A column that is as wide as the pane it scrolls in, and shows at most some rows at a time. */
final class ScrolledColumn extends ScrolledPanel {
    private final int mostHeight;

    ScrolledColumn(LayoutManager layout, int mostHeight) {
        super(layout);
        this.mostHeight = mostHeight;
    }

    /** The column in a framed pane that scrolls upwards and downwards only. */
    JScrollPane scrolled() {
        JScrollPane pane = inPane();
        LookColors.border(pane, () -> UIManager.getBorder("ScrollPane.border"));
        return pane;
    }

    @Override
    public Dimension getPreferredScrollableViewportSize() {
        Dimension all = getPreferredSize();
        return new Dimension(all.width, Math.min(all.height, Look.px(mostHeight)));
    }
}
