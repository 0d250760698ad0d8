package org.sami.dreamm.canvas;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.FrameBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.FrameEdit;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.NetFrame;

/** What gestures and keys mean as edits of frames. A frame carries along what lies in it. Coordinates are those of the drawing. Knows no window. */
final class FrameEdits {
    private static final double FRAME_MARGIN = 24;
    private static final double HEAD = 24;
    private static final double LEAST = 48;
    private static final double FIRST_WIDTH = 320;
    private static final double FIRST_HEIGHT = 200;

    private final ShownNet net;

    FrameEdits(ShownNet net) {
        this.net = Objects.requireNonNull(net, "net");
    }

    /** The indices of the frames that are selected. */
    Set<Integer> frames(Set<String> selection) {
        Set<Integer> frames = new LinkedHashSet<>();
        for (FrameBox frame : net.drawing().frames()) {
            if (selection.contains(NetScene.idOfFrame(frame.index()))) {
                frames.add(frame.index());
            }
        }
        return frames;
    }

    /** A selection with all that lies in its frames: vertices and notes, and frames that lie in it as a whole. */
    Set<String> withContents(Set<String> selection) {
        Set<String> all = new LinkedHashSet<>(selection);
        NetDrawing drawing = net.drawing();
        for (FrameBox frame : drawing.frames()) {
            if (!selection.contains(NetScene.idOfFrame(frame.index()))) {
                continue;
            }
            members(frame).forEach(vertex -> all.add(vertex.id()));
            drawing.notes().stream()
                    .filter(note -> frame.box().contains(note.x(), note.y()))
                    .forEach(note -> all.add(NetScene.idOf(note.index())));
            drawing.frames().stream()
                    .filter(other -> frame.box().contains(other.box()))
                    .forEach(other -> all.add(NetScene.idOfFrame(other.index())));
        }
        return all;
    }

    private List<Vertex> members(FrameBox frame) {
        return net.drawing().vertices().stream()
                .filter(vertex -> frame.box()
                        .contains(vertex.centre().x(), vertex.centre().y()))
                .toList();
    }

    /** Adds a frame around the selected vertices with their words, or at a point where none is selected; returns its id. */
    MakingEdit add(Set<String> selection, LayoutPoint at) {
        NetDrawing drawing = net.drawing();
        Optional<DrawingBox> around = drawing.vertices().stream()
                .filter(vertex -> selection.contains(vertex.id()))
                .map(Vertex::box)
                .reduce(DrawingBox::union)
                .map(box -> drawing.labels().stream()
                        .filter(label -> selection.contains(label.of()))
                        .map(NetDrawing.Label::box)
                        .reduce(box, DrawingBox::union)
                        .grown(FRAME_MARGIN));
        DrawingBox box = around.map(b -> new DrawingBox(b.x(), b.y() - HEAD, b.width(), b.height() + HEAD))
                .orElse(new DrawingBox(at.x(), at.y(), FIRST_WIDTH, FIRST_HEIGHT));
        return new MakingEdit(
                new FrameEdit.AddFrame(net.plan().id(), framed(new NetFrame("", nextColor(), at, 1, 1), box)),
                Set.of(NetScene.idOfFrame(net.plan().frames().size())));
    }

    /** The first colour that no frame of the plan has; blue where all are used. */
    private FrameColor nextColor() {
        Set<FrameColor> used = new LinkedHashSet<>();
        net.plan().frames().forEach(frame -> used.add(frame.color()));
        for (FrameColor color : FrameColor.values()) {
            if (!used.contains(color)) {
                return color;
            }
        }
        return FrameColor.BLUE;
    }

    private NetFrame framed(NetFrame frame, DrawingBox box) {
        LayoutPoint size = net.toPlan(box.width(), box.height());
        return frame.withAt(net.toPlan(box.x(), box.y())).withSize(size.x(), size.y());
    }

    /** Moves the selected frames themselves. */
    Optional<Edit> move(Set<String> selection, double dx, double dy) {
        Map<Integer, LayoutPoint> to = new LinkedHashMap<>();
        for (FrameBox frame : net.drawing().frames()) {
            if (selection.contains(NetScene.idOfFrame(frame.index()))) {
                to.put(frame.index(), net.toPlan(frame.x() + dx, frame.y() + dy));
            }
        }
        return to.isEmpty()
                ? Optional.empty()
                : Optional.of(new FrameEdit.MoveFrames(net.plan().id(), to));
    }

    /** The selected frame whose lower right corner is at a point. */
    Optional<FrameBox> gripAt(Set<String> selection, double x, double y, double reach) {
        return net.drawing().frames().stream()
                .filter(frame -> selection.contains(NetScene.idOfFrame(frame.index())))
                .filter(frame -> Math.abs(x - frame.box().maxX()) <= reach
                        && Math.abs(y - frame.box().maxY()) <= reach)
                .findFirst();
    }

    /** The drawing with a frame of another size, whose lower right corner is at a point. */
    NetDrawing resized(FrameBox frame, double x, double y) {
        NetDrawing drawing = net.drawing();
        DrawingBox size = size(frame, x, y);
        return new NetDrawing(
                drawing.title(),
                drawing.scale(),
                drawing.vertices(),
                drawing.edges(),
                drawing.labels(),
                drawing.notes(),
                drawing.frames().stream()
                        .map(each -> each.index() != frame.index()
                                ? each
                                : new FrameBox(
                                        each.index(),
                                        each.title(),
                                        each.color(),
                                        each.x(),
                                        each.y(),
                                        size.width(),
                                        size.height()))
                        .toList());
    }

    /** Gives a frame another size. */
    Edit resize(FrameBox frame, double x, double y) {
        NetFrame now = net.plan().frames().get(frame.index());
        return new FrameEdit.SetFrame(net.plan().id(), frame.index(), framed(now, size(frame, x, y)));
    }

    private static DrawingBox size(FrameBox frame, double x, double y) {
        return new DrawingBox(frame.x(), frame.y(), Math.max(LEAST, x - frame.x()), Math.max(LEAST, y - frame.y()));
    }

    /** Edits by which frames go on around their vertices when those are laid out again: with as much room around them as before. */
    List<Edit> following(Map<String, LayoutPoint> centres) {
        List<Edit> edits = new ArrayList<>();
        for (FrameBox frame : net.drawing().frames()) {
            List<Vertex> members = members(frame);
            Optional<DrawingBox> was =
                    bounds(members.stream().map(Vertex::centre).toList());
            Optional<DrawingBox> is = bounds(members.stream()
                    .map(vertex -> centres.getOrDefault(vertex.id(), vertex.centre()))
                    .toList());
            if (was.isPresent() && is.isPresent()) {
                DrawingBox from = was.get();
                DrawingBox to = is.get();
                DrawingBox box = new DrawingBox(
                        to.x() - (from.x() - frame.x()),
                        to.y() - (from.y() - frame.y()),
                        to.width() + frame.width() - from.width(),
                        to.height() + frame.height() - from.height());
                edits.add(new FrameEdit.SetFrame(
                        net.plan().id(),
                        frame.index(),
                        framed(net.plan().frames().get(frame.index()), box)));
            }
        }
        return edits;
    }

    private static Optional<DrawingBox> bounds(List<LayoutPoint> points) {
        return points.stream()
                .map(point -> new DrawingBox(point.x(), point.y(), 0, 0))
                .reduce(DrawingBox::union);
    }
}
