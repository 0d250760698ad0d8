package org.sami.session.client;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** The rows of a session as they are now (docs/session-link.md, Rows). For one thread. */
final class LinkTables {
    private final Map<String, Map<String, JsonNode>> tables = new LinkedHashMap<>();

    /** Takes a message {@code rows}; gives the names of the tables that changed. */
    Set<String> take(JsonNode message) {
        if (message.path("full").asBoolean()) {
            tables.values().forEach(Map::clear);
        }
        Set<String> changed = new HashSet<>();
        JsonNode set = message.path("set");
        set.fieldNames().forEachRemaining(name -> {
            changed.add(name);
            set.path(name).forEach(row -> table(name).put(row.path("id").asText(), row));
        });
        JsonNode gone = message.path("gone");
        gone.fieldNames().forEachRemaining(name -> {
            changed.add(name);
            gone.path(name).forEach(id -> table(name).remove(id.asText()));
        });
        if (message.path("full").asBoolean()) {
            changed.addAll(tables.keySet());
        }
        return changed;
    }

    private Map<String, JsonNode> table(String name) {
        return tables.computeIfAbsent(name, made -> new LinkedHashMap<>());
    }

    /** The rows of a table by their rank, where they have one. */
    List<JsonNode> rows(String name) {
        return table(name).values().stream()
                .sorted(Comparator.comparingInt(row -> row.path("rank").asInt()))
                .toList();
    }
}
