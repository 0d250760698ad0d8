package org.sami.dreamm.canvas;

import java.awt.BasicStroke;
import java.awt.Cursor;
import java.awt.Graphics2D;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.palette.SemanticColor;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.MovedDrawing;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.FrameBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.ui.net.NetPointer;
import org.sami.ui.net.NetTool;
import org.sami.ui.net.NetView;

/**
 * The pointer of an author: a click selects, with Shift or Ctrl one more; a drag moves what is selected, from a vertex's handle it draws an
 * edge, and on free space it selects what a box holds. The middle and the right button pan.
 */
final class EditTool implements NetTool {
    private static final double CLICK_TOLERANCE = 4;
    private static final double CORNER_TOLERANCE = 11; // pixels from a frame's corner at which it is taken
    private static final BasicStroke BOX = new BasicStroke(1.5f);
    private static final BasicStroke GUIDE =
            new BasicStroke(1.2f, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {5, 4}, 0);

    private final NetView view;
    private final ShownNet net;
    private final NetActions actions;
    private final Connecting connecting;
    private Gesture gesture = Gesture.NONE;
    private boolean snapping = true;
    private double fromX;
    private double fromY;
    private boolean moved;
    private SnapWhileDragging guide = SnapWhileDragging.free(0, 0);
    private final Rectangle2D box = new Rectangle2D.Double();
    private Optional<NetPointer> last = Optional.empty();
    private Optional<String> hovered = Optional.empty();
    private Optional<FrameBox> resized = Optional.empty();

    private enum Gesture {
        NONE,
        MOVE,
        BOX,
        CONNECT,
        APPEND,
        RESIZE
    }

    EditTool(NetView view, ShownNet net, NetActions actions, Connecting connecting) {
        this.view = view;
        this.net = net;
        this.actions = actions;
        this.connecting = connecting;
    }

    /** Where the pointer was last, in drawing units; empty before it came. */
    Optional<LayoutPoint> pointer() {
        return last.map(at -> new LayoutPoint(at.x(), at.y()));
    }

    boolean isSnapping() {
        return snapping;
    }

    void setSnapping(boolean snapping) {
        this.snapping = snapping;
    }

    /** Leaves what is being done; says whether anything was. */
    boolean cancel() {
        boolean was = gesture != Gesture.NONE || connecting.isUnderWay();
        gesture = Gesture.NONE;
        connecting.end();
        view.preview(net.drawing());
        view.repaint();
        return was;
    }

    @Override
    public boolean press(NetPointer pointer) {
        if (pointer.menu()) {
            return false;
        }
        last = Optional.of(pointer);
        actions.endWriting();
        actions.leaveChain();
        fromX = pointer.x();
        fromY = pointer.y();
        moved = false;
        guide = SnapWhileDragging.free(0, 0);
        Optional<Handles> handled = handled(pointer);
        if (connecting.isUnderWay()) {
            gesture = Gesture.CONNECT;
        } else if (handled.isPresent()) {
            boolean append = handled.get().isAppendAt(pointer.x(), pointer.y());
            gesture = append ? Gesture.APPEND : Gesture.CONNECT;
            if (!append) {
                connecting.begin(handled.get().vertex().id());
            }
        } else if (grip(pointer).isPresent() && actions.whyNotEdit("net-move").isEmpty()) {
            resized = grip(pointer);
            gesture = Gesture.RESIZE;
        } else if (element(pointer).isPresent()) {
            gesture = Gesture.MOVE;
            if (!pointer.additive()
                    && !pointer.box()
                    && !view.selected().contains(element(pointer).get())) {
                view.select(Set.of(element(pointer).get()));
            }
        } else {
            gesture = Gesture.BOX;
            box.setFrameFromDiagonal(fromX, fromY, fromX, fromY);
        }
        return true;
    }

    /** The handles of the vertex under the pointer. */
    private Optional<Handles> handles() {
        return hovered.flatMap(net::vertex)
                .map(vertex -> new Handles(
                        vertex,
                        1 / Math.max(0.05, view.zoom()),
                        actions.whyNotEdit("net-append").isEmpty()));
    }

