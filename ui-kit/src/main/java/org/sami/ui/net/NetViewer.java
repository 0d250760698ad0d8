package org.sami.ui.net;

import edu.uci.ics.jung.algorithms.layout.Layout;
import edu.uci.ics.jung.algorithms.layout.StaticLayout;
import edu.uci.ics.jung.graph.DirectedSparseMultigraph;
import edu.uci.ics.jung.visualization.RenderContext;
import edu.uci.ics.jung.visualization.VisualizationViewer;
import edu.uci.ics.jung.visualization.renderers.BasicRenderer;
import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.event.MouseEvent;
import java.util.function.BiConsumer;
import java.util.function.Function;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.FocusFrame;

/** JUNG's viewer with the painter of nets: JUNG has graph, layout and view transformation, the painter all that is seen. */
final class NetViewer extends VisualizationViewer<String, String> {
    private final transient Function<MouseEvent, String> tips;

    /**
     * Makes a viewer of an empty net.
     *
     * @param painting paints with a graphics in drawing units, and so many pixels for one
     * @param tips the tooltip of the element under the pointer; null for none
     */
    NetViewer(BiConsumer<Graphics2D, Double> painting, Function<MouseEvent, String> tips) {
        super(new StaticLayout<>(new DirectedSparseMultigraph<>(), new Dimension(1, 1)), new Dimension(600, 400));
        this.tips = tips;
        setName("net-canvas");
        setFocusable(true);
        FocusFrame.watch(this);
        setDoubleBuffered(false);
        setRenderer(new BasicRenderer<>() {
            @Override
            public void render(RenderContext<String, String> context, Layout<String, String> layout) {
                Graphics2D g = (Graphics2D) context.getGraphicsContext().create();
                painting.accept(g, g.getTransform().getScaleX());
                g.dispose();
            }
        });
        setToolTipText("");
    }

    @Override
    protected void paintComponent(Graphics g) {
        super.paintComponent(g);
        FocusFrame.paint(g, this);
    }

    /** Asked at each painting, so that another theme is seen at once. */
    @Override
    public Color getBackground() {
        return SemanticColor.NET_CANVAS.get();
    }

    @Override
    public String getToolTipText(MouseEvent event) {
        return tips.apply(event);
    }
}
