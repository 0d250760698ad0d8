package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.NetFrame;
import org.sami.spn.model.Note;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * Draws a net where its author has laid the vertices, with straight lines that bend only around vertices ({@link LineRouting}). All is drawn
 * apart by one factor, so that there is room for words; each label then takes the nearest place that is free.
 */
final class GivenLayout {
    private static final double TARGET_SPACING = 200;
    private static final double LEAST_FACTOR = 0.2;
    private static final double MOST_FACTOR = 4;

    private final Plan plan;
    private final NetTexts texts;
    private final Map<String, LayoutPoint> layout;
    private final double factor;
    private final Map<String, NetDrawing.Vertex> vertices = new LinkedHashMap<>();

    /** The two ends of an edge. */
    private record Ends(String from, String to) {}

    GivenLayout(Plan plan, NetTexts texts) {
        this(plan, texts, plan.layout(), comfortableFactor(plan.layout().values()));
    }

    /**
     * The drawing of a plan.
     *
     * @param layout a point of each vertex
     * @param factor how many drawing units one unit of the layout is
     */
    GivenLayout(Plan plan, NetTexts texts, Map<String, LayoutPoint> layout, double factor) {
        this.plan = plan;
        this.texts = texts;
        this.layout = layout;
        this.factor = factor;
    }

    /** Whether a plan says of each vertex where it lies, and no two lie on each other. */
    static boolean isComplete(Plan plan) {
        return plan.places().stream().map(Place::id).allMatch(plan.layout()::containsKey)
                && plan.transitions().stream().map(Transition::id).allMatch(plan.layout()::containsKey)
                && plan.layout().values().stream().distinct().count()
                        == plan.layout().size();
    }

    NetDrawing draw() {
        plan.places().forEach(place -> vertices.put(place.id(), NetShapes.vertex(place, at(place.id()))));
        plan.transitions()
                .forEach(
                        transition -> vertices.put(transition.id(), NetShapes.vertex(transition, at(transition.id()))));
        Set<Ends> ends = new HashSet<>();
        plan.inEdges().forEach(edge -> ends.add(new Ends(edge.place(), edge.transition())));
        plan.outEdges().forEach(edge -> ends.add(new Ends(edge.transition(), edge.place())));
        LineRouting lines = new LineRouting(vertices.values());
        List<NetDrawing.Edge> edges = new ArrayList<>();
        for (InEdge edge : plan.inEdges()) {
            boolean twin = ends.contains(new Ends(edge.transition(), edge.place()));
            edges.add(new NetDrawing.Edge(
                    edge.id(),
                    edge.place(),
                    edge.transition(),
                    lines.line(vertex(edge.place()), vertex(edge.transition()), twin),
                    NetShapes.isUnconditional(edge),
                    edge.mode() == Mode.RECOVERY));
        }
        for (OutEdge edge : plan.outEdges()) {
            boolean twin = ends.contains(new Ends(edge.place(), edge.transition()));
            edges.add(new NetDrawing.Edge(
                    edge.id(),
                    edge.transition(),
                    edge.place(),
                    lines.line(vertex(edge.transition()), vertex(edge.place()), twin),
                    NetShapes.isUnconditional(edge),
                    edge.mode() == Mode.RECOVERY));
        }
        LabelPlacement labels = new LabelPlacement(vertices.values(), edges);
        List<NetDrawing.NoteBox> notes = notes();
        notes.forEach(note -> labels.take(note.box()));
        List<NetDrawing.FrameBox> frames = frames();
        frames.forEach(frame -> labels.take(frame.titleBox()));
        vertices.values().forEach(vertex -> labels.placeAtVertex(vertex, texts.of(vertex.id())));
        edges.forEach(edge -> labels.placeAtEdge(edge, texts.of(edge.id())));
        return new NetDrawing(
                plan.title(), factor, List.copyOf(vertices.values()), edges, labels.placed(), notes, frames);
    }

    private LayoutPoint at(String id) {
        return scaled(Objects.requireNonNull(layout.get(id), id));
    }

    /** The vertex at an end of an edge: a plan whose edges lead elsewhere does not load. */
    private NetDrawing.Vertex vertex(String id) {
        return Objects.requireNonNull(vertices.get(id), id);
    }

    private LayoutPoint scaled(LayoutPoint point) {
        return new LayoutPoint(point.x() * factor, point.y() * factor);
    }

    private List<NetDrawing.NoteBox> notes() {
        List<NetDrawing.NoteBox> boxes = new ArrayList<>();
        for (int i = 0; i < plan.notes().size(); i++) {
            Note note = plan.notes().get(i);
            int index = i;
            note.at()
                    .map(this::scaled)
                    .ifPresent(at -> boxes.add(new NetDrawing.NoteBox(index, texts.of(note), at.x(), at.y())));
        }
        return boxes;
    }

    private List<NetDrawing.FrameBox> frames() {
        List<NetDrawing.FrameBox> boxes = new ArrayList<>();
        for (int i = 0; i < plan.frames().size(); i++) {
            NetFrame frame = plan.frames().get(i);
            LayoutPoint at = scaled(frame.at());
            double width = frame.width() * factor;
            boxes.add(new NetDrawing.FrameBox(
                    i, texts.of(frame, width), frame.color(), at.x(), at.y(), width, frame.height() * factor));
        }
        return boxes;
    }

    /** So much that vertices which lie near each other, and not merely the nearest two, have room for words between them. */
    static double comfortableFactor(Collection<LayoutPoint> points) {
        List<Double> nearest = new ArrayList<>();
        for (LayoutPoint one : points) {
            points.stream()
                    .filter(other -> !other.equals(one))
                    .mapToDouble(other -> Math.hypot(one.x() - other.x(), one.y() - other.y()))
                    .min()
                    .ifPresent(nearest::add);
        }
        if (nearest.isEmpty()) {
            return 1;
        }
        nearest.sort(null);
        double typical = nearest.get(nearest.size() / 4);
        return Math.max(LEAST_FACTOR, Math.min(MOST_FACTOR, TARGET_SPACING / Math.max(1, typical)));
    }
}
