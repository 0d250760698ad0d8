package org.sami.dreamm.learn.view;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.RenderingHints;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.awt.geom.Ellipse2D;
import java.util.HashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import org.sami.dreamm.learn.PictureLayout;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.picture.GraphicsCanvas;
import org.sami.picture.NetFonts;
import org.sami.picture.net.NetBadges;
import org.sami.picture.net.NetFigure;
import org.sami.picture.net.NetLight;
import org.sami.picture.net.NetMarking;
import org.sami.picture.net.NetPainter;
import org.sami.picture.net.NetScene;
import org.sami.picture.net.NetSight;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;
import org.sami.ui.look.FocusFrame;
import org.sami.ui.look.Look;

/**
 * A net as a picture in a text, drawn by the painter of nets: as wide as it has room, no smaller than its words can be read. Elements of it can be picked, by a click
 * or by arrow keys and Space.
 */
final class PictureView extends JPanel {
    private static final int MARGIN = 18;
    private static final double LEAST_ZOOM = 0.8;
    private static final double REACH = 8;
    private static final double RING = 34;

    private final transient ProxyMarks marks;
    private final transient Plan plan;
    private final transient Vocabulary vocabulary;
    private transient NetScene scene;
    private transient Set<String> pickable = Set.of();
    private int drawnFor;
    private transient NetMarking marking = NetMarking.EMPTY;
    private transient Set<String> pointedOut = Set.of();
    private transient Set<String> selected = Set.of();
    private transient Set<String> firing = Set.of();
    private transient ElementWalk walk;
    private transient Consumer<String> picked = id -> {};
    private String cursor = "";
    private boolean cursorAlways;

