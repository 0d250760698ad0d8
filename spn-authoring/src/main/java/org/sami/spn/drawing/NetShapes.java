package org.sami.spn.drawing;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.drawing.NetDrawing.Kind;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** What the drawing knows of the plan's elements. */
final class NetShapes {
    private static final double TWIN_ASIDE = 7; // so that two edges between two vertices are distinguished

    private NetShapes() {}

    static Vertex vertex(Place place, LayoutPoint centre) {
        return new Vertex(
                place.id(),
                Kind.PLACE,
                centre,
                place.start(),
                place.end(),
                !place.subMissions().isEmpty(),
                place.mode() == Mode.RECOVERY,
                place.disabled());
    }

    static Vertex vertex(Transition transition, LayoutPoint centre) {
        boolean recovery = transition.mode() == Mode.RECOVERY;
        return new Vertex(
                transition.id(), Kind.TRANSITION, centre, false, false, false, recovery, transition.disabled());
    }

    static boolean isUnconditional(InEdge edge) {
        return edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL);
    }

    static boolean isUnconditional(OutEdge edge) {
        return edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL);
    }

    /**
     * A straight line from the rim of one vertex to that of another.
     *
     * @param twin whether another edge leads back: both lie a little to their left then
     */
    static List<LayoutPoint> line(Vertex from, Vertex to, boolean twin) {
        double dx = to.centre().x() - from.centre().x();
        double dy = to.centre().y() - from.centre().y();
        double length = Math.max(1e-9, Math.hypot(dx, dy));
        double aside = twin ? TWIN_ASIDE : 0;
        double shiftX = dy / length * aside;
        double shiftY = -dx / length * aside;
        return List.of(rim(from, dx, dy, shiftX, shiftY), rim(to, -dx, -dy, shiftX, shiftY));
    }

    /**
     * A line from the rim of one vertex over some bends to the rim of another.
     *
     * @param bends none for a straight line
     */
    static List<LayoutPoint> line(Vertex from, Vertex to, List<LayoutPoint> bends) {
        if (bends.isEmpty()) {
            return line(from, to, false);
        }
        List<LayoutPoint> points = new ArrayList<>(bends);
        points.add(0, towards(from, bends.get(0)));
        points.add(towards(to, bends.get(bends.size() - 1)));
        return points;
    }

    private static LayoutPoint towards(Vertex vertex, LayoutPoint there) {
        return rim(
                vertex,
                there.x() - vertex.centre().x(),
                there.y() - vertex.centre().y(),
                0,
                0);
    }

    /** Where a line in a direction leaves a vertex, shifted aside. */
    private static LayoutPoint rim(Vertex vertex, double dx, double dy, double shiftX, double shiftY) {
        double length = Math.max(1e-9, Math.hypot(dx, dy));
        double aside = Math.hypot(shiftX, shiftY);
        double part = vertex.kind() == Kind.PLACE
                ? Math.sqrt(NetDrawing.PLACE_RADIUS * NetDrawing.PLACE_RADIUS - aside * aside) / length
                : Math.min(
                        NetDrawing.BAR_WIDTH / 2 / Math.max(1e-9, Math.abs(dx)),
                        NetDrawing.BAR_HEIGHT / 2 / Math.max(1e-9, Math.abs(dy)));
        double bounded = Math.min(1, part);
        return new LayoutPoint(
                vertex.centre().x() + dx * bounded + shiftX, vertex.centre().y() + dy * bounded + shiftY);
    }
}
