package org.sami.dreamm.learn.show;

import java.awt.BasicStroke;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.geom.Path2D;
import java.awt.geom.RoundRectangle2D;
import java.util.Optional;
import javax.swing.JComponent;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;

/** Lies over the whole window while something is shown: draws the pointer and what it points at, holds the bar at its lower edge, and keeps the mouse from the editor. */
final class ShowOverlay extends JComponent {
    private final JComponent bar;
    private Optional<Point> pointer = Optional.empty();
    private Optional<Rectangle> aim = Optional.empty();
    private int highest;

    ShowOverlay(JComponent bar) {
        this.bar = bar;
        setName("show-overlay");
        setOpaque(false);
        setLayout(null);
        add(bar);
        MouseAdapter nothing = new MouseAdapter() {};
        addMouseListener(nothing);
        addMouseMotionListener(nothing);
        addMouseWheelListener(nothing);
    }

    /** How high the bar is at the width of the window; never lower than before, so that nothing moves while sentences change. */
    int barHeight() {
        bar.setSize(getWidth(), bar.getHeight());
        bar.doLayout(); // a text that wraps says its height only after it has a width
        highest = Math.max(highest, bar.getPreferredSize().height);
        return highest;
    }

    /** Lets the bar be as high as it wants to be again: with another look, or another width. */
    void forgetHeight() {
        highest = 0;
    }

    /** Draws the pointer at a point, and a ring around what it points at. */
    void point(Optional<Point> at, Optional<Rectangle> what) {
        if (!pointer.equals(at) || !aim.equals(what)) {
            pointer = at;
            aim = what;
            repaint();
        }
    }

    /** Where the pointer is drawn. */
    Optional<Point> pointer() {
        return pointer;
    }

    @Override
    public void doLayout() {
        int height = Math.min(barHeight(), getHeight());
        bar.setBounds(0, getHeight() - height, getWidth(), height);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        aim.ifPresent(what -> ring(g, what));
        pointer.ifPresent(at -> arrow(g, at));
        g.dispose();
    }

    private static void ring(Graphics2D g, Rectangle what) {
        int grow = Look.px(5);
        RoundRectangle2D ring = new RoundRectangle2D.Double(
                what.x - grow,
                what.y - grow,
                what.width + 2.0 * grow,
                what.height + 2.0 * grow,
                Look.px(12),
                Look.px(12));
        g.setColor(SemanticColor.SURFACE.get());
        g.setStroke(new BasicStroke(Look.px(6)));
        g.draw(ring);
        g.setColor(SemanticColor.ACCENT.get());
        g.setStroke(new BasicStroke(Look.px(3)));
        g.draw(ring);
    }

    /** An arrow as pointers are, its tip at the point, large enough to be followed. */
    private static void arrow(Graphics2D g, Point at) {
        double unit = Look.px(100) / 100.0 * 1.6;
        double[][] outline = {{0, 0}, {0, 17}, {4, 13.2}, {6.8, 19.4}, {9.6, 18.2}, {6.9, 12.2}, {12.2, 12.2}};
        Path2D arrow = new Path2D.Double();
        arrow.moveTo(at.x, at.y);
        for (double[] corner : outline) {
            arrow.lineTo(at.x + corner[0] * unit, at.y + corner[1] * unit);
        }
        arrow.closePath();
        g.setColor(SemanticColor.ACCENT.get());
        g.fill(arrow);
        g.setColor(SemanticColor.SURFACE.get());
        g.setStroke(new BasicStroke(Look.px(2), BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
        g.draw(arrow);
    }
}
