package org.sami.picture.net;

import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.FrameBox;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Label;
import org.sami.spn.drawing.NetDrawing.NoteBox;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;

/**
 * What of a net is shown in a mode, with something selected: vertices in full or as silhouettes, edges, labels. It paints nothing and
 * knows no window. Immutable.
 */
public final class NetScene {
    private final NetDrawing drawing;
    private final Set<String> full;
    private final Set<String> silhouettes;
    private final List<Edge> edges;
    private final List<Label> labels;
    private final List<NoteBox> notes;
    private final List<Vertex> shown;

    /** The vertices at the ends of an edge. */
    private record Ends(String from, String to) {}

    private NetScene(NetDrawing drawing, Set<String> full, Set<String> silhouettes, Set<String> edges, boolean notes) {
        this.notes = notes ? drawing.notes() : List.of();
        this.drawing = drawing;
        this.full = full;
        this.silhouettes = silhouettes;
        this.shown = drawing.vertices().stream()
                .filter(vertex -> full.contains(vertex.id()))
                .toList();
        this.edges = drawing.edges().stream()
                .filter(edge -> edges.contains(edge.id()))
                .toList();
        this.labels = drawing.labels().stream()
                .filter(label -> full.contains(label.of()) || edges.contains(label.of()))
                .toList();
    }

    /**
     * What is shown of a plan.
     *
     * @param drawing where it all lies
     * @param selected ids of vertices and edges; those of other plans are left alone
     */
    public static NetScene of(Plan plan, NetDrawing drawing, NetMode mode, Set<String> selected) {
        Map<String, Ends> ends = new LinkedHashMap<>();
        plan.inEdges().forEach(edge -> ends.put(edge.id(), new Ends(edge.place(), edge.transition())));
        plan.outEdges().forEach(edge -> ends.put(edge.id(), new Ends(edge.transition(), edge.place())));
        return switch (mode) {
            case ALL -> of(drawing);
            case NOMINAL -> nominal(drawing, ends);
            case RECOVERY -> recovery(drawing, ends, selected);
        };
    }

    /** All of a net. */
    public static NetScene of(NetDrawing drawing) {
        Set<String> edges = drawing.edges().stream().map(Edge::id).collect(Collectors.toSet());
        return new NetScene(drawing, ids(drawing.vertices()), Set.of(), edges, true);
    }

    private static Set<String> ids(List<Vertex> vertices) {
        return vertices.stream().map(Vertex::id).collect(Collectors.toCollection(LinkedHashSet::new));
    }

    private static NetScene nominal(NetDrawing drawing, Map<String, Ends> ends) {
        Set<String> vertices = ids(
                drawing.vertices().stream().filter(vertex -> !vertex.recovery()).toList());
        Set<String> edges = new LinkedHashSet<>();
        for (Edge edge : drawing.edges()) {
            Ends at = Objects.requireNonNull(ends.get(edge.id()), edge.id());
            if (!edge.recovery() && vertices.contains(at.from()) && vertices.contains(at.to())) {
                edges.add(edge.id());
            }
        }
        return new NetScene(drawing, vertices, Set.of(), edges, true);
    }

    private static NetScene recovery(NetDrawing drawing, Map<String, Ends> ends, Set<String> selected) {
        Set<String> full = new LinkedHashSet<>();
        Set<String> edges = new LinkedHashSet<>();
        ends.forEach((id, at) -> {
            if (selected.contains(id) || selected.contains(at.from()) || selected.contains(at.to())) {
                edges.add(id);
                full.add(at.from());
                full.add(at.to());
            }
        });
        Set<String> silhouettes = new LinkedHashSet<>();
        for (String id : ids(drawing.vertices())) {
            if (selected.contains(id)) {
                full.add(id);
            } else if (!full.contains(id)) {
                silhouettes.add(id);
            }
        }
        return new NetScene(drawing, full, silhouettes, edges, false);
    }

    /** The vertices that are shown with all that is written at them. */
    public List<Vertex> vertices() {
        return shown;
    }

    /** The vertices that are shown without words. */
    public List<Vertex> silhouettes() {
        return drawing.vertices().stream()
                .filter(vertex -> silhouettes.contains(vertex.id()))
                .toList();
    }

    /** The edges that are shown. */
    public List<Edge> edges() {
        return edges;
    }

    /** The notes that are shown: in recovery mode none, as all other words. */
    public List<NoteBox> notes() {
        return notes;
    }

    /** What a note is called where elements are called by their ids. No element is called so: ids of plans have no blank at the end. */
    public static String idOf(int note) {
        return "note " + note + " ";
    }

