package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The rows that one front has; makes messages of the rows that changed. For one thread. */
public final class SentRows {
    private final Map<String, Map<String, ObjectNode>> sent = new HashMap<>();
    private long number;

    /** Begins again: the next message is full. */
    public void restart() {
        sent.clear();
        number = 0;
    }

    /** A message with the rows that are other than those sent before; empty where none is. What it contains counts as sent. */
    public Optional<ObjectNode> changes(List<Table> tables, long nowMillis) {
        ObjectNode set = JsonNodeFactory.instance.objectNode();
        ObjectNode gone = JsonNodeFactory.instance.objectNode();
        for (Table table : tables) {
            Map<String, ObjectNode> before = sent.getOrDefault(table.name(), Map.of());
            table.rows().forEach((id, row) -> {
                if (!row.equals(before.get(id))) {
                    set.withArray("/" + table.name()).add(row);
                }
            });
            before.keySet().stream()
                    .filter(id -> !table.rows().containsKey(id))
                    .forEach(id -> gone.withArray("/" + table.name()).add(id));
            sent.put(table.name(), table.rows());
        }
        if (number > 0 && set.isEmpty() && gone.isEmpty()) {
            return Optional.empty();
        }
        number++;
        ObjectNode message = JsonNodeFactory.instance
                .objectNode()
                .put("t", "rows")
                .put("n", number)
                .put("full", number == 1)
                .put("now", nowMillis);
        message.set("set", set);
        message.set("gone", gone);
        return Optional.of(message);
    }
}
