package org.sami.ui.net;

import java.awt.BasicStroke;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.RenderingHints;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Rectangle2D;
import javax.swing.JComponent;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.ui.look.Look;

/** The whole net in a corner, with a frame around what is shown; a click or a drag shows another part. */
final class NetOverview extends JComponent {
    private static final int WIDTH = 200;
    private static final int HEIGHT = 120;
    private static final double MARGIN = 6;

    private final transient NetView view;
    private final transient NetViewport viewport;
    private boolean enabledByUser = true;

    NetOverview(NetView view, NetViewport viewport) {
        this.view = view;
        this.viewport = viewport;
        setName("net-overview");
        setToolTipText("Overview: click to show another part (" + NetKey.OVERVIEW.keyText() + " hides it)");
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                go(e);
            }

            @Override
            public void mouseDragged(MouseEvent e) {
                go(e);
            }
        };
        addMouseListener(mouse);
        addMouseMotionListener(mouse);
    }

    @Override
    public Dimension getPreferredSize() {
        return new Dimension(Look.px(WIDTH), Look.px(HEIGHT));
    }

    /** Shows it while not all of the net is seen, or never. */
    void setEnabledByUser(boolean enabledByUser) {
        this.enabledByUser = enabledByUser;
        refresh();
    }

    boolean isEnabledByUser() {
        return enabledByUser;
    }

    /** Another part of the net is shown, or the view has another size. */
    void refresh() {
        setVisible(enabledByUser && !isNeedless());
        repaint();
    }

    /** Whether all of the net is seen, so that an overview would only hide some of it; a small view has none either. */
    private boolean isNeedless() {
        DrawingBox all = view.scene().shownBounds();
        boolean small = view.getWidth() < 3 * getWidth() || view.getHeight() < 3 * getHeight();
        return small
                || viewport.shown()
                        .contains(all.x(), all.y(), Math.max(1e-9, all.width()), Math.max(1e-9, all.height()));
    }

    private double scale(DrawingBox all) {
        return Math.min(
                (getWidth() - 2 * MARGIN) / Math.max(1, all.width()),
                (getHeight() - 2 * MARGIN) / Math.max(1, all.height()));
    }

    private void go(MouseEvent e) {
        DrawingBox all = view.scene().bounds();
        double scale = scale(all);
        viewport.centre(all.x() + (e.getX() - MARGIN) / scale, all.y() + (e.getY() - MARGIN) / scale);
        repaint();
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        Graphics2D g = (Graphics2D) graphics.create();
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        g.setColor(SemanticColor.SURFACE_RAISED.get());
        g.fillRect(0, 0, getWidth(), getHeight());
        DrawingBox all = view.scene().bounds();
        double scale = scale(all);
        g.translate(MARGIN - all.x() * scale, MARGIN - all.y() * scale);
        g.scale(scale, scale);
        view.scene().vertices().forEach(vertex -> mark(g, vertex));
        view.scene().silhouettes().forEach(vertex -> mark(g, vertex));
        g.setColor(SemanticColor.ACCENT.get());
        g.setStroke(new BasicStroke((float) (2 / scale)));
        Rectangle2D shown = viewport.shown();
        g.draw(shown.createIntersection(new Rectangle2D.Double(all.x(), all.y(), all.width(), all.height())));
        g.dispose();
        graphics.setColor(SemanticColor.BORDER.get());
        graphics.drawRect(0, 0, getWidth() - 1, getHeight() - 1);
    }

    private void mark(Graphics2D g, Vertex vertex) {
        SemanticColor color = vertex.start()
                ? SemanticColor.NET_START
                : vertex.end()
                        ? SemanticColor.NET_END
                        : view.marking().isActive(vertex.id()) ? SemanticColor.NET_ACTIVE : SemanticColor.NET_RECOVERY;
        g.setColor(color.get());
        DrawingBox box = vertex.box();
        g.fill(new Rectangle2D.Double(box.x(), box.y(), box.width(), box.height()));
    }
}
