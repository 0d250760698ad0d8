package org.sami.domain;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;

/** Small projects of the earlier system as exports, made for tests: one or more plans of places, transitions and edges. */
final class LegacyDocument {
    private static final ObjectMapper MAPPER = new ObjectMapper();
    final ObjectNode root = MAPPER.createObjectNode();

    LegacyDocument() {
        root.put("format", "sami-legacy-project").put("version", 1);
        root.putObject("source").put("file", "made.drm");
        root.putArray("globalVariables");
        root.putObject("missionTree").put("label", "Plays").putArray("children");
        root.putArray("plans");
        root.putArray("notes");
    }

    static ObjectNode json(String text) {
        try {
            return (ObjectNode) MAPPER.readTree(text.replace('\'', '"'));
        } catch (java.io.IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    /** A global variable; its value in JSON with single quotes. */
    LegacyDocument global(String name, String className, String value) {
        ((ArrayNode) root.get("globalVariables"))
                .addObject()
                .put("name", name)
                .put("class", className)
                .set("value", json(value));
        return this;
    }

    PlanPart plan(String id, String name) {
        ObjectNode plan = ((ArrayNode) root.get("plans")).addObject();
        plan.put("id", id).put("name", name).put("role", "root");
        plan.putArray("vertices");
        plan.putArray("edges");
        ((ArrayNode) root.at("/missionTree/children")).addObject().put("plan", id);
        return new PlanPart(plan);
    }

    String text() {
        return root.toString();
    }

    /** A plan being made. */
    static final class PlanPart {
        final ObjectNode node;

        PlanPart(ObjectNode node) {
            this.node = node;
        }

        PlanPart instance(String parent) {
            node.put("role", "sub-mission-instance").put("parentPlan", parent);
            return this;
        }

        PlanPart place(String key, String... events) {
            return vertex(key, "place", events);
        }

        PlanPart transition(String key, String... events) {
            return vertex(key, "transition", events);
        }

        private PlanPart vertex(String key, String type, String... events) {
            ObjectNode v = ((ArrayNode) node.get("vertices")).addObject();
            v.put("key", key).put("type", type).put("name", "").put("mode", "Nominal");
            v.put("x", 10.0).put("y", 20.0);
            v.put("isStart", key.equals("start")).put("isEnd", key.equals("end"));
            ArrayNode list = v.putArray("events");
            for (int i = 0; i < events.length; i++) {
                list.add(json(events[i]).put("key", key + ".e" + i));
            }
            return this;
        }

        /** The last vertex that was made. */
        ObjectNode last() {
            ArrayNode vertices = (ArrayNode) node.get("vertices");
            return (ObjectNode) vertices.get(vertices.size() - 1);
        }

        PlanPart runs(String plan, boolean shared) {
            ArrayNode list =
                    last().has("subMissions") ? (ArrayNode) last().get("subMissions") : last().putArray("subMissions");
            list.addObject().put("plan", plan).put("instanceMode", shared ? "static" : "dynamic");
            return this;
        }

        PlanPart in(String from, String to, String... requirements) {
            return edge("in", from, to, requirements);
        }

        PlanPart out(String from, String to, String... requirements) {
            return edge("out", from, to, requirements);
        }

        private PlanPart edge(String type, String from, String to, String... requirements) {
            ArrayNode edges = (ArrayNode) node.get("edges");
            ObjectNode edge = edges.addObject();
            edge.put("key", "edge" + edges.size())
                    .put("type", type)
                    .put("from", from)
                    .put("to", to);
            edge.put("mode", "Nominal");
            ArrayNode list = edge.putArray("requirements");
            for (String requirement : requirements) {
                list.add(requirement(requirement));
            }
            return this;
        }

        /** Kind, match and quantity, and with it the action, parted by spaces; a dash is null. */
        private static JsonNode requirement(String words) {
            String[] w = words.split(" ");
            ObjectNode r = MAPPER.createObjectNode().put("kind", w[0]);
            r.put("match", w[1].equals("-") ? null : w[1]).put("quantity", Integer.parseInt(w[2]));
            return w.length > 3 ? r.put("action", w[3]) : r;
        }
    }
}
