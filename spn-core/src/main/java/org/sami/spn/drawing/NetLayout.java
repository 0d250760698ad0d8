package org.sami.spn.drawing;

import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/** Makes the drawing of a net: as its author has laid it out, or in layers. */
public final class NetLayout {
    private NetLayout() {}

    /** Draws a plan where its author has laid the vertices; in layers, where the plan does not say so of each. */
    public static NetDrawing given(Plan plan, Vocabulary vocabulary, TextMeasure measure) {
        NetTexts texts = new NetTexts(plan, vocabulary, measure);
        return GivenLayout.isComplete(plan)
                ? new GivenLayout(plan, texts).draw()
                : new LayeredLayout(plan, texts).draw();
    }

    /** Draws a plan in layers from left to right, whatever its author has laid out. */
    public static NetDrawing layered(Plan plan, Vocabulary vocabulary, TextMeasure measure) {
        return new LayeredLayout(plan, new NetTexts(plan, vocabulary, measure)).draw();
    }
}
