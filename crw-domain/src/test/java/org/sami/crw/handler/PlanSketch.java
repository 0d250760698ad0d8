package org.sami.crw.handler;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.json.ProjectReader;
import org.sami.spn.json.ValueJson;
import org.sami.spn.model.Project;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * Draws small plans for tests, as a project file that the real reader reads. The first place is the start; a transition takes whom
 * its input event names, or where it names nobody one generic token.
 */
final class PlanSketch {
    /** The id of the plan that is drawn first. */
    static final String ROOT = "root";

    private final ArrayNode plans = JsonNodeFactory.instance.arrayNode();
    private ObjectNode plan;
    private Map<String, ObjectNode> places = new LinkedHashMap<>();
    private ObjectNode transition;
    private ObjectNode event;
    private int ids;

    PlanSketch() {
        plan(ROOT);
    }

    /** Goes on with another plan, which the first may run as a sub-mission. */
    PlanSketch plan(String id) {
        plan = plans.addObject().put("id", id);
        for (String part : new String[] {"variables", "tasks", "places", "transitions", "inEdges", "outEdges"}) {
            plan.putArray(part);
        }
        places = new LinkedHashMap<>();
        return this;
    }

    PlanSketch variable(String name, String type) {
        array("variables").addObject().put("name", name).put("type", type);
        return this;
    }

    PlanSketch variable(String name, ValueType type, String typeName, Value initial) {
        array("variables").addObject().put("name", name).put("type", typeName).set("initial", json(initial, type));
        return this;
    }

    /** A task of class Temperature at a location. */
    PlanSketch task(String name, GeoPoint location) {
        array("tasks")
                .addObject()
                .put("name", name)
                .put("class", "Temperature")
                .putObject("fields")
                .set("location", json(location, ValueType.Simple.POINT));
        return this;
    }

    /** An output event on a place; fields in pairs of name and {@link Value}, or name and "@variable". */
    PlanSketch asks(String place, String output, Object... fields) {
        event = place(place)
                .withArray("outputs")
                .addObject()
                .put("id", id("out"))
                .put("type", output);
        if (fields.length > 0) {
            ObjectNode sources = event.putObject("fields");
            for (int i = 0; i < fields.length; i += 2) {
                String name = (String) fields[i];
                ObjectNode source = sources.putObject(name);
                if (fields[i + 1] instanceof Value value) {
                    source.set("value", json(value, typeOf(output, name)));
                } else {
                    source.put("variable", (String) fields[i + 1]);
                }
            }
        }
        return this;
    }

    /** The event drawn last has a markup; options in pairs of name and {@link Value}, or name and an enumeration's constant. */
    PlanSketch marked(String markup, Object... options) {
        ObjectNode drawn = event.withArray("markups").addObject().put("type", markup);
        MarkupType type = TestWorld.VOCABULARY.markup(markup).orElseThrow();
        for (int i = 0; i < options.length; i += 2) {
            String name = (String) options[i];
            ObjectNode given = drawn.withObject("/options");
            if (options[i + 1] instanceof Value value) {
                given.set(name, json(value, typeOf(type.name(), type.options(), name)));
            } else {
                given.put(name, (String) options[i + 1]);
            }
        }
        return this;
    }

    /** A sub-mission on a place. */
    PlanSketch runs(String place, String child) {
        place(place)
                .withArray("subMissions")
                .add(JsonNodeFactory.instance.objectNode().put("id", id("run")).put("plan", child));
        return this;
    }

    PlanSketch end(String place) {
        place(place).put("end", true);
        return this;
    }

    /** A transition from place to place at an input event; fields select as they do in a plan. */
    PlanSketch on(String from, String input, String to, Object... selecting) {
        boolean names = TestWorld.VOCABULARY.event(input).orElseThrow().tokens() != TokenNeed.NONE;
        return on(from, input, to, names ? "relevant" : "generic", selecting);
    }

    /** As the other {@code on}, taking what is said: "relevant", "generic" or "any-token". */
    PlanSketch on(String from, String input, String to, String takes, Object... selecting) {
        transition = array("transitions").addObject().put("id", id("when"));
        if (!input.isEmpty()) {
            event = transition
                    .putArray("inputs")
                    .addObject()
                    .put("id", id("in"))
                    .put("type", input);
            for (int i = 0; i < selecting.length; i += 2) {
                String name = (String) selecting[i];
                event.withObject("/fields").set(name, json((Value) selecting[i + 1], typeOf(input, name)));
            }
        }
        place(from);
        place(to);
        boolean relevant = takes.equals("relevant");
        ObjectNode in = edge("inEdges", from);
        ObjectNode needed = in.withArray("requirements").addObject();
        if (relevant) {
            needed.put("match", "at-least").put("n", 1).put("kind", "relevant");
        } else {
            needed.put("match", "at-least").put("n", 1).put("kind", takes);
        }
        ObjectNode taken = edge("outEdges", to)
                .withArray("requirements")
                .addObject()
                .put("action", "take")
                .put("kind", takes);
        if (takes.equals("generic")) {
            taken.put("n", 1);
        } else {
            taken.put("n", "all");
        }
        return this;
    }

    /** The transition drawn last has one more place before it, which asks for nothing. */
    PlanSketch alsoFrom(String place) {
        place(place);
        edge("inEdges", place).withArray("requirements").addObject().put("kind", "unconditional");
        return this;
    }

    /** A transition that brings whom its input event names into the mission, wherever they stood. */
    PlanSketch joining(String from, String input, String to) {
        on(from, input, to, "generic");
        ((ArrayNode) plan.get("outEdges").get(plan.get("outEdges").size() - 1).get("requirements"))
                .removeAll()
                .addObject()
                .put("action", "add")
                .put("n", "all")
                .put("kind", "relevant");
        return this;
    }

    /** The transition drawn last writes a field of its input event into a variable. */
    PlanSketch writing(String field, String variable) {
        ((ObjectNode) transition.get("inputs").get(0)).withObject("/writes").put(field, variable);
        return this;
    }

    Project project() {
        ObjectNode document = JsonNodeFactory.instance.objectNode();
        document.put("formatVersion", 1)
                .put("id", "sketch")
                .put("name", "Sketch")
                .put("domain", "crw");
        document.set("plans", plans);
        return new ProjectReader(TestWorld.VOCABULARY)
                .readAndCheck(document.toString())
                .orThrow();
    }

    private ObjectNode edge(String part, String place) {
        ObjectNode edge = array(part).addObject().put("id", id("edge"));
        edge.put("place", place).put("transition", transition.get("id").asText());
        return edge;
    }

    private ObjectNode place(String id) {
        return places.computeIfAbsent(id, name -> {
            ObjectNode made = array("places").addObject().put("id", name);
            if (places.isEmpty()) {
                made.put("start", true);
            }
            return made;
        });
    }

    private ArrayNode array(String part) {
        return (ArrayNode) plan.get(part);
    }

    private String id(String kind) {
        return kind + "-" + ++ids;
    }

    private static ValueType typeOf(String event, String field) {
        return typeOf(event, TestWorld.VOCABULARY.event(event).orElseThrow().fields(), field);
    }

    private static ValueType typeOf(String of, List<FieldType> fields, String name) {
        return fields.stream()
                .filter(field -> field.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(of + " has no " + name))
                .type();
    }

    private static JsonNode json(Value value, ValueType type) {
        return ValueJson.write(value, type, TestWorld.VOCABULARY.types());
    }
}
