package org.sami.dreamm.learn;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import org.sami.picture.NetFonts;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Draws a plan as its author has laid it out, with its vertices nearer to each other from left to right where it would be wider than the page. Letters stay as large
 * as they are.
 */
public final class PictureLayout {
    private static final double SAME_ROW = 70;
    private static final double LEAST_BLANK = 120; // drawing units, as the next
    private static final double LEAST_WITH_WORDS = 170;
    private static final int TRIES = 6;

    private PictureLayout() {}

    /**
     * The drawing of a plan.
     *
     * @param width that it should not be wider than, in drawing units
     */
    public static NetDrawing of(Plan plan, Vocabulary vocabulary, double width) {
        NetDrawing own = NetLayout.given(plan, vocabulary, NetFonts::width);
        double least = least(plan, own.scale());
        if (own.bounds().width() <= width || least >= 1) {
            return own;
        }
        NetDrawing best = own;
        double factor = 1;
        for (int i = 0; i < TRIES && best.bounds().width() > width && factor > least; i++) {
            factor = Math.max(
                    least,
                    factor * (width - 1) / best.bounds().width()); // a little less: it comes near it only by steps
            best = NetLayout.edited(
                    nearer(plan, factor),
                    vocabulary,
                    NetFonts::width,
                    NetDetail.READER,
                    OptionalDouble.of(own.scale())); // the scale of the whole, else it would move all apart again
        }
        return best;
    }

    private static Plan nearer(Plan plan, double factor) {
        Map<String, LayoutPoint> layout = new LinkedHashMap<>();
        plan.layout().forEach((id, at) -> layout.put(id, new LayoutPoint(at.x() * factor, at.y())));
        return plan.withLayout(layout);
    }

    /** How much nearer vertices of one row can come to each other without their words meeting. */
    private static double least(Plan plan, double scale) {
        boolean words =
                plan.inEdges().stream().anyMatch(edge -> !edge.requirements().isEmpty())
                        || plan.outEdges().stream()
                                .anyMatch(edge -> !edge.requirements().isEmpty());
        double needed = words ? LEAST_WITH_WORDS : LEAST_BLANK;
        List<LayoutPoint> points = List.copyOf(plan.layout().values());
        double nearest = Double.MAX_VALUE;
        for (LayoutPoint a : points) {
            for (LayoutPoint b : points) {
                double apart = Math.abs(a.x() - b.x());
                if (apart > 1 && Math.abs(a.y() - b.y()) < SAME_ROW) {
                    nearest = Math.min(nearest, apart);
                }
            }
        }
        return Math.min(1, needed / (nearest * scale));
    }
}