    /** The frames: they are shown in every mode, as they say what the parts of the net are. */
    public List<FrameBox> frames() {
        return drawing.frames();
    }

    /** What a frame is called where elements are called by their ids, as {@link #idOf} for notes. */
    public static String idOfFrame(int frame) {
        return "frame " + frame + " ";
    }

    /** The frame whose rim or head is at a point, the smallest of several; none where there is none. */
    public Optional<FrameBox> frameAt(double x, double y, double reach) {
        return frames().stream()
                .filter(frame -> frame.isHeldAt(x, y, reach))
                .min(Comparator.comparingDouble(frame -> frame.width() * frame.height()));
    }

    /** The note at a point; none where there is none. */
    public Optional<NoteBox> noteAt(double x, double y) {
        return notes.stream().filter(note -> note.box().contains(x, y)).findFirst();
    }

    /** The texts that are shown, of vertices and edges. */
    public List<Label> labels() {
        return labels;
    }

    /** The box around all there is, shown or not: what is hidden moves nothing. */
    public DrawingBox bounds() {
        return drawing.bounds();
    }

    /** The box around what is shown with its words; that of all there is where nothing is shown. */
    public DrawingBox shownBounds() {
        return Stream.of(
                        Stream.concat(vertices().stream(), silhouettes().stream())
                                .map(Vertex::box),
                        labels.stream().map(Label::box),
                        notes.stream().map(NoteBox::box),
                        frames().stream().map(FrameBox::box))
                .flatMap(Function.identity())
                .reduce(DrawingBox::union)
                .orElse(bounds());
    }

    /** The box around some of the vertices that are shown; none where none of them is. */
    public Optional<DrawingBox> boxOf(Set<String> ids) {
        return vertices().stream()
                .filter(vertex -> ids.contains(vertex.id()))
                .map(Vertex::box)
                .reduce(DrawingBox::union);
    }

    /** The box around the words of some of the vertices that are shown. */
    public Optional<DrawingBox> boxOfLabels(Set<String> ids) {
        return labels.stream()
                .filter(label -> ids.contains(label.of()) && full.contains(label.of()))
                .map(Label::box)
                .reduce(DrawingBox::union);
    }

    /** The box around some of the vertices and notes that are shown, with their words. */
    public Optional<DrawingBox> boxWithWords(Set<String> ids) {
        return Stream.of(
                        boxOf(ids).stream(),
                        boxOfLabels(ids).stream(),
                        notes.stream()
                                .filter(note -> ids.contains(idOf(note.index())))
                                .map(NoteBox::box),
                        frames().stream()
                                .filter(frame -> ids.contains(idOfFrame(frame.index())))
                                .map(FrameBox::box))
                .flatMap(Function.identity())
                .reduce(DrawingBox::union);
    }

    /** The vertex at a point, or so near that it is meant; none where there is none. */
    public Optional<Vertex> vertexAt(double x, double y, double reach) {
        return drawing.vertices().stream()
                .filter(vertex -> full.contains(vertex.id()) || silhouettes.contains(vertex.id()))
                .filter(vertex -> isAt(vertex, x, y, reach))
                .findFirst()
                .or(() -> labelAt(x, y)
                        .flatMap(label -> drawing.vertices().stream()
                                .filter(vertex -> vertex.id().equals(label.of()))
                                .findFirst()));
    }

    private static boolean isAt(Vertex vertex, double x, double y, double reach) {
        return vertex.kind() == Kind.PLACE
                ? Math.hypot(x - vertex.centre().x(), y - vertex.centre().y()) <= NetDrawing.PLACE_RADIUS + reach
                : vertex.box().grown(reach).contains(x, y);
    }

    /** The edge at a point or at whose words it is; none where there is none. */
    public Optional<Edge> edgeAt(double x, double y, double reach) {
        Optional<Edge> near = edges.stream()
                .filter(edge -> isAt(edge, new DrawingBox(x - reach, y - reach, 2 * reach, 2 * reach)))
                .findFirst();
        return near.or(() -> labelAt(x, y)
                .flatMap(label -> edges.stream()
                        .filter(edge -> edge.id().equals(label.of()))
                        .findFirst()));
    }

    private static boolean isAt(Edge edge, DrawingBox box) {
        List<LayoutPoint> points = edge.points();
        for (int i = 1; i < points.size(); i++) {
            if (box.isCrossedBy(points.get(i - 1), points.get(i))) {
                return true;
            }
        }
        return false;
    }

    private Optional<Label> labelAt(double x, double y) {
        return labels.stream().filter(label -> label.box().contains(x, y)).findFirst();
    }
}