    /** The picture of a plan, where its author has laid it out. */
    PictureView(Plan plan, Vocabulary vocabulary, ProxyMarks marks) {
        super(null);
        this.marks = marks;
        this.plan = plan;
        this.vocabulary = vocabulary;
        scene = NetScene.of(NetLayout.given(plan, vocabulary, NetFonts::width));
        walk = new ElementWalk(scene, Set.of());
        setName("learn-picture");
        getAccessibleContext().setAccessibleName("Net " + plan.title());
        MouseAdapter mouse = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                if (isEnabled() && walk.size() > 0) {
                    requestFocusInWindow();
                    elementAt(e.getPoint()).ifPresent(PictureView.this::pick);
                }
            }
        };
        addMouseListener(mouse);
        key("LEFT", () -> walk(-1, 0));
        key("RIGHT", () -> walk(1, 0));
        key("UP", () -> walk(0, -1));
        key("DOWN", () -> walk(0, 1));
        key("SPACE", () -> pick(cursor));
        key("ENTER", () -> pick(cursor));
        FocusFrame.watch(this);
    }

    private void key(String stroke, Runnable run) {
        getInputMap(WHEN_FOCUSED).put(KeyStroke.getKeyStroke(stroke), stroke);
        getActionMap().put(stroke, new AbstractAction() {
            @Override
            public boolean isEnabled() {
                return PictureView.this.isEnabled() && walk.size() > 0;
            }

            @Override
            public void actionPerformed(ActionEvent e) {
                run.run();
            }
        });
    }

    /** Has keys that act on the element at which the cursor stands. */
    void addKey(String stroke, Consumer<String> run) {
        key(stroke, () -> run.accept(cursor));
    }

    /** Shows what stands where. */
    void setMarking(NetMarking next) {
        marking = next;
        repaint();
    }

    /** Points elements out. */
    void setPointedOut(Set<String> ids) {
        pointedOut = Set.copyOf(ids);
        repaint();
    }

    /** Shows elements as picked. */
    void setSelected(Set<String> ids) {
        selected = Set.copyOf(ids);
        repaint();
    }

    /** Shows transitions as those that fired last. */
    void setFiring(Set<String> ids) {
        firing = Set.copyOf(ids);
        repaint();
    }

    /** Lets elements be picked, instead of those before. */
    void setPickable(Set<String> ids, Consumer<String> whenPicked) {
        pickable = Set.copyOf(ids);
        walk = new ElementWalk(scene, ids);
        picked = whenPicked;
        cursor = walk.first().orElse("");
        setFocusable(walk.size() > 0);
    }

    /** Shows the cursor although the picture has not the focus: buttons next to it act on the element there. */
    void setCursorAlways(boolean always) {
        cursorAlways = always;
        repaint();
    }

    /** The element at which the keyboard's cursor stands; empty text where nothing can be picked. */
    String cursor() {
        return cursor;
    }

    private void walk(int dx, int dy) {
        cursor = walk.next(cursor, dx, dy);
        walk.at(cursor).ifPresent(at -> scrollRectToVisible(around(at)));
        repaint();
    }

    private void pick(String id) {
        if (walk.at(id).isPresent()) {
            cursor = id;
            picked.accept(id);
            repaint();
        }
    }

    private Optional<String> elementAt(Point pixel) {
        double x = (pixel.x - originX()) / scale();
        double y = (pixel.y - originY()) / scale();
        return scene.vertexAt(x, y, REACH)
                .map(Vertex::id)
                .filter(id -> walk.at(id).isPresent())
                .or(() -> scene.edgeAt(x, y, REACH)
                        .map(Edge::id)
                        .filter(id -> walk.at(id).isPresent()));
    }

    /** Where the middle of an element lies, in pixels, for those who drive the window. */
    Point pixelOf(String id) {
        LayoutPoint at = walk.at(id).orElseThrow();
        return new Point((int) (at.x() * scale() + originX()), (int) (at.y() * scale() + originY()));
    }

    private Rectangle around(LayoutPoint at) {
        int r = (int) (RING * scale());
        return new Rectangle(
                (int) (at.x() * scale() + originX()) - r, (int) (at.y() * scale() + originY()) - r, 2 * r, 2 * r);
    }

    private double own() {
        return Look.scalePercent() / 100.0;
    }

    private int room() {
        return getParent() == null ? getWidth() : getParent().getWidth();
    }

    /** Draws the net for the width that there is. */
    private void fit() {
        int room = (int) ((room() - 2 * Look.px(MARGIN)) / (LEAST_ZOOM * own()));
        if (room > 0 && room != drawnFor) {
            drawnFor = room;
            scene = NetScene.of(PictureLayout.of(plan, vocabulary, room));
            walk = new ElementWalk(scene, pickable);
        }
    }

    private double scale() {
        double fitting =
                (room() - 2.0 * Look.px(MARGIN)) / Math.max(1, scene.bounds().width());
        return Math.max(LEAST_ZOOM * own(), Math.min(own(), fitting));
    }

    private double originX() {
        DrawingBox net = scene.bounds();
        return Math.max(Look.px(MARGIN), (getWidth() - net.width() * scale()) / 2) - net.x() * scale();
    }

    private double originY() {
        return Look.px(MARGIN) - scene.bounds().y() * scale();
    }

    @Override
    public Dimension getPreferredSize() {
        fit();
        return new Dimension(
                (int) Math.ceil(scene.bounds().width() * scale()) + 2 * Look.px(MARGIN),
                (int) Math.ceil(scene.bounds().height() * scale()) + 2 * Look.px(MARGIN));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
        fit();
        Graphics2D g = (Graphics2D) graphics.create();
        g.setColor(SemanticColor.NET_CANVAS.get());
        g.fillRect(0, 0, getWidth(), getHeight());
        g.translate(originX(), originY());
        g.scale(scale(), scale());
        Set<String> lit = new HashSet<>(selected);
        lit.addAll(pointedOut);
        NetLight light = new NetLight(lit, Set.of(), id -> firing.contains(id) ? 1 : 0, Map.of());
        NetPainter.paint(
                new GraphicsCanvas(g),
                Look.theme(),
                marks,
                new NetFigure(scene, marking, NetBadges.NONE, light),
                new NetSight(scene.bounds().grown(RING), scale(), own()));
        if (isEnabled() && (cursorAlways || isFocusOwner())) {
            walk.at(cursor).ifPresent(at -> paintCursor(g, at));
        }
        g.dispose();
        FocusFrame.paint(graphics, this);
    }

    private static void paintCursor(Graphics2D g, LayoutPoint at) {
        g.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON);
        Color color = SemanticColor.ACCENT.get();
        g.setColor(color);
        g.setStroke(new BasicStroke(2f, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND, 10, new float[] {6, 5}, 0));
        g.draw(new Ellipse2D.Double(at.x() - RING, at.y() - RING, 2 * RING, 2 * RING));
    }
}
