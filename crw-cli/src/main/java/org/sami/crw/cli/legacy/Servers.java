package org.sami.crw.cli.legacy;

import java.util.LinkedHashMap;
import java.util.Map;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Project;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** The boats' servers that a project names, with what it calls their boats. */
final class Servers {
    private static final String SERVER = "server";
    private static final String NAME = "name";

    private final Map<String, String> boatOfServer = new LinkedHashMap<>();

    private Servers() {}

    /** Name of the boat by server, in the project's order. */
    static Map<String, String> of(Project project) {
        Servers servers = new Servers();
        project.globals().forEach(variable -> variable.initial().ifPresent(servers::add));
        project.plans().forEach(plan -> {
            plan.variables().forEach(variable -> variable.initial().ifPresent(servers::add));
            plan.places().forEach(place -> place.outputs().forEach(servers::add));
        });
        return servers.boatOfServer;
    }

    private void add(OutputEventSpec output) {
        Map<String, Value> fixed = new LinkedHashMap<>();
        output.fields().forEach((field, source) -> {
            if (source instanceof FieldSource.Fixed value) {
                fixed.put(field, value.value());
                add(value.value());
            }
        });
        put(fixed);
    }

    private void add(Value value) {
        if (value instanceof RecordValue record) {
            put(record.fields());
        } else if (value instanceof ListValue list) {
            list.items().forEach(this::add);
        }
    }

    private void put(Map<String, Value> fields) {
        if (fields.get(SERVER) instanceof TextValue server && !server.value().isBlank()) {
            String name = fields.get(NAME) instanceof TextValue text ? text.value() : "";
            boatOfServer.putIfAbsent(server.value(), name);
        }
    }
}
