package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import org.eclipse.elk.alg.layered.LayeredLayoutProvider;
import org.eclipse.elk.alg.layered.options.CycleBreakingStrategy;
import org.eclipse.elk.alg.layered.options.LayerConstraint;
import org.eclipse.elk.alg.layered.options.LayeredMetaDataProvider;
import org.eclipse.elk.alg.layered.options.LayeredOptions;
import org.eclipse.elk.core.data.LayoutMetaDataService;
import org.eclipse.elk.core.math.ElkPadding;
import org.eclipse.elk.core.options.Direction;
import org.eclipse.elk.core.options.EdgeLabelPlacement;
import org.eclipse.elk.core.options.EdgeRouting;
import org.eclipse.elk.core.options.PortConstraints;
import org.eclipse.elk.core.options.PortSide;
import org.eclipse.elk.core.util.BasicProgressMonitor;
import org.eclipse.elk.graph.ElkEdge;
import org.eclipse.elk.graph.ElkEdgeSection;
import org.eclipse.elk.graph.ElkLabel;
import org.eclipse.elk.graph.ElkNode;
import org.eclipse.elk.graph.ElkPort;
import org.eclipse.elk.graph.util.ElkGraphUtil;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/**
 * Lays a net out in layers from left to right. A vertex takes room for itself and its words below it, the words of an edge lie on its
 * line; lines enter a vertex from the left and leave it to the right.
 */
final class LayeredLayout {
    private static final double GAP = 5;

    private final Plan plan;
    private final NetTexts texts;
    private final BooleanSupplier cancelled;
    private final ElkNode graph = ElkGraphUtil.createGraph();
    private final Map<String, Site> sites = new LinkedHashMap<>();
    private final Map<String, ElkEdge> lines = new LinkedHashMap<>();

    /** A vertex in the layout's terms. */
    private record Site(Kind kind, ElkNode node, ElkPort in, ElkPort out) {
        LayoutPoint centre() {
            return new LayoutPoint(node.getX() + node.getWidth() / 2, node.getY() + halfHeight(kind));
        }
    }

    LayeredLayout(Plan plan, NetTexts texts) {
        this(plan, texts, () -> false);
    }

    /**
     * The layout of a plan.
     *
     * @param cancelled is asked again and again while it is made
     */
    LayeredLayout(Plan plan, NetTexts texts, BooleanSupplier cancelled) {
        this.plan = plan;
        this.texts = texts;
        this.cancelled = cancelled;
    }

    NetDrawing draw() {
        for (Place place : plan.places()) {
            addVertex(place.id(), Kind.PLACE);
            if (place.start() != place.end()) {
                LayerConstraint layer = place.start() ? LayerConstraint.FIRST : LayerConstraint.LAST;
                site(place.id()).node().setProperty(LayeredOptions.LAYERING_LAYER_CONSTRAINT, layer);
            }
        }
        plan.transitions().forEach(transition -> addVertex(transition.id(), Kind.TRANSITION));
        plan.inEdges().forEach(edge -> addLine(edge.id(), edge.place(), edge.transition()));
        plan.outEdges().forEach(edge -> addLine(edge.id(), edge.transition(), edge.place()));
        graph.setProperty(LayeredOptions.DIRECTION, Direction.RIGHT);
        graph.setProperty(LayeredOptions.EDGE_ROUTING, EdgeRouting.ORTHOGONAL);
        graph.setProperty(LayeredOptions.CYCLE_BREAKING_STRATEGY, CycleBreakingStrategy.DEPTH_FIRST);
        graph.setProperty(LayeredOptions.PADDING, new ElkPadding(0));
        graph.setProperty(LayeredOptions.SPACING_NODE_NODE, 34.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_NODE, 16.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_EDGE, 14.0);
        graph.setProperty(LayeredOptions.SPACING_LABEL_LABEL, 8.0);
        graph.setProperty(LayeredOptions.SPACING_NODE_NODE_BETWEEN_LAYERS, 26.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_NODE_BETWEEN_LAYERS, 16.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_EDGE_BETWEEN_LAYERS, 12.0);
        LayoutMetaDataService.getInstance().registerLayoutMetaDataProviders(new LayeredMetaDataProvider());
        new LayeredLayoutProvider().layout(graph, new BasicProgressMonitor() {
            @Override
            public boolean isCanceled() {
                return cancelled.getAsBoolean();
            }
        });
        if (cancelled.getAsBoolean()) {
            throw new CancellationException("the layout was cancelled");
        }
        return new NetDrawing(plan.title(), 1, vertices(), edges(), labels());
    }

    private static double halfHeight(Kind kind) {
        return kind == Kind.PLACE ? NetDrawing.PLACE_RADIUS : NetDrawing.BAR_HEIGHT / 2;
    }

