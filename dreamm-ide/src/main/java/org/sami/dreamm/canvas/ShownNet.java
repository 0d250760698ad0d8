package org.sami.dreamm.canvas;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.drawing.TextMeasure;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The plan whose net is shown and where all of it lies. A plan keeps the scale of its first drawing for as long as the project is open, so
 * that nothing moves that nobody has moved. Knows no window.
 */
final class ShownNet {
    private static final Plan NONE = new Plan(
            "", "", "", List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), List.of(), Map.of(),
            List.of(), List.of());

    private final Vocabulary vocabulary;
    private final TextMeasure measure;
    private final Map<String, Double> scales = new HashMap<>();
    private NetDetail detail = NetDetail.AUTHOR;
    private Plan plan = NONE;
    private NetDrawing drawing;

    ShownNet(Vocabulary vocabulary, TextMeasure measure) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.measure = Objects.requireNonNull(measure, "measure");
        this.drawing = draw();
    }

    private NetDrawing draw() {
        NetDrawing drawn = drawn(plan);
        if (!plan.places().isEmpty() || !plan.transitions().isEmpty()) {
            scales.put(plan.id(), drawn.scale());
        }
        return drawn;
    }

    /** A version of the plan as it would be drawn in this one's place. */
    NetDrawing drawn(Plan version) {
        Double scale = scales.get(version.id());
        return NetLayout.edited(
                version,
                vocabulary,
                measure,
                detail,
                scale == null ? OptionalDouble.empty() : OptionalDouble.of(scale));
    }

    /** What is shown where no plan is open. */
    static Plan none() {
        return NONE;
    }

    /** Shows a plan, or a newer version of it; none where no plan is open. */
    void show(Optional<Plan> next) {
        plan = next.orElse(NONE);
        drawing = draw();
    }

    /** Forgets scales: another project is open. */
    void forget() {
        scales.clear();
    }

    void setDetail(NetDetail detail) {
        this.detail = detail;
        drawing = draw();
    }

    NetDetail detail() {
        return detail;
    }

    Plan plan() {
        return plan;
    }

    /** Whether a plan is open. */
    boolean isOpen() {
        return !plan.id().isEmpty();
    }

    NetDrawing drawing() {
        return drawing;
    }

    /** The vertex of an id. */
    Optional<Vertex> vertex(String id) {
        return drawing.vertices().stream().filter(v -> v.id().equals(id)).findFirst();
    }

    /** A point of the drawing in units of the plan's layout, rounded to tenths, so that files stay readable. */
    LayoutPoint toPlan(double x, double y) {
        return new LayoutPoint(tenth(x / drawing.scale()), tenth(y / drawing.scale()));
    }

    private static double tenth(double value) {
        return Math.round(value * 10) / 10.0 + 0.0; // no negative zero
    }

    /** Where the vertices are shown that the plan does not say a point of. */
    Map<String, LayoutPoint> withoutPoint() {
        Map<String, LayoutPoint> missing = new LinkedHashMap<>();
        drawing.vertices().stream()
                .filter(vertex -> !plan.layout().containsKey(vertex.id()))
                .forEach(vertex -> missing.put(
                        vertex.id(), toPlan(vertex.centre().x(), vertex.centre().y())));
        return missing;
    }

    /** A free point near one, in drawing units: below it where another vertex lies there. */
    LayoutPoint free(double x, double y) {
        double at = y;
        while (isTaken(x, at)) {
            at += 90;
        }
        return new LayoutPoint(x, at);
    }

    private boolean isTaken(double x, double y) {
        return drawing.vertices().stream()
                .anyMatch(v ->
                        Math.abs(v.centre().x() - x) < 60 && Math.abs(v.centre().y() - y) < 60);
    }
}