    private Optional<Handles> handled(NetPointer pointer) {
        return handles().filter(handles -> handles.isAt(pointer.x(), pointer.y()));
    }

    private static Optional<String> element(NetPointer pointer) {
        return pointer.element()
                .or(() -> pointer.note().map(note -> NetScene.idOf(note.index())))
                .or(() -> pointer.frame().map(frame -> NetScene.idOfFrame(frame.index())));
    }

    /** The selected frame whose corner the pointer is at. */
    private Optional<FrameBox> grip(NetPointer pointer) {
        return actions.edits()
                .frames()
                .gripAt(view.selected(), pointer.x(), pointer.y(), CORNER_TOLERANCE / view.zoom());
    }

    @Override
    public void drag(NetPointer pointer) {
        last = Optional.of(pointer);
        double dx = pointer.x() - fromX;
        double dy = pointer.y() - fromY;
        moved |= Math.hypot(dx, dy) * view.zoom() > CLICK_TOLERANCE;
        switch (gesture) {
            case MOVE -> dragSelection(dx, dy);
            case BOX -> box.setFrameFromDiagonal(fromX, fromY, pointer.x(), pointer.y());
            case CONNECT -> connecting.pointAt(pointer);
            case RESIZE ->
                resized.ifPresent(
                        frame -> view.preview(actions.edits().frames().resized(frame, pointer.x(), pointer.y())));
            default -> {}
        }
        view.repaint();
    }

    private void dragSelection(double dx, double dy) {
        if (!moved || actions.whyNotEdit("net-move").isPresent()) {
            return;
        }
        Set<String> selected = actions.edits().frames().withContents(view.selected());
        guide = snapping ? snapped(selected, dx, dy) : SnapWhileDragging.free(dx, dy);
        view.preview(MovedDrawing.of(
                net.drawing(),
                selected,
                actions.edits().notes(selected),
                actions.edits().frames().frames(selected),
                guide.dx(),
                guide.dy()));
    }

    private SnapWhileDragging snapped(Set<String> selected, double dx, double dy) {
        Optional<Vertex> held = net.drawing().vertices().stream()
                .filter(vertex -> selected.contains(vertex.id()))
                .filter(vertex -> vertex.box().grown(8).contains(fromX, fromY))
                .findFirst()
                .or(() -> net.drawing().vertices().stream()
                        .filter(vertex -> selected.contains(vertex.id()))
                        .findFirst());
        if (held.isEmpty()) {
            return SnapWhileDragging.free(dx, dy);
        }
        List<LayoutPoint> others = view.scene().vertices().stream()
                .filter(vertex -> !selected.contains(vertex.id()))
                .map(Vertex::centre)
                .toList();
        return SnapWhileDragging.of(held.get().centre(), dx, dy, others);
    }

    @Override
    public void release(NetPointer pointer) {
        Gesture was = gesture;
        gesture = Gesture.NONE;
        switch (was) {
            case MOVE, BOX -> {
                if (!moved) {
                    clicked(pointer);
                } else if (was == Gesture.MOVE) {
                    view.preview(net.drawing());
                    actions.move(view.selected(), guide.dx(), guide.dy());
                } else {
                    selectBox(pointer.additive() || pointer.box());
                }
            }
            case CONNECT -> connecting.finish(pointer, moved || handled(pointer).isEmpty());
            case RESIZE -> resize(pointer);
            case APPEND -> hovered.ifPresent(vertex -> actions.openAppendMenu(vertex, pointer.px(), pointer.py()));
            default -> {}
        }
        view.repaint();
    }

    private void resize(NetPointer pointer) {
        view.preview(net.drawing());
        if (moved && resized.isPresent()) {
            actions.apply(actions.edits().frames().resize(resized.get(), pointer.x(), pointer.y()));
        }
        resized = Optional.empty();
    }

