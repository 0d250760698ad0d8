package org.sami.spn.legacy;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.legacy.LegacyPlan.DrawingMode;
import org.sami.spn.legacy.LegacyPlan.Kind;
import org.sami.spn.legacy.LegacyPlan.Move;
import org.sami.spn.legacy.LegacyPlan.Quantity;
import org.sami.spn.legacy.LegacyPlan.Role;
import org.sami.spn.legacy.LegacyPlan.Side;

/** Reads the plans of an export. */
final class LegacyPlanReader {
    private static final Map<String, Role> ROLES =
            Map.of("root", Role.ROOT, "sub-mission-instance", Role.INSTANCE, "detached", Role.DETACHED);
    private static final Map<String, DrawingMode> MODES = Map.of(
            "Nominal", DrawingMode.NOMINAL,
            "Recovery", DrawingMode.RECOVERY,
            "HiddenRecovery", DrawingMode.HIDDEN_RECOVERY,
            "Mockup", DrawingMode.MOCKUP);
    private static final Map<String, Side> SIDES =
            Map.of("input", Side.INPUT, "output", Side.OUTPUT, "unknown", Side.UNKNOWN);
    private static final Map<String, Boolean> VERTICES = Map.of("place", true, "transition", false);
    private static final Map<String, Kind> KINDS = Map.of(
            "None", Kind.NONE,
            "Generic", Kind.GENERIC,
            "AnyProxy", Kind.ANY_PROXY,
            "AnyTask", Kind.ANY_TASK,
            "AnyToken", Kind.ANY_TOKEN,
            "RelevantToken", Kind.RELEVANT,
            "SpecificTask", Kind.SPECIFIC_TASK,
            "SubMissionToken", Kind.SUB_MISSION);
    private static final Map<String, Quantity> QUANTITIES = Map.of(
            "None", Quantity.NONE,
            "LessThan", Quantity.LESS_THAN,
            "GreaterThanEqualTo", Quantity.AT_LEAST,
            "All", Quantity.ALL,
            "Number", Quantity.NUMBER);
    private static final Map<String, Move> MOVES = Map.of("Take", Move.TAKE, "Consume", Move.CONSUME, "Add", Move.ADD);

    private final Findings findings;

    LegacyPlanReader(Findings findings) {
        this.findings = findings;
    }

    LegacyPlan plan(JsonObjectReader p) {
        List<LegacyPlan.Vertex> vertices =
                p.objects("vertices").stream().map(this::vertex).toList();
        List<LegacyPlan.Edge> edges =
                p.objects("edges").stream().map(this::edge).toList();
        LegacyPlan plan = new LegacyPlan(
                p.pointer(),
                p.text("id"),
                p.text("name", ""),
                oneOf(p, "role", ROLES).orElse(Role.ROOT),
                vertices,
                edges,
                p.texts("variablesRead"),
                p.texts("variablesWritten"),
                p.objects("tasks").stream().map(this::task).toList(),
                p.object("integrity").map(i -> i.integer("danglingEdgeRefs", 0)).orElse(0));
        p.skip("parentPlan", "inMissionTree", "layout", "integrity").done();
        checkEdges(plan);
        return plan;
    }

    /** A word that may be missing. */
    private static <E> Optional<E> oneOf(JsonObjectReader c, String member, Map<String, E> words) {
        String word = c.text(member, "");
        if (word.isEmpty() && !c.node(member).filter(JsonNode::isTextual).isPresent()) {
            return Optional.empty();
        }
        E constant = words.get(word);
        if (constant == null) {
            c.problem(
                    LegacyCodes.UNKNOWN_WORD,
                    member,
                    "\"" + word + "\" is none of: "
                            + String.join(", ", words.keySet().stream().sorted().toList()));
            return Optional.empty();
        }
        return Optional.of(constant);
    }

    private LegacyPlan.Task task(JsonObjectReader t) {
        LegacyPlan.Task task = new LegacyPlan.Task(t.pointer(), t.text("name"), t.text("class", ""));
        t.done();
        return task;
    }

