package org.sami.ui.look;

import java.awt.Component;
import java.awt.Graphics;
import java.awt.Graphics2D;
import javax.swing.Icon;

/** A proxy's mark as an icon, beside its name. */
public final class MarkIcon implements Icon {
    private static final int SIZE = 14;
    private final IdentityMark mark;

    /** An icon of this mark. */
    public MarkIcon(IdentityMark mark) {
        this.mark = mark;
    }

    @Override
    public void paintIcon(Component c, Graphics g, int x, int y) {
        double size = getIconWidth();
        mark.paint((Graphics2D) g, x + size / 2, y + size / 2, size - Look.px(3));
    }

    @Override
    public int getIconWidth() {
        return Look.px(SIZE);
    }

    @Override
    public int getIconHeight() {
        return Look.px(SIZE);
    }
}
