package org.sami.spn.json;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import java.util.List;
import org.sami.spn.model.MarkupSpec;

/** Writes the markups of activations and decisions for reports and tools. */
final class MarkupWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private MarkupWriter() {}

    static ArrayNode write(List<MarkupSpec> markups) {
        ArrayNode array = NODES.arrayNode();
        markups.forEach(m -> array.addObject().put("type", m.type()).set("options", InputWriter.values(m.options())));
        return array;
    }
}
