package org.sami.spn.drawing;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.BooleanSupplier;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes the drawing of a net: as its author has laid it out, or in layers. */
public final class NetLayout {
    private static final double DEFAULT_SPACING = 130; // of vertices without a position, in drawing units

    private NetLayout() {}

    /** Draws a plan where its author has laid the vertices; in layers, where the plan does not say so of each. */
    public static NetDrawing given(Plan plan, Vocabulary vocabulary, TextMeasure measure) {
        NetTexts texts = new NetTexts(plan, vocabulary, measure);
        return GivenLayout.isComplete(plan)
                ? new GivenLayout(plan, texts).draw()
                : new LayeredLayout(plan, texts).draw();
    }

    /**
     * Draws a plan while it is edited: with the author's positions. A vertex without a point lies next to what
     * it is connected to; a plan without any is drawn in layers. Two vertices may lie on each other.
     *
     * @param scale how many drawing units one unit of the plan's layout is: that of the drawing before, so that nothing moves that nobody
     *     has moved; empty at first
     */
    public static NetDrawing edited(
            Plan plan, Vocabulary vocabulary, TextMeasure measure, NetDetail detail, OptionalDouble scale) {
        NetTexts texts = new NetTexts(plan, vocabulary, measure, detail);
        if (plan.layout().isEmpty()) {
            NetDrawing layered = new LayeredLayout(plan, texts).draw();
            Map<String, LayoutPoint> layout = new LinkedHashMap<>();
            double factor = scale.orElse(1);
            layered.vertices()
                    .forEach(vertex -> layout.put(
                            vertex.id(),
                            new LayoutPoint(
                                    vertex.centre().x() / factor,
                                    vertex.centre().y() / factor)));
            return new GivenLayout(plan, texts, layout, factor).draw();
        }
        double factor = scale.orElseGet(
                () -> GivenLayout.comfortableFactor(plan.layout().values()));
        return new GivenLayout(plan, texts, CompletedLayout.of(plan, DEFAULT_SPACING / factor), factor).draw();
    }

    /** Draws a plan in layers from left to right, whatever its author has laid out. */
    public static NetDrawing layered(Plan plan, Vocabulary vocabulary, TextMeasure measure) {
        return new LayeredLayout(plan, new NetTexts(plan, vocabulary, measure)).draw();
    }

    /**
     * Draws a plan in layers with other words at its edges than their requirements.
     *
     * @param edgeWords the lines at each edge, by its id; edges without have no words
     */
    public static NetDrawing layered(
            Plan plan, Vocabulary vocabulary, TextMeasure measure, Map<String, List<String>> edgeWords) {
        return new LayeredLayout(plan, new NetTexts(plan, vocabulary, measure, NetDetail.READER, edgeWords)).draw();
    }

    /**
     * Draws a plan in layers, and stops when it is cancelled.
     *
     * @param cancelled is asked again and again, on the caller's thread
     * @throws java.util.concurrent.CancellationException when it was cancelled
     */
    public static NetDrawing layered(
            Plan plan, Vocabulary vocabulary, TextMeasure measure, NetDetail detail, BooleanSupplier cancelled) {
        return new LayeredLayout(plan, new NetTexts(plan, vocabulary, measure, detail), cancelled).draw();
    }
}