    private void clicked(NetPointer pointer) {
        Optional<String> element = element(pointer);
        boolean more = pointer.additive() || pointer.box();
        if (pointer.clicks() == 2 && !more) {
            if (element.isEmpty()) {
                actions.addBlank(NetDrawing.Kind.PLACE, pointer.x(), pointer.y());
            } else {
                actions.open(element.get());
            }
            return;
        }
        if (pointer.clicks() == 2 && element.isEmpty()) {
            actions.addBlank(NetDrawing.Kind.TRANSITION, pointer.x(), pointer.y());
            return;
        }
        Set<String> selected = new LinkedHashSet<>(more ? view.selected() : Set.of());
        element.filter(id -> !selected.remove(id)).ifPresent(selected::add);
        view.select(selected);
    }

    private void selectBox(boolean more) {
        Set<String> inside = new LinkedHashSet<>(more ? view.selected() : Set.of());
        NetScene scene = view.scene();
        scene.vertices().stream().filter(this::isInBox).forEach(vertex -> inside.add(vertex.id()));
        scene.silhouettes().stream().filter(this::isInBox).forEach(vertex -> inside.add(vertex.id()));
        scene.notes().stream()
                .filter(note -> box.contains(note.x(), note.y()))
                .forEach(note -> inside.add(NetScene.idOf(note.index())));
        view.select(inside);
    }

    private boolean isInBox(Vertex vertex) {
        return box.contains(vertex.centre().x(), vertex.centre().y());
    }

    /** Only the right button comes here: all other presses are taken. */
    @Override
    public void click(NetPointer pointer) {
        Optional<String> element = element(pointer);
        if (element.isPresent() && !view.selected().contains(element.get())) {
            view.select(Set.of(element.get()));
        }
        last = Optional.of(pointer);
        actions.openMenu(pointer.px(), pointer.py());
    }

    @Override
    public void move(NetPointer pointer) {
        last = Optional.of(pointer);
        Optional<String> before = hovered;
        hovered = pointer.vertex()
                .map(Vertex::id)
                .or(() -> handles()
                        .filter(handles -> handles.isNear(pointer.x(), pointer.y()))
                        .map(handles -> handles.vertex().id()));
        if (connecting.isUnderWay()) {
            connecting.pointAt(pointer);
            view.repaint();
        }
        boolean handle = handled(pointer).isPresent();
        view.canvas()
                .setCursor(Cursor.getPredefinedCursor(
                        handle
                                ? Cursor.CROSSHAIR_CURSOR
                                : grip(pointer).isPresent()
                                        ? Cursor.SE_RESIZE_CURSOR
                                        : element(pointer).isPresent() ? Cursor.HAND_CURSOR : Cursor.DEFAULT_CURSOR));
        if (!before.equals(hovered)) {
            view.repaint();
        }
    }

    @Override
    public void paint(Graphics2D g) {
        double pixel = 1 / Math.max(0.01, view.zoom());
        if (gesture == Gesture.NONE
                && !connecting.isUnderWay()
                && actions.whyNotEdit("net-connect").isEmpty()) {
            handles().ifPresent(handles -> handles.paint(g));
        }
        connecting.paint(g);
        if (gesture == Gesture.BOX && moved) {
            g.setColor(SemanticColor.ACCENT.withAlpha(40));
            g.fill(box);
            g.setColor(SemanticColor.ACCENT.get());
            g.setStroke(BOX);
            g.draw(box);
        }
        if (gesture == Gesture.MOVE && moved) {
            Rectangle2D all = g.getClipBounds();
            g.setColor(SemanticColor.ACCENT.get());
            g.setStroke(GUIDE);
            guide.column().ifPresent(x -> g.draw(new Line2D.Double(x, all.getMinY(), x, all.getMaxY() + pixel)));
            guide.row().ifPresent(y -> g.draw(new Line2D.Double(all.getMinX(), y, all.getMaxX() + pixel, y)));
        }
    }
}
