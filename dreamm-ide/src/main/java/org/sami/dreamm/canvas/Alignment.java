package org.sami.dreamm.canvas;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.BiFunction;
import java.util.function.DoubleUnaryOperator;
import java.util.function.ToDoubleFunction;
import org.sami.spn.model.LayoutPoint;

/** Ways to put several vertices in order. Vertices are aligned by their centres: places and transitions differ in size. */
enum Alignment {
    LEFT("Align left", 2),
    COLUMN("Align in a column", 2),
    RIGHT("Align right", 2),
    TOP("Align at the top", 2),
    ROW("Align in a row", 2),
    BOTTOM("Align at the bottom", 2),
    SPREAD_X("Distribute from left to right", 3),
    SPREAD_Y("Distribute from top to bottom", 3);

    private final String label;
    private final int least;

    Alignment(String label, int least) {
        this.label = label;
        this.least = least;
    }

    String label() {
        return label;
    }

    /** How many vertices it takes. */
    int least() {
        return least;
    }

    /** The new centres of vertices, by their ids. */
    Map<String, LayoutPoint> of(Map<String, LayoutPoint> centres) {
        return switch (this) {
            case LEFT -> x(centres, all -> min(all, LayoutPoint::x));
            case RIGHT -> x(centres, all -> max(all, LayoutPoint::x));
            case COLUMN -> x(centres, all -> (min(all, LayoutPoint::x) + max(all, LayoutPoint::x)) / 2);
            case TOP -> y(centres, all -> min(all, LayoutPoint::y));
            case BOTTOM -> y(centres, all -> max(all, LayoutPoint::y));
            case ROW -> y(centres, all -> (min(all, LayoutPoint::y) + max(all, LayoutPoint::y)) / 2);
            case SPREAD_X -> spread(centres, LayoutPoint::x, (at, x) -> new LayoutPoint(x, at.y()));
            case SPREAD_Y -> spread(centres, LayoutPoint::y, (at, y) -> new LayoutPoint(at.x(), y));
        };
    }

    private static double min(Map<String, LayoutPoint> all, ToDoubleFunction<LayoutPoint> axis) {
        return all.values().stream().mapToDouble(axis).min().orElse(0);
    }

    private static double max(Map<String, LayoutPoint> all, ToDoubleFunction<LayoutPoint> axis) {
        return all.values().stream().mapToDouble(axis).max().orElse(0);
    }

    private static Map<String, LayoutPoint> x(
            Map<String, LayoutPoint> centres, ToDoubleFunction<Map<String, LayoutPoint>> line) {
        double x = line.applyAsDouble(centres);
        Map<String, LayoutPoint> aligned = new LinkedHashMap<>();
        centres.forEach((id, at) -> aligned.put(id, new LayoutPoint(x, at.y())));
        return aligned;
    }

    private static Map<String, LayoutPoint> y(
            Map<String, LayoutPoint> centres, ToDoubleFunction<Map<String, LayoutPoint>> line) {
        double y = line.applyAsDouble(centres);
        Map<String, LayoutPoint> aligned = new LinkedHashMap<>();
        centres.forEach((id, at) -> aligned.put(id, new LayoutPoint(at.x(), y)));
        return aligned;
    }

    /** The first and the last stay; the others lie between them at equal distances, in the order that they have. */
    private static Map<String, LayoutPoint> spread(
            Map<String, LayoutPoint> centres,
            ToDoubleFunction<LayoutPoint> axis,
            BiFunction<LayoutPoint, Double, LayoutPoint> at) {
        List<String> order = new ArrayList<>(centres.keySet());
        order.sort(Comparator.<String>comparingDouble(id -> axis.applyAsDouble(centres.get(id)))
                .thenComparing(Comparator.naturalOrder()));
        double from = min(centres, axis);
        double step = (max(centres, axis) - from) / Math.max(1, order.size() - 1);
        DoubleUnaryOperator position = i -> from + i * step;
        Map<String, LayoutPoint> spread = new LinkedHashMap<>();
        for (int i = 0; i < order.size(); i++) {
            spread.put(order.get(i), at.apply(centres.get(order.get(i)), position.applyAsDouble(i)));
        }
        return spread;
    }
}
