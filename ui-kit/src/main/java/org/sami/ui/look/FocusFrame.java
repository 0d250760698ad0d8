package org.sami.ui.look;

import java.awt.Graphics;
import java.awt.Rectangle;
import java.awt.event.FocusEvent;
import java.awt.event.FocusListener;
import javax.swing.JComponent;
import org.sami.palette.SemanticColor;

/** A line around what is seen of a component while it has the keyboard's focus, for those whose look shows none. On the event thread. */
public final class FocusFrame {
    private static final int WIDTH = 2;

    private FocusFrame() {}

    /** Has a component repainted when the focus comes to it or leaves it; it paints the line itself. */
    public static void watch(JComponent component) {
        component.addFocusListener(new FocusListener() {
            @Override
            public void focusGained(FocusEvent e) {
                component.repaint();
            }

            @Override
            public void focusLost(FocusEvent e) {
                component.repaint();
            }
        });
    }

    /** Paints the line, where the component has the focus. */
    public static void paint(Graphics g, JComponent component) {
        if (!component.isFocusOwner()) {
            return;
        }
        Rectangle seen = component.getVisibleRect();
        g.setColor(SemanticColor.ACCENT.get());
        for (int i = 0; i < Look.px(WIDTH); i++) {
            g.drawRect(seen.x + i, seen.y + i, seen.width - 1 - 2 * i, seen.height - 1 - 2 * i);
        }
    }
}
