package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.LayoutPoint;

/**
 * A drawing with some vertices elsewhere, while they are dragged: their edges follow as straight lines and words go along. Labels may lie on
 * each other until the drawing is made again; that takes longer than a frame.
 */
public final class MovedDrawing {
    private MovedDrawing() {}

    /**
     * Moves vertices, notes and frames of a drawing.
     *
     * @param vertices ids of those that are moved
     * @param notes indices of those that are moved
     * @param frames indices of those that are moved
     */
    public static NetDrawing of(
            NetDrawing drawing, Set<String> vertices, Set<Integer> notes, Set<Integer> frames, double dx, double dy) {
        Map<String, NetDrawing.Vertex> now = new HashMap<>();
        List<NetDrawing.Vertex> moved = new ArrayList<>();
        for (NetDrawing.Vertex vertex : drawing.vertices()) {
            NetDrawing.Vertex shifted = vertices.contains(vertex.id()) ? vertex.shifted(dx, dy) : vertex;
            moved.add(shifted);
            now.put(vertex.id(), shifted);
        }
        Set<String> pairs = new HashSet<>();
        drawing.edges().forEach(edge -> pairs.add(edge.from() + "\n" + edge.to()));
        Map<String, Double> share = new HashMap<>();
        List<NetDrawing.Edge> edges = new ArrayList<>();
        for (NetDrawing.Edge edge : drawing.edges()) {
            int ends = (vertices.contains(edge.from()) ? 1 : 0) + (vertices.contains(edge.to()) ? 1 : 0);
            if (ends == 0) {
                edges.add(edge);
                continue;
            }
            share.put(edge.id(), ends / 2.0);
            boolean twin = pairs.contains(edge.to() + "\n" + edge.from());
            List<LayoutPoint> line = NetShapes.line(
                    Objects.requireNonNull(now.get(edge.from()), edge.from()),
                    Objects.requireNonNull(now.get(edge.to()), edge.to()),
                    twin);
            edges.add(new NetDrawing.Edge(
                    edge.id(), edge.from(), edge.to(), line, edge.unconditional(), edge.recovery()));
        }
        vertices.forEach(vertex -> share.put(vertex, 1.0));
        List<NetDrawing.Label> labels = new ArrayList<>();
        for (NetDrawing.Label label : drawing.labels()) {
            double part = share.getOrDefault(label.of(), 0.0);
            labels.add(
                    part == 0
                            ? label
                            : new NetDrawing.Label(
                                    label.of(),
                                    label.text(),
                                    label.x() + dx * part,
                                    label.y() + dy * part,
                                    label.onLine()));
        }
        List<NetDrawing.NoteBox> sheets = drawing.notes().stream()
                .map(note -> notes.contains(note.index())
                        ? new NetDrawing.NoteBox(note.index(), note.text(), note.x() + dx, note.y() + dy)
                        : note)
                .toList();
        List<NetDrawing.FrameBox> around = drawing.frames().stream()
                .map(frame -> frames.contains(frame.index())
                        ? new NetDrawing.FrameBox(
                                frame.index(),
                                frame.title(),
                                frame.color(),
                                frame.x() + dx,
                                frame.y() + dy,
                                frame.width(),
                                frame.height())
                        : frame)
                .toList();
        return new NetDrawing(drawing.title(), drawing.scale(), moved, edges, labels, sheets, around);
    }
}
