package org.sami.spn.drawing;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/** The layout of a plan with a point for each vertex that has none: next to the vertices that it is connected to, in free space. */
final class CompletedLayout {
    private final Plan plan;
    private final double apart;
    private final Map<String, LayoutPoint> layout;

    private CompletedLayout(Plan plan, double apart) {
        this.plan = plan;
        this.apart = apart;
        this.layout = new LinkedHashMap<>(plan.layout());
    }

    /**
     * Completes the layout of a plan that has some points.
     *
     * @param apart how far from another a vertex is laid, in units of the layout
     */
    static Map<String, LayoutPoint> of(Plan plan, double apart) {
        CompletedLayout completed = new CompletedLayout(plan, apart);
        plan.places().stream().map(Place::id).forEach(completed::complete);
        plan.transitions().stream().map(Transition::id).forEach(completed::complete);
        return completed.layout;
    }

    private void complete(String vertex) {
        if (layout.containsKey(vertex)) {
            return;
        }
        List<LayoutPoint> sources = neighbours(vertex, true);
        List<LayoutPoint> targets = neighbours(vertex, false);
        LayoutPoint at = !sources.isEmpty()
                ? new LayoutPoint(mean(sources).x() + apart, mean(sources).y())
                : !targets.isEmpty()
                        ? new LayoutPoint(
                                mean(targets).x() - apart, mean(targets).y())
                        : new LayoutPoint(0, 0);
        while (isTaken(at)) {
            at = new LayoutPoint(at.x(), at.y() + apart / 2);
        }
        layout.put(vertex, at);
    }

    private boolean isTaken(LayoutPoint at) {
        return layout.values().stream()
                .anyMatch(other -> Math.hypot(other.x() - at.x(), other.y() - at.y()) < apart / 2.5);
    }

    private List<LayoutPoint> neighbours(String vertex, boolean before) {
        Stream<String> places = plan.inEdges().stream()
                .filter(edge ->
                        before ? edge.transition().equals(vertex) : edge.place().equals(vertex))
                .map(edge -> before ? edge.place() : edge.transition());
        Stream<String> transitions = plan.outEdges().stream()
                .filter(edge ->
                        before ? edge.place().equals(vertex) : edge.transition().equals(vertex))
                .map(edge -> before ? edge.transition() : edge.place());
        return Stream.concat(places, transitions)
                .filter(layout::containsKey)
                .map(layout::get)
                .toList();
    }

    private static LayoutPoint mean(List<LayoutPoint> points) {
        return new LayoutPoint(
                points.stream().mapToDouble(LayoutPoint::x).average().orElseThrow(),
                points.stream().mapToDouble(LayoutPoint::y).average().orElseThrow());
    }
}
