package org.sami.session.rows;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The rows of one table at a moment, by id. Immutable once built: rows are not changed afterwards.
 *
 * @param name of the table in messages
 */
public record Table(String name, Map<String, ObjectNode> rows) {
    public Table {
        rows = Collections.unmodifiableMap(new LinkedHashMap<>(rows));
    }

    /** Puts a table together; rows past a limit are left out. */
    static final class Builder {
        private static final int MOST_CHARACTERS = 2000;

        private final String name;
        private final int limit;
        private final Map<String, ObjectNode> rows = new LinkedHashMap<>();

        Builder(String name, int limit) {
            this.name = name;
            this.limit = limit;
        }

        /** A row with its id; one past the limit goes nowhere. */
        ObjectNode row(String id) {
            ObjectNode row = JsonNodeFactory.instance.objectNode();
            row.put("id", id);
            if (rows.size() < limit) {
                rows.put(id, row);
            }
            return row;
        }

        int size() {
            return rows.size();
        }

        Table build() {
            return new Table(name, rows);
        }

        /** A text as it may be sent. */
        static String cut(String text) {
            return text.length() <= MOST_CHARACTERS ? text : text.substring(0, MOST_CHARACTERS - 1) + "…";
        }

        /** Puts a text unless it is empty. */
        static void put(ObjectNode row, String member, String text) {
            if (!text.isEmpty()) {
                row.put(member, cut(text));
            }
        }

        static void ids(ObjectNode row, String member, Collection<String> ids) {
            ids.forEach(row.putArray(member)::add);
        }
    }
}
