package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import org.sami.spn.json.JsonObjectReader;

/** A value of the export, not yet understood: an object with a {@code type}, and where it stands. */
record LegacyValue(String pointer, JsonNode node) {
    /** The kind of value, such as {@code location}; empty text where the export says none. */
    String type() {
        return node.path("type").asText("");
    }

    /** The Java class that the earlier system used; empty text where the export says none. */
    String className() {
        return node.path("class").asText("");
    }

    LegacyValue member(String name) {
        return new LegacyValue(JsonObjectReader.at(pointer, name), node.path(name));
    }

    boolean isNull() {
        return node.isNull() || node.isMissingNode();
    }
}
