package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Optional;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Note;

/** Reads a note: a text alone, or an object that says where on the drawing it lies. */
final class NoteReader {
    private final JsonObjectReader.Format format;

    NoteReader(JsonObjectReader.Format format) {
        this.format = format;
    }

    Optional<Note> read(JsonObjectReader.Element element) {
        if (element.node().isTextual()) {
            return Optional.of(Note.of(element.node().textValue()));
        }
        return JsonObjectReader.of(element.node(), element.pointer(), format).map(n -> {
            String text = n.text("text", "");
            Optional<LayoutPoint> at = n.node("at").flatMap(xy -> point(xy, n));
            n.done();
            return new Note(text, at);
        });
    }

    private static Optional<LayoutPoint> point(JsonNode xy, JsonObjectReader note) {
        if (!xy.isArray()
                || xy.size() != 2
                || !xy.get(0).isNumber()
                || !xy.get(1).isNumber()) {
            note.problem(Codes.WRONG_TYPE, "at", "A note lies at [x, y]");
            return Optional.empty();
        }
        return Optional.of(new LayoutPoint(xy.get(0).doubleValue(), xy.get(1).doubleValue()));
    }
}