    private static double halfWidth(Kind kind) {
        return kind == Kind.PLACE ? NetDrawing.PLACE_RADIUS : NetDrawing.BAR_WIDTH / 2;
    }

    private void addVertex(String id, Kind kind) {
        TextBlock text = texts.of(id);
        ElkNode node = ElkGraphUtil.createNode(graph);
        double width = Math.max(text.width(), 2 * halfWidth(kind));
        double height = 2 * halfHeight(kind) + (text.isEmpty() ? 0 : GAP + text.height());
        node.setDimensions(width, height);
        node.setProperty(LayeredOptions.PORT_CONSTRAINTS, PortConstraints.FIXED_POS);
        sites.put(id, new Site(kind, node, port(node, PortSide.WEST, 0, kind), port(node, PortSide.EAST, width, kind)));
    }

    /** The site of a vertex of the plan. */
    private Site site(String id) {
        return Objects.requireNonNull(sites.get(id), id);
    }

    private static ElkPort port(ElkNode node, PortSide side, double x, Kind kind) {
        ElkPort port = ElkGraphUtil.createPort(node);
        port.setProperty(LayeredOptions.PORT_SIDE, side);
        port.setLocation(x, halfHeight(kind));
        return port;
    }

    private void addLine(String id, String from, String to) {
        Site source = sites.get(from);
        Site target = sites.get(to);
        if (source == null || target == null) {
            return; // a plan with such an edge does not load
        }
        ElkEdge edge = ElkGraphUtil.createSimpleEdge(source.out(), target.in());
        TextBlock text = texts.of(id);
        if (!text.isEmpty()) {
            ElkLabel label = ElkGraphUtil.createLabel(id, edge);
            label.setDimensions(text.width(), text.height());
            label.setProperty(LayeredOptions.EDGE_LABELS_PLACEMENT, EdgeLabelPlacement.CENTER);
            label.setProperty(LayeredOptions.EDGE_LABELS_INLINE, true);
        }
        lines.put(id, edge);
    }

    private List<NetDrawing.Vertex> vertices() {
        List<NetDrawing.Vertex> vertices = new ArrayList<>();
        for (Place place : plan.places()) {
            vertices.add(NetShapes.vertex(place, site(place.id()).centre()));
        }
        for (Transition transition : plan.transitions()) {
            vertices.add(NetShapes.vertex(transition, site(transition.id()).centre()));
        }
        return vertices;
    }

    private List<NetDrawing.Edge> edges() {
        List<NetDrawing.Edge> edges = new ArrayList<>();
        for (InEdge edge : plan.inEdges()) {
            points(edge.id(), edge.place(), edge.transition())
                    .ifPresent(points -> edges.add(new NetDrawing.Edge(
                            edge.id(),
                            edge.place(),
                            edge.transition(),
                            points,
                            NetShapes.isUnconditional(edge),
                            edge.mode() == Mode.RECOVERY)));
        }
        for (OutEdge edge : plan.outEdges()) {
            points(edge.id(), edge.transition(), edge.place())
                    .ifPresent(points -> edges.add(new NetDrawing.Edge(
                            edge.id(),
                            edge.transition(),
                            edge.place(),
                            points,
                            NetShapes.isUnconditional(edge),
                            edge.mode() == Mode.RECOVERY)));
        }
        return edges;
    }

    /** From the rim of one vertex to that of the other: the layout knows their boxes with the words only. */
    private Optional<List<LayoutPoint>> points(String id, String from, String to) {
        ElkEdge edge = lines.get(id);
        if (edge == null) {
            return Optional.empty();
        }
        Site source = site(from);
        Site target = site(to);
        ElkEdgeSection section = edge.getSections().get(0);
        List<LayoutPoint> points = new ArrayList<>();
        points.add(new LayoutPoint(
                source.centre().x() + halfWidth(source.kind()), source.centre().y()));
        points.add(new LayoutPoint(section.getStartX(), section.getStartY()));
        section.getBendPoints().forEach(bend -> points.add(new LayoutPoint(bend.getX(), bend.getY())));
        points.add(new LayoutPoint(section.getEndX(), section.getEndY()));
        points.add(new LayoutPoint(
                target.centre().x() - halfWidth(target.kind()), target.centre().y()));
        return Optional.of(points);
    }

    private List<NetDrawing.Label> labels() {
        List<NetDrawing.Label> labels = new ArrayList<>();
        sites.forEach((id, site) -> {
            TextBlock text = texts.of(id);
            if (!text.isEmpty()) {
                double x = site.centre().x() - text.width() / 2;
                double y = site.node().getY() + 2 * halfHeight(site.kind()) + GAP;
                labels.add(new NetDrawing.Label(id, text, x, y, false));
            }
        });
        lines.forEach((id, edge) -> edge.getLabels()
                .forEach(
                        label -> labels.add(new NetDrawing.Label(id, texts.of(id), label.getX(), label.getY(), true))));
        return labels;
    }
}
