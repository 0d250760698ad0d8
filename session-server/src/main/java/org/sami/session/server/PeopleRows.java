package org.sami.session.server;

import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Collection;
import java.util.Map;
import java.util.TreeMap;
import org.sami.session.rows.Table;

/** Rows of the people who are connected. */
final class PeopleRows {
    private PeopleRows() {}

    static Table of(Collection<Front> fronts) {
        Map<String, ObjectNode> rows = new TreeMap<>();
        for (Front front : fronts) {
            front.person().ifPresent(person -> {
                ObjectNode row = rows.computeIfAbsent(
                        person.name(),
                        name -> JsonNodeFactory.instance.objectNode().put("id", name));
                row.put("role", person.role().word());
                row.put("fronts", row.path("fronts").asInt() + 1);
            });
        }
        return new Table("people", rows);
    }
}
