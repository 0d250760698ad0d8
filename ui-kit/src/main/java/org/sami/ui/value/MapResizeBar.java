package org.sami.ui.value;

import java.awt.Cursor;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.event.ActionEvent;
import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.function.IntConsumer;
import java.util.function.IntSupplier;
import javax.swing.AbstractAction;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;

/** A bar below a map with which it is made higher or lower: dragged, or with Up and Down. */
final class MapResizeBar extends JPanel {
    private static final int HIGH = 10;
    private static final int STEP = 40;
    private static final int MARK = 36;

    /**
     * A bar.
     *
     * @param height of the map now, in pixels
     * @param resize makes the map so high
     */
    MapResizeBar(IntSupplier height, IntConsumer resize) {
        setCursor(Cursor.getPredefinedCursor(Cursor.S_RESIZE_CURSOR));
        setToolTipText("Drag, or press Up or Down, to make the map lower or higher");
        setFocusable(true);
        setOpaque(false);
        MouseAdapter drag = new MouseAdapter() {
            private int from;
            private int before;

            @Override
            public void mousePressed(MouseEvent e) {
                requestFocusInWindow();
                from = e.getYOnScreen();
                before = height.getAsInt();
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                resize.accept(before + e.getYOnScreen() - from);
            }
        };
        addMouseListener(drag);
        addMouseMotionListener(drag);
        addFocusListener(new FocusAdapter() {
            @Override
            public void focusGained(FocusEvent e) {
                repaint();
            }

            @Override
            public void focusLost(FocusEvent e) {
                repaint();
            }
        });
        onKey("UP", () -> resize.accept(height.getAsInt() - Look.px(STEP)));
        onKey("DOWN", () -> resize.accept(height.getAsInt() + Look.px(STEP)));
        getAccessibleContext().setAccessibleName("Height of the map");
    }

    private void onKey(String key, Runnable pressed) {
        getInputMap().put(KeyStroke.getKeyStroke(key), key);
        getActionMap().put(key, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                pressed.run();
            }
        });
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.px(MARK), Look.px(HIGH));
    }

    @Override
    protected void paintComponent(Graphics g) {
        g.setColor((isFocusOwner() ? SemanticColor.ACCENT : SemanticColor.MUTED).get());
        int wide = Look.px(MARK);
        int high = Look.px(2);
        g.fillRect((getWidth() - wide) / 2, getHeight() / 2 - high, wide, high);
    }
}
