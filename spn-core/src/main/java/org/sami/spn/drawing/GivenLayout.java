package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * Draws a net where its author has laid the vertices, with straight lines. All is drawn apart by one factor, so that there is room for
 * words; each label then takes the nearest place that is free.
 */
final class GivenLayout {
    private static final double COMFORTABLE = 200;
    private static final double LEAST_FACTOR = 0.2;
    private static final double MOST_FACTOR = 4;

    private final Plan plan;
    private final NetTexts texts;
    private final Map<String, NetDrawing.Vertex> vertices = new LinkedHashMap<>();

    GivenLayout(Plan plan, NetTexts texts) {
        this.plan = plan;
        this.texts = texts;
    }

    /** Whether a plan says of each vertex where it lies, and no two lie on each other. */
    static boolean isComplete(Plan plan) {
        return plan.places().stream().map(Place::id).allMatch(plan.layout()::containsKey)
                && plan.transitions().stream().map(Transition::id).allMatch(plan.layout()::containsKey)
                && plan.layout().values().stream().distinct().count()
                        == plan.layout().size();
    }

    NetDrawing draw() {
        double factor = factor(plan.layout().values());
        plan.places().forEach(place -> vertices.put(place.id(), NetShapes.vertex(place, at(place.id(), factor))));
        plan.transitions()
                .forEach(transition ->
                        vertices.put(transition.id(), NetShapes.vertex(transition, at(transition.id(), factor))));
        List<NetDrawing.Edge> edges = new ArrayList<>();
        for (InEdge edge : plan.inEdges()) {
            edges.add(line(
                    edge.id(),
                    edge.place(),
                    edge.transition(),
                    NetShapes.isUnconditional(edge),
                    edge.mode() == Mode.RECOVERY));
        }
        for (OutEdge edge : plan.outEdges()) {
            edges.add(line(
                    edge.id(),
                    edge.transition(),
                    edge.place(),
                    NetShapes.isUnconditional(edge),
                    edge.mode() == Mode.RECOVERY));
        }
        LabelPlacement labels = new LabelPlacement(vertices.values(), edges);
        vertices.values().forEach(vertex -> labels.placeAtVertex(vertex, texts.of(vertex.id())));
        edges.forEach(edge -> labels.placeAtEdge(edge, texts.of(edge.id())));
        return new NetDrawing(plan.title(), factor, List.copyOf(vertices.values()), edges, labels.placed());
    }

    private LayoutPoint at(String id, double factor) {
        LayoutPoint point = plan.layout().get(id);
        return new LayoutPoint(point.x() * factor, point.y() * factor);
    }

    /** So much that vertices which lie near each other, and not merely the nearest two, have room for words between them. */
    private static double factor(Collection<LayoutPoint> points) {
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
        return Math.max(LEAST_FACTOR, Math.min(MOST_FACTOR, COMFORTABLE / Math.max(1, typical)));
    }

    private NetDrawing.Edge line(String id, String from, String to, boolean unconditional, boolean recovery) {
        NetDrawing.Vertex source = vertices.get(from);
        NetDrawing.Vertex target = vertices.get(to);
        List<LayoutPoint> points = List.of(rim(source, target.centre()), rim(target, source.centre()));
        return new NetDrawing.Edge(id, points, unconditional, recovery);
    }

    /** Where the line from a vertex's centre to a point leaves it. */
    private static LayoutPoint rim(NetDrawing.Vertex vertex, LayoutPoint towards) {
        double dx = towards.x() - vertex.centre().x();
        double dy = towards.y() - vertex.centre().y();
        double length = Math.max(1e-9, Math.hypot(dx, dy));
        double part = vertex.kind() == NetDrawing.Kind.PLACE
                ? NetDrawing.PLACE_RADIUS / length
                : Math.min(
                        NetDrawing.BAR_WIDTH / 2 / Math.max(1e-9, Math.abs(dx)),
                        NetDrawing.BAR_HEIGHT / 2 / Math.max(1e-9, Math.abs(dy)));
        return new LayoutPoint(
                vertex.centre().x() + dx * Math.min(1, part), vertex.centre().y() + dy * Math.min(1, part));
    }
}
