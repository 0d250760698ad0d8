package org.sami.domain;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;

/** Damages documents: removes, replaces or doubles something anywhere. */
final class Damage {
    private static final String[] SCRAPS = {
        "null",
        "true",
        "-1",
        "0",
        "1e400",
        "\"\"",
        "\"x\"",
        "\"@x\"",
        "\"all\"",
        "\"p1\"",
        "\"t1\"",
        "\"main\"",
        "[]",
        "{}",
        "[1,2]",
        "{\"lat\":1,\"lon\":2}",
        "{\"variable\":\"@task\"}",
        "\"list<list<point>>\"",
        "\"PT1S\"",
        "\"task\"",
        "9999999999"
    };

    private Damage() {}

    static void damage(JsonNode root, Random random) throws IOException {
        List<JsonNode> containers = new ArrayList<>();
        collect(root, containers);
        if (containers.isEmpty()) {
            return;
        }
        JsonNode node = containers.get(random.nextInt(containers.size()));
        JsonNode scrap = Schemas.MAPPER.readTree(SCRAPS[random.nextInt(SCRAPS.length)]);
        if (node instanceof ArrayNode array) {
            int index = random.nextInt(array.size());
            switch (random.nextInt(3)) {
                case 0 -> array.remove(index);
                case 1 -> array.set(index, scrap);
                default -> array.add(array.get(index).deepCopy());
            }
        } else {
            List<String> names = new ArrayList<>();
            node.fieldNames().forEachRemaining(names::add);
            String name = names.get(random.nextInt(names.size()));
            if (random.nextInt(3) == 0) {
                ((ObjectNode) node).remove(name);
            } else {
                ((ObjectNode) node).set(name, scrap);
            }
        }
    }

    private static void collect(JsonNode node, List<JsonNode> containers) {
        if (node.isContainerNode() && !node.isEmpty()) {
            containers.add(node);
        }
        node.forEach(child -> collect(child, containers));
    }
}
