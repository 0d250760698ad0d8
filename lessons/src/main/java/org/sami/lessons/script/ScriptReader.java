package org.sami.lessons.script;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.WaitFor;

/** Reads one element of a script. */
final class ScriptReader {
    private static final List<String> WORDS = List.of(
            "add",
            "connect",
            "rename",
            "delete",
            "select",
            "move",
            "start",
            "end",
            "mode",
            "wait-for",
            "require",
            "field",
            "write",
            "select-by",
            "variable",
            "markup",
            "sub-mission",
            "task",
            "plan",
            "command");

    private final JsonObjectReader m;
    private final Optional<String> say;

    private ScriptReader(JsonObjectReader m) {
        this.m = m;
        this.say = optional("say");
    }

    /** The element, or nothing and a finding. */
    static Optional<ScriptElement> read(JsonObjectReader m) {
        return new ScriptReader(m).element();
    }

    private Optional<ScriptElement> element() {
        String word = m.text("do");
        if (!WORDS.contains(word)) {
            if (!word.isEmpty()) {
                unknown("do", word, WORDS);
            }
            return Optional.empty();
        }
        Optional<ScriptElement> element = switch (word) {
            case "add" -> add();
            case "connect" -> Optional.of(new ScriptElement.Connect(m.text("from"), m.text("to"), optional("id"), say));
            case "rename" -> Optional.of(new ScriptElement.Rename(m.text("what"), m.text("name", ""), say));
            case "delete" -> Optional.of(new ScriptElement.Delete(names("what"), say));
            case "select" -> Optional.of(new ScriptElement.Select(names("what"), say));
            case "move" -> move();
            case "start" -> Optional.of(new ScriptElement.Start(m.text("what"), m.flag("on", true), say));
            case "end" ->
                Optional.of(
                        new ScriptElement.End(m.text("what"), m.flag("on", true), m.flag("endsSharedInstance"), say));
            case "mode" -> word("mode", Mode.class).map(mode -> new ScriptElement.InMode(names("what"), mode, say));
            case "wait-for" ->
                word("waitFor", WaitFor.class).map(wait -> new ScriptElement.Waiting(m.text("what"), wait, say));
            case "require" -> node("requirements").map(list -> new ScriptElement.Require(m.text("edge"), list, say));
            case "field" -> field();
            case "write" -> write();
            case "select-by" -> node("fields").map(fields -> new ScriptElement.SelectBy(m.text("event"), fields, say));
            case "variable" ->
                Optional.of(new ScriptElement.Variable(m.text("name"), part("name", "type", "initial"), say));
            case "markup" ->
                Optional.of(new ScriptElement.Markup(
                        m.text("event"), m.text("type"), part("type", "options"), m.flag("on", true), say));
            case "sub-mission" -> Optional.of(subMission());
            case "task" -> Optional.of(new ScriptElement.Task(m.text("name"), part("name", "class", "fields"), say));
            case "plan" -> plan();
            default -> Optional.of(new ScriptElement.Give(m.text("id"), say));
        };
        m.done();
        return element;
    }

    private Optional<ScriptElement> add() {
        String item = m.text("item");
        Optional<LayoutPoint> at = m.node("at").flatMap(n -> point("at"));
        Optional<String> on = optional("on");
        Optional<String> name = optional("name");
        Optional<String> event = optional("event");
        if (on.isPresent()) {
            for (String member : List.of("at", "name", "event")) {
                if (m.has(member)) {
                    m.problem(
                            "E-BAD-VALUE",
                            member,
                            "With \"on\" no vertex is drawn: \"" + member
                                    + "\" goes with a new vertex; \"id\" is what the new event is called");
                }
            }
        }
        return Optional.of(new ScriptElement.Add(item, at, on, optional("id"), name, event, optional("sequence"), say));
    }

    private Optional<ScriptElement> move() {
        String what = m.text("what");
        Optional<LayoutPoint> at = point("at");
        return at.map(point -> new ScriptElement.Move(what, point, say));
    }

