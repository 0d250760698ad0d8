package org.sami.spn.drawing;

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
    private NetShapes() {}

    static Vertex vertex(Place place, LayoutPoint centre) {
        return new Vertex(
                place.id(),
                Kind.PLACE,
                centre,
                place.start(),
                place.end(),
                !place.subMissions().isEmpty(),
                place.mode() == Mode.RECOVERY);
    }

    static Vertex vertex(Transition transition, LayoutPoint centre) {
        boolean recovery = transition.mode() == Mode.RECOVERY;
        return new Vertex(transition.id(), Kind.TRANSITION, centre, false, false, false, recovery);
    }

    static boolean isUnconditional(InEdge edge) {
        return edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL);
    }

    static boolean isUnconditional(OutEdge edge) {
        return edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL);
    }
}
