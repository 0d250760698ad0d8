package org.sami.dreamm.canvas;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Font;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.util.Optional;
import java.util.Set;
import org.sami.palette.SemanticColor;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.ui.net.NetPointer;
import org.sami.ui.net.NetView;

/**
 * An edge that is being drawn, by the pointer or by keys: from a vertex to the one that is pointed at. A target to which no edge can lead says
 * why; on free space the edge gets a new vertex.
 */
final class Connecting {
    private static final BasicStroke LINE =
            new BasicStroke(2.2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 10, new float[] {7, 5}, 0);
    private static final BasicStroke RING = new BasicStroke(3);

    private final NetView view;
    private final ShownNet net;
    private final NetActions actions;
    private Optional<String> from = Optional.empty();
    private Optional<String> target = Optional.empty();
    private LayoutPoint at = new LayoutPoint(0, 0);

    Connecting(NetView view, ShownNet net, NetActions actions) {
        this.view = view;
        this.net = net;
        this.actions = actions;
    }

    boolean isUnderWay() {
        return from.isPresent();
    }

    /** Begins at a vertex, pointing nowhere yet. */
    void begin(String vertex) {
        from = Optional.of(vertex);
        target = Optional.empty();
        at = net.vertex(vertex).map(Vertex::centre).orElse(at);
        actions.tell("Point at the vertex to connect with: click it, or arrows and Enter. Escape leaves");
        view.repaint();
    }

    void end() {
        from = Optional.empty();
        target = Optional.empty();
    }

    void pointAt(NetPointer pointer) {
        target = pointer.vertex().map(Vertex::id).filter(id -> !Optional.of(id).equals(from));
        at = new LayoutPoint(pointer.x(), pointer.y());
    }

    /** Points at the next vertex that lies that way and can be connected. */
    void walk(NetWalk walk, NetWalk.Direction direction) {
        String start = from.orElseThrow();
        walk.next(
                        target.orElse(start),
                        direction,
                        vertex -> actions.edits()
                                .whyNotConnect(start, vertex.id())
                                .isEmpty())
                .ifPresentOrElse(
                        vertex -> {
                            target = Optional.of(vertex.id());
                            at = vertex.centre();
                            view.reveal(Set.of(vertex.id()));
                        },
                        () -> actions.tell("No vertex lies that way to which an edge could lead"));
        view.repaint();
    }

    /**
     * Draws the edge to where the pointer is.
     *
     * @param meant whether the pointer left the handle: after a click on it the next click says where to
     */
    void finish(NetPointer pointer, boolean meant) {
        pointAt(pointer);
        if (meant && !pointer.vertex().map(Vertex::id).equals(from)) {
            finish();
        }
    }

    /** Draws the edge to what is pointed at; to a new vertex where nothing is. */
    void finish() {
        String start = from.orElseThrow();
        Optional<String> end = target;
        LayoutPoint free = at;
        end();
        if (end.isPresent()) {
            actions.connect(start, end.get());
        } else {
            actions.append(start, free.x(), free.y());
        }
        view.repaint();
    }

    /** Whether keys have a target to which they would connect. */
    boolean hasTarget() {
        return target.isPresent();
    }

    void paint(Graphics2D g) {
        Optional<Vertex> source = from.flatMap(net::vertex);
        if (source.isEmpty()) {
            return;
        }
        Optional<String> whyNot =
                target.flatMap(id -> actions.edits().whyNotConnect(source.get().id(), id));
        Color color = (whyNot.isPresent() ? SemanticColor.CRITICAL : SemanticColor.ACCENT).get();
        g.setColor(color);
        g.setStroke(LINE);
        LayoutPoint end = target.flatMap(net::vertex).map(Vertex::centre).orElse(at);
        g.draw(new Line2D.Double(
                source.get().centre().x(), source.get().centre().y(), end.x(), end.y()));
        target.flatMap(net::vertex).ifPresent(vertex -> {
            DrawingBox box = vertex.box().grown(6);
            g.setStroke(RING);
            g.draw(new RoundRectangle2D.Double(box.x(), box.y(), box.width(), box.height(), 14, 14));
        });
        whyNot.ifPresent(why -> say(g, why, end));
    }

    private void say(Graphics2D g, String text, LayoutPoint near) {
        double unit = 1 / Math.max(0.05, view.zoom());
        g.setFont(new Font(Font.SANS_SERIF, Font.PLAIN, 13).deriveFont((float) (13 * unit)));
        Rectangle2D bounds = g.getFontMetrics().getStringBounds(text, g);
        double pad = 7 * unit;
        Rectangle2D shown = g.getClipBounds();
        double x = Math.min(near.x() + 20 * unit, shown.getMaxX() - bounds.getWidth() - 3 * pad);
        double y = Math.max(near.y() - 44 * unit, shown.getMinY() + 2 * pad);
        g.setColor(SemanticColor.CRITICAL_FILL.get());
        g.fill(new RoundRectangle2D.Double(
                x - pad, y - pad, bounds.getWidth() + 2 * pad, bounds.getHeight() + 2 * pad, 8 * unit, 8 * unit));
        g.setColor(SemanticColor.ON_CRITICAL.get());
        g.drawString(text, (float) x, (float) (y + 12.5 * unit));
    }
}