    private Optional<ScriptElement> field() {
        Optional<JsonNode> source = node("source");
        String event = m.text("event");
        String name = m.text("field");
        return source.map(
                s -> new ScriptElement.Field(event, name, Optional.of(s).filter(n -> !n.isNull()), say));
    }

    private Optional<ScriptElement> write() {
        Optional<JsonNode> variable = node("variable");
        String event = m.text("event");
        String name = m.text("field");
        if (variable.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(new ScriptElement.Write(
                event, name, variable.get().isNull() ? Optional.empty() : Optional.of(m.text("variable")), say));
    }

    private ScriptElement subMission() {
        return new ScriptElement.SubMission(
                m.text("what"),
                m.node("shared").map(n -> m.flag("shared")),
                m.node("tasks").map(n -> m.textMap("tasks")),
                m.node("variables").map(n -> m.textMap("variables")),
                say);
    }

    private Optional<ScriptElement> plan() {
        if (m.node("open").isPresent()) {
            return Optional.of(new ScriptElement.OpenPlan(m.text("open"), say));
        }
        return Optional.of(new ScriptElement.NewPlan(m.text("id"), m.text("name", ""), say));
    }

    private Optional<String> optional(String member) {
        return m.node(member).map(n -> m.text(member));
    }

    /** One name, or a list of at least one. */
    private List<String> names(String member) {
        Optional<JsonNode> given = m.node(member);
        List<String> names = given.isPresent() && given.get().isTextual() ? List.of(m.text(member)) : m.texts(member);
        if (given.isEmpty() || (given.get().isArray() && given.get().isEmpty())) {
            m.problem("E-MISSING-MEMBER", "", "The member \"" + member + "\" is missing: a list of ids");
        }
        return names;
    }

    private Optional<JsonNode> node(String member) {
        Optional<JsonNode> found = m.node(member);
        if (found.isEmpty()) {
            m.problem("E-MISSING-MEMBER", "", "The member \"" + member + "\" is missing");
        }
        return found;
    }

    /** Some members as an object of their own, as a plan file has it. */
    private JsonNode part(String... members) {
        Set<String> some = Set.of(members);
        Map<String, JsonNode> found = new LinkedHashMap<>();
        m.whole().properties().forEach(e -> {
            if (some.contains(e.getKey())) {
                found.put(e.getKey(), e.getValue());
            }
        });
        m.skip(members);
        ObjectNode part = ((ObjectNode) m.whole()).objectNode();
        part.setAll(found);
        return part;
    }

    private Optional<LayoutPoint> point(String member) {
        Optional<JsonNode> xy = node(member);
        if (xy.isEmpty()) {
            return Optional.empty();
        }
        JsonNode found = xy.get();
        if (!found.isArray()
                || found.size() != 2
                || !found.get(0).isNumber()
                || !found.get(1).isNumber()) {
            m.problem("E-WRONG-TYPE", member, "A vertex is drawn at [x, y]");
            return Optional.empty();
        }
        return Optional.of(
                new LayoutPoint(found.get(0).doubleValue(), found.get(1).doubleValue()));
    }

    private <E extends Enum<E>> Optional<E> word(String member, Class<E> type) {
        String word = m.text(member);
        List<E> constants = Arrays.asList(type.getEnumConstants());
        Optional<E> found =
                constants.stream().filter(c -> wordOf(c).equals(word)).findFirst();
        if (found.isEmpty() && !word.isEmpty()) {
            unknown(member, word, constants.stream().map(ScriptReader::wordOf).toList());
        }
        return found;
    }

    private static String wordOf(Enum<?> constant) {
        return constant.name().toLowerCase(Locale.ROOT).replace('_', '-');
    }

    private void unknown(String member, String word, List<String> known) {
        m.problem(
                "E-UNKNOWN-WORD",
                member,
                "\"" + word + "\" is none of: " + String.join(", ", known) + Suggestions.meant(known, word));
    }
}
