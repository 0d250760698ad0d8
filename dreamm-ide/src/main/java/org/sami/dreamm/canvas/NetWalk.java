package org.sami.dreamm.canvas;

import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Vertex;

/** Walks a net by arrow keys: along an edge where one leads that way, else to the next vertex that lies there. */
final class NetWalk {
    private static final double WIDEST = Math.toRadians(62);

    /** Where an arrow points. */
    enum Direction {
        LEFT(-1, 0),
        RIGHT(1, 0),
        UP(0, -1),
        DOWN(0, 1);

        private final int x;
        private final int y;

        Direction(int x, int y) {
            this.x = x;
            this.y = y;
        }

        /** To the right, 1, or to the left, -1. */
        int x() {
            return x;
        }

        /** Downwards, 1, or upwards, -1. */
        int y() {
            return y;
        }
    }

    private final NetDrawing drawing;
    private final List<Vertex> shown;

    /**
     * A walk on a drawing.
     *
     * @param shown the vertices on which one can stand
     */
    NetWalk(NetDrawing drawing, List<Vertex> shown) {
        this.drawing = drawing;
        this.shown = shown;
    }

    /** The vertex that comes next; empty where none lies that way. */
    Optional<Vertex> next(String from, Direction direction) {
        return next(from, direction, vertex -> true);
    }

    /** The next vertex that matches. */
    Optional<Vertex> next(String from, Direction direction, Predicate<Vertex> wanted) {
        Optional<Vertex> start = drawing.vertices().stream()
                .filter(vertex -> vertex.id().equals(from))
                .findFirst();
        if (start.isEmpty()) {
            return shown.stream().filter(wanted).findFirst();
        }
        Set<String> joined = new LinkedHashSet<>();
        drawing.edges().forEach(edge -> {
            if (edge.from().equals(from)) {
                joined.add(edge.to());
            } else if (edge.to().equals(from)) {
                joined.add(edge.from());
            }
        });
        Predicate<Vertex> other = vertex -> !vertex.id().equals(from) && wanted.test(vertex);
        return nearest(start.get(), direction, other.and(vertex -> joined.contains(vertex.id())))
                .or(() -> nearest(start.get(), direction, other));
    }

    private Optional<Vertex> nearest(Vertex from, Direction direction, Predicate<Vertex> wanted) {
        return shown.stream()
                .filter(wanted)
                .filter(vertex -> angle(from, vertex, direction) <= WIDEST)
                .min(Comparator.comparingDouble(
                        vertex -> distance(from, vertex) * (1 + angle(from, vertex, direction))));
    }

    private static double distance(Vertex a, Vertex b) {
        return Math.hypot(
                b.centre().x() - a.centre().x(), b.centre().y() - a.centre().y());
    }

    private static double angle(Vertex from, Vertex to, Direction direction) {
        double dx = to.centre().x() - from.centre().x();
        double dy = to.centre().y() - from.centre().y();
        double length = Math.max(1e-9, Math.hypot(dx, dy));
        return Math.acos(Math.max(-1, Math.min(1, (dx * direction.x() + dy * direction.y()) / length)));
    }
}
