package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import org.sami.spn.model.FrameColor;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.NetFrame;

/** Reads a frame of a drawing: its title and colour, where it lies and how large it is. */
final class FrameReader {
    private FrameReader() {}

    /** The frame; empty where it lies nowhere or has no size, which the object's problems say. */
    static Optional<NetFrame> read(JsonObjectReader frame) {
        String title = frame.text("title", "");
        FrameColor color = frame.word("color", FrameColor.class, FrameColor.BLUE);
        Optional<LayoutPoint> at = pair(frame, "at", "A frame lies at [x, y]");
        Optional<LayoutPoint> size = pair(frame, "size", "A frame has a size [width, height]");
        frame.done();
        if (size.isPresent() && (size.get().x() <= 0 || size.get().y() <= 0)) {
            frame.problem(Codes.BAD_VALUE, "size", "A frame is wider and higher than 0");
            return Optional.empty();
        }
        return at.flatMap(corner -> size.map(extent -> new NetFrame(title, color, corner, extent.x(), extent.y())));
    }

    private static Optional<LayoutPoint> pair(JsonObjectReader frame, String member, String shape) {
        Optional<JsonNode> node = frame.node(member);
        boolean numbers = node.isPresent()
                && node.get().isArray()
                && node.get().size() == 2
                && node.get().get(0).isNumber()
                && node.get().get(1).isNumber();
        if (!numbers) {
            frame.problem(node.isPresent() ? Codes.WRONG_TYPE : Codes.MISSING, member, shape);
            return Optional.empty();
        }
        return Optional.of(new LayoutPoint(
                node.get().get(0).doubleValue(), node.get().get(1).doubleValue()));
    }
}