    private LegacyPlan.Vertex vertex(JsonObjectReader v) {
        if (v.node("type").isEmpty()) {
            v.problem(LegacyCodes.MISSING, "", "The member \"type\" is missing");
        }
        LegacyPlan.Vertex vertex = new LegacyPlan.Vertex(
                v.pointer(),
                v.text("key"),
                oneOf(v, "type", VERTICES).orElse(true),
                v.text("name", ""),
                oneOf(v, "mode", MODES).orElse(DrawingMode.NOMINAL),
                v.number("x", 0),
                v.number("y", 0),
                v.flag("isStart"),
                v.flag("isEnd"),
                v.flag("isSharedSmEnd"),
                v.texts("outTransitionOrder"),
                v.texts("inPlaceOrder"),
                v.texts("outPlaceOrder"),
                v.objects("events").stream().map(this::event).toList(),
                v.objects("subMissions").stream().map(this::subMission).toList(),
                value(v, "mockupData"));
        v.skip("vertexId", "mockup", "visibility", "hasEventOnWrongSide").done();
        return vertex;
    }

    private static Optional<LegacyValue> value(JsonObjectReader c, String member) {
        return c.node(member).map(n -> new LegacyValue(c.at(member), n));
    }

    private LegacyPlan.Event event(JsonObjectReader e) {
        Map<String, Boolean> editable = new LinkedHashMap<>();
        e.map("editable")
                .forEach((field, element) -> editable.put(field, element.node().asBoolean()));
        LegacyPlan.Event event = new LegacyPlan.Event(
                new LegacyValue(e.pointer(), e.whole()),
                e.text("key"),
                e.text("class"),
                oneOf(e, "direction", SIDES).orElse(Side.UNKNOWN),
                e.texts("declaredFields"),
                values(e, "fieldValues"),
                variables(e, "readVariables"),
                variables(e, "writeVariables"),
                editable,
                e.objects("markups").stream().map(this::markup).toList());
        e.skip("locked", "declaredOutputs").done();
        return event;
    }

    private static Map<String, LegacyValue> values(JsonObjectReader c, String member) {
        Map<String, LegacyValue> values = new LinkedHashMap<>();
        c.map(member).forEach((field, e) -> values.put(field, new LegacyValue(e.pointer(), e.node())));
        return values;
    }

    private static Map<String, String> variables(JsonObjectReader c, String member) {
        Map<String, String> variables = c.textMap(member);
        variables.replaceAll((field, name) -> variable(c, member, name));
        return variables;
    }

    /** A variable's name; the export writes it with its sign, and a name without one is taken as if it had it. */
    static String variable(JsonObjectReader c, String member, String name) {
        if (!name.isEmpty() && !name.startsWith("@")) {
            return "@" + name;
        }
        if (name.equals("@")) {
            c.problem(LegacyCodes.WRONG_TYPE, member, "\"@\" is no name of a variable");
        }
        return name;
    }

    private LegacyPlan.Markup markup(JsonObjectReader m) {
        LegacyPlan.Markup markup =
                new LegacyPlan.Markup(m.pointer(), m.text("class"), values(m, "options"), values(m, "parameters"));
        m.done();
        return markup;
    }

    private LegacyPlan.SubMission subMission(JsonObjectReader s) {
        Map<String, String> tasks = new LinkedHashMap<>();
        for (JsonObjectReader entry : s.objects("taskMap")) {
            entry.skip("key", "value");
            tasks.put(taskName(entry, "key"), taskName(entry, "value"));
        }
        String mode = s.text("instanceMode", "");
        boolean shared = mode.isEmpty() ? s.flag("sharedInstanceFlag") : mode.equals("static");
        if (!mode.isEmpty() && !mode.equals("static") && !mode.equals("dynamic")) {
            s.problem(LegacyCodes.UNKNOWN_WORD, "instanceMode", "\"" + mode + "\" is none of: dynamic, static");
        }
        LegacyPlan.SubMission spec = new LegacyPlan.SubMission(s.pointer(), s.text("plan"), shared, tasks);
        s.skip(
                        "planName",
                        "sharedInstanceFlag",
                        "hasTaskMap",
                        "inferredTemplateName",
                        "inferredTemplatePlan",
                        "inferredNamePrefix",
                        "variablePrefixesSeen")
                .done();
        return spec;
    }

