package org.sami.spn.drawing.states;

import java.util.ArrayList;
import java.util.List;
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
import org.eclipse.elk.core.util.BasicProgressMonitor;
import org.eclipse.elk.graph.ElkEdge;
import org.eclipse.elk.graph.ElkEdgeSection;
import org.eclipse.elk.graph.ElkLabel;
import org.eclipse.elk.graph.ElkNode;
import org.eclipse.elk.graph.util.ElkGraphUtil;
import org.sami.spn.drawing.DrawingBox;
import org.sami.spn.drawing.TextBlock;
import org.sami.spn.drawing.TextMeasure;
import org.sami.spn.drawing.TextStyle;
import org.sami.spn.model.LayoutPoint;

/**
 * Lays a graph of states out in layers from top to bottom, the initial state first. Takes seconds for a thousand states, so not for a thread that paints.
 */
public final class StateGraphLayout {
    /** So many states can still be looked at; more are slow to lay out. */
    public static final int MOST_STATES = 2_000;

    private static final double WIDEST = 190;
    private static final double INSET = 7;

    private final StateGraph states;
    private final ElkNode graph = ElkGraphUtil.createGraph();
    private final List<ElkNode> nodes = new ArrayList<>();
    private final List<TextBlock> nodeTexts = new ArrayList<>();
    private final List<ElkEdge> edges = new ArrayList<>();
    private final List<TextBlock> edgeTexts = new ArrayList<>();

    private StateGraphLayout(StateGraph states) {
        this.states = states;
    }

    /**
     * The drawing of a graph.
     *
     * @param isCancelled is asked again and again while it is made
     * @throws CancellationException if it was cancelled
     */
    public static StateGraphDrawing of(StateGraph states, TextMeasure measure, BooleanSupplier isCancelled) {
        return new StateGraphLayout(states).draw(measure, isCancelled);
    }

    private StateGraphDrawing draw(TextMeasure measure, BooleanSupplier isCancelled) {
        states.states().forEach(state -> add(state, measure));
        states.arrows().forEach(arrow -> add(arrow, measure));
        nodes.stream()
                .findFirst()
                .ifPresent(first -> first.setProperty(LayeredOptions.LAYERING_LAYER_CONSTRAINT, LayerConstraint.FIRST));
        graph.setProperty(LayeredOptions.DIRECTION, Direction.DOWN);
        graph.setProperty(LayeredOptions.EDGE_ROUTING, EdgeRouting.ORTHOGONAL);
        graph.setProperty(LayeredOptions.CYCLE_BREAKING_STRATEGY, CycleBreakingStrategy.DEPTH_FIRST);
        graph.setProperty(LayeredOptions.PADDING, new ElkPadding(0));
        graph.setProperty(LayeredOptions.SPACING_NODE_NODE, 22.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_NODE, 14.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_EDGE, 12.0);
        graph.setProperty(LayeredOptions.SPACING_LABEL_LABEL, 8.0);
        graph.setProperty(LayeredOptions.SPACING_NODE_NODE_BETWEEN_LAYERS, 24.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_NODE_BETWEEN_LAYERS, 14.0);
        graph.setProperty(LayeredOptions.SPACING_EDGE_EDGE_BETWEEN_LAYERS, 10.0);
        LayoutMetaDataService.getInstance().registerLayoutMetaDataProviders(new LayeredMetaDataProvider());
        new LayeredLayoutProvider().layout(graph, new BasicProgressMonitor() {
            @Override
            public boolean isCanceled() {
                return isCancelled.getAsBoolean();
            }
        });
        if (isCancelled.getAsBoolean()) {
            throw new CancellationException("the layout was cancelled");
        }
        return drawing();
    }

    private void add(StateGraph.State state, TextMeasure measure) {
        TextBlock text = TextBlock.of(
                state.name(),
                TextStyle.NAME,
                List.of(String.join(" ", state.marked())),
                TextStyle.EVENT,
                WIDEST,
                measure);
        ElkNode node = ElkGraphUtil.createNode(graph);
        node.setDimensions(text.width() + 2 * INSET, text.height() + 2 * INSET);
        nodes.add(node);
        nodeTexts.add(text);
    }

    private void add(StateGraph.Arrow arrow, TextMeasure measure) {
        ElkEdge edge = ElkGraphUtil.createSimpleEdge(nodes.get(arrow.from()), nodes.get(arrow.to()));
        TextBlock text = TextBlock.of(arrow.lines(), TextStyle.EDGE, measure);
        if (!text.isEmpty()) {
            ElkLabel label = ElkGraphUtil.createLabel(arrow.from() + "-" + arrow.to(), edge);
            label.setDimensions(text.width(), text.height());
            label.setProperty(LayeredOptions.EDGE_LABELS_PLACEMENT, EdgeLabelPlacement.CENTER);
            label.setProperty(LayeredOptions.EDGE_LABELS_INLINE, arrow.from() != arrow.to());
        }
        edges.add(edge);
        edgeTexts.add(text);
    }

    private StateGraphDrawing drawing() {
        List<StateGraphDrawing.Box> boxes = new ArrayList<>();
        for (int i = 0; i < nodes.size(); i++) {
            ElkNode node = nodes.get(i);
            boxes.add(new StateGraphDrawing.Box(
                    new DrawingBox(node.getX(), node.getY(), node.getWidth(), node.getHeight()), nodeTexts.get(i)));
        }
        List<StateGraphDrawing.Line> lines = new ArrayList<>();
        for (int i = 0; i < edges.size(); i++) {
            lines.add(line(edges.get(i), edgeTexts.get(i)));
        }
        return new StateGraphDrawing(states, boxes, lines, bounds(boxes, lines));
    }

    private static StateGraphDrawing.Line line(ElkEdge edge, TextBlock text) {
        ElkEdgeSection section = edge.getSections().get(0);
        List<LayoutPoint> points = new ArrayList<>();
        points.add(new LayoutPoint(section.getStartX(), section.getStartY()));
        section.getBendPoints().forEach(bend -> points.add(new LayoutPoint(bend.getX(), bend.getY())));
        points.add(new LayoutPoint(section.getEndX(), section.getEndY()));
        DrawingBox label = edge.getLabels().stream()
                .findFirst()
                .map(at -> new DrawingBox(at.getX(), at.getY(), text.width(), text.height()))
                .orElse(new DrawingBox(section.getStartX(), section.getStartY(), 0, 0));
        return new StateGraphDrawing.Line(points, text, label);
    }

    private static DrawingBox bounds(List<StateGraphDrawing.Box> boxes, List<StateGraphDrawing.Line> lines) {
        List<DrawingBox> all = new ArrayList<>();
        boxes.forEach(box -> all.add(box.area()));
        lines.forEach(line -> {
            all.add(line.label());
            line.points().forEach(point -> all.add(new DrawingBox(point.x(), point.y(), 0, 0)));
        });
        return all.stream().reduce(DrawingBox::union).orElse(new DrawingBox(0, 0, 0, 0));
    }
}
