package org.sami.ui.net;

import java.awt.geom.Point2D;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.sami.picture.net.NetMarking;
import org.sami.picture.net.NetScene;
import org.sami.spn.drawing.NetDrawing;
import org.sami.spn.drawing.NetDrawing.Vertex;
import org.sami.spn.protocol.Token;

/** The tooltip of the vertex or edge under the pointer: its part in the plan, its tokens, and why it does not fire. On the event thread. */
final class NetTooltip {
    private static final double REACH = 4; // of an edge, in drawing units

    private Function<String, Optional<String>> explanation = id -> Optional.empty();
    private Function<Token, String> tokenName = NetTips::name;

    /** Asks somebody for one more line, by the id of a vertex or edge. */
    void setExplanation(Function<String, Optional<String>> explanation) {
        this.explanation = explanation;
    }

    /** Asks somebody for what people call a token. */
    void setTokenName(Function<Token, String> tokenName) {
        this.tokenName = tokenName;
    }

    /** The tooltip at a point of the drawing; empty where nothing lies there. */
    Optional<String> at(Point2D point, NetScene scene, NetContent content, NetMarking marking) {
        String id = scene.vertexAt(point.getX(), point.getY(), 0)
                .map(Vertex::id)
                .or(() -> scene.edgeAt(point.getX(), point.getY(), REACH).map(NetDrawing.Edge::id))
                .orElse("");
        List<String> lines = new ArrayList<>(NetTips.of(content.plan(), content.vocabulary(), marking, id, tokenName));
        if (lines.isEmpty()) {
            return Optional.empty();
        }
        explanation.apply(id).ifPresent(lines::add);
        return Optional.of(String.join("\n", lines));
    }
}