    /** A task in a task map: its name, or an object that has one. */
    private static String taskName(JsonObjectReader entry, String member) {
        JsonNode node = entry.node(member).orElse(null);
        if (node == null) {
            entry.problem(LegacyCodes.MISSING, "", "The member \"" + member + "\" is missing");
            return "";
        }
        for (JsonNode candidate : List.of(
                node, node.path("value"), node.path("name"), node.path("fields").path("name"))) {
            if (candidate.isTextual()) {
                return candidate.textValue();
            }
        }
        entry.problem(
                LegacyCodes.WRONG_TYPE,
                member,
                "A task's name is expected here, not " + JsonObjectReader.describe(node));
        return "";
    }

    private LegacyPlan.Edge edge(JsonObjectReader e) {
        String type = e.text("type");
        if (!type.isEmpty() && !type.equals("in") && !type.equals("out")) {
            e.problem(LegacyCodes.UNKNOWN_WORD, "type", "\"" + type + "\" is none of: in, out");
        }
        LegacyPlan.Edge edge = new LegacyPlan.Edge(
                e.pointer(),
                e.text("key"),
                type.equals("in"),
                e.text("from"),
                e.text("to"),
                oneOf(e, "mode", MODES).orElse(DrawingMode.NOMINAL),
                e.objects("requirements").stream().map(this::requirement).toList(),
                value(e, "mockupRequirements"));
        e.skip("edgeId", "fromName", "toName", "visibility", "mockup").done();
        return edge;
    }

    private LegacyPlan.Requirement requirement(JsonObjectReader r) {
        if (r.node("kind").isEmpty()) {
            r.problem(LegacyCodes.MISSING, "", "The member \"kind\" is missing");
        }
        LegacyPlan.Requirement requirement = new LegacyPlan.Requirement(
                r.pointer(),
                oneOf(r, "kind", KINDS).orElse(Kind.NONE),
                oneOf(r, "match", QUANTITIES),
                r.integer("quantity", 0),
                r.text("taskName", ""),
                oneOf(r, "action", MOVES));
        r.skip("locked", "text").done();
        return requirement;
    }

    /** Keys are unique in the plan, and edges join a place and a transition that are there. */
    private void checkEdges(LegacyPlan plan) {
        Set<String> keys = new HashSet<>();
        Set<String> places = new HashSet<>();
        Set<String> transitions = new HashSet<>();
        for (LegacyPlan.Vertex v : plan.vertices()) {
            unique(keys, v.key(), v.pointer());
            (v.place() ? places : transitions).add(v.key());
            v.events().forEach(e -> unique(keys, e.key(), e.pointer()));
        }
        for (LegacyPlan.Edge e : plan.edges()) {
            unique(keys, e.key(), e.pointer());
            end(e, "from", e.from(), e.in() ? places : transitions, e.in() ? "place" : "transition");
            end(e, "to", e.to(), e.in() ? transitions : places, e.in() ? "transition" : "place");
        }
    }

    private void unique(Set<String> keys, String key, String pointer) {
        if (!key.isEmpty() && !keys.add(key)) {
            findings.error(
                    LegacyCodes.DUPLICATE,
                    JsonObjectReader.at(pointer, "key"),
                    "The key " + key + " is there twice",
                    key);
        }
    }

    private void end(LegacyPlan.Edge e, String member, String key, Set<String> vertices, String what) {
        if (!key.isEmpty() && !vertices.contains(key)) {
            findings.error(
                    LegacyCodes.DANGLING,
                    JsonObjectReader.at(e.pointer(), member),
                    "The edge " + e.key() + " hangs in the air: there is no " + what + " \"" + key + "\"",
                    e.key());
        }
    }
}
