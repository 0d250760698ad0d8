package org.sami.ui.look;

import java.awt.Component;
import java.awt.Graphics;
import javax.swing.Icon;

/** Two icons side by side. */
public final class IconPair implements Icon {
    private static final int GAP = 4;

    private final Icon left;
    private final Icon right;

    public IconPair(Icon left, Icon right) {
        this.left = left;
        this.right = right;
    }

    @Override
    public void paintIcon(Component c, Graphics g, int x, int y) {
        left.paintIcon(c, g, x, y + (getIconHeight() - left.getIconHeight()) / 2);
        right.paintIcon(
                c, g, x + left.getIconWidth() + Look.px(GAP), y + (getIconHeight() - right.getIconHeight()) / 2);
    }

    @Override
    public int getIconWidth() {
        return left.getIconWidth() + Look.px(GAP) + right.getIconWidth();
    }

    @Override
    public int getIconHeight() {
        return Math.max(left.getIconHeight(), right.getIconHeight());
    }
}
