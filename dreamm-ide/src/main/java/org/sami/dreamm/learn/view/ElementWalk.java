package org.sami.dreamm.learn.view;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.NetDrawing.Edge;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.LayoutPoint;

/** The elements of a drawn net that can be marked, with their middles, and which of them lies where an arrow points. */
final class ElementWalk {
    private static final double ASIDE = 2; // what lies aside counts so much farther

    private final List<Stop> stops = new ArrayList<>();

    /** An element and its middle. */
    record Stop(String id, LayoutPoint at) {}

    /**
     * A walk on what is shown.
     *
     * @param ids of the elements on which one can stand
     */
    ElementWalk(NetScene scene, Set<String> ids) {
        for (Vertex vertex : scene.vertices()) {
            if (ids.contains(vertex.id())) {
                stops.add(new Stop(vertex.id(), vertex.centre()));
            }
        }
        for (Edge edge : scene.edges()) {
            if (ids.contains(edge.id())) {
                stops.add(new Stop(edge.id(), middle(edge.points())));
            }
        }
        stops.sort(Comparator.<Stop>comparingDouble(stop -> stop.at().x())
                .thenComparingDouble(stop -> stop.at().y()));
    }

    /** The point half way along a line. */
    private static LayoutPoint middle(List<LayoutPoint> points) {
        double half = 0;
        for (int i = 1; i < points.size(); i++) {
            half += distance(points.get(i - 1), points.get(i)) / 2;
        }
        for (int i = 1; i < points.size(); i++) {
            double part = distance(points.get(i - 1), points.get(i));
            if (half <= part && part > 0) {
                LayoutPoint a = points.get(i - 1);
                LayoutPoint b = points.get(i);
                return new LayoutPoint(a.x() + (b.x() - a.x()) * half / part, a.y() + (b.y() - a.y()) * half / part);
            }
            half -= part;
        }
        return points.get(0);
    }

    private static double distance(LayoutPoint a, LayoutPoint b) {
        return Math.hypot(b.x() - a.x(), b.y() - a.y());
    }

    /** The leftmost element; empty where there is none. */
    Optional<String> first() {
        return stops.stream().map(Stop::id).findFirst();
    }

    /** The middle of an element. */
    Optional<LayoutPoint> at(String id) {
        return stops.stream().filter(stop -> stop.id().equals(id)).map(Stop::at).findFirst();
    }

    /** The nearest element in a direction; the one where one stands where none lies that way. */
    String next(String from, int dx, int dy) {
        LayoutPoint here = at(from).orElse(new LayoutPoint(0, 0));
        return stops.stream()
                .filter(stop -> !stop.id().equals(from) && along(here, stop.at(), dx, dy) > 1)
                .min(Comparator.comparingDouble(
                        stop -> along(here, stop.at(), dx, dy) + ASIDE * Math.abs(along(here, stop.at(), dy, dx))))
                .map(Stop::id)
                .orElse(from);
    }

    private static double along(LayoutPoint from, LayoutPoint to, int dx, int dy) {
        return (to.x() - from.x()) * dx + (to.y() - from.y()) * dy;
    }

    /** How many there are. */
    int size() {
        return stops.size();
    }
}
