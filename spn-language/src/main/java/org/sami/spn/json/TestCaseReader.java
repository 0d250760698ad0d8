package org.sami.spn.json;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.model.AnswerKeys;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;

/** Reads the test cases that are saved with a plan. */
final class TestCaseReader {
    private final PlanParts parts;
    private final Map<String, Place> places = new LinkedHashMap<>();
    private final Map<String, OutputEventSpec> outputs = new LinkedHashMap<>();
    private final Map<String, ValueType> variables = new LinkedHashMap<>();

    private final Set<String> refused;

    /**
     * A reader of one plan's test cases.
     *
     * @param refused ids of output events that are in the document and could not be read
     */
    TestCaseReader(
            PlanParts parts,
            List<Place> places,
            List<VariableSpec> globals,
            List<VariableSpec> variables,
            Set<String> refused) {
        this.parts = parts;
        this.refused = refused;
        places.forEach(p -> {
            this.places.put(p.id(), p);
            p.outputs().forEach(o -> outputs.put(o.id(), o));
        });
        globals.forEach(v -> this.variables.put(v.name(), v.type()));
        variables.forEach(v -> this.variables.put(v.name(), v.type()));
    }

    TestCase read(JsonObjectReader m) {
        String name = m.text("name");
        List<String> proxies = m.texts("proxies");
        Optional<TestStart> start = m.object("start").map(this::start);
        List<TestStep> steps = new ArrayList<>();
        for (JsonObjectReader s : m.objects("steps")) {
            step(s).ifPresent(steps::add);
            s.done();
        }
        m.done();
        return new TestCase(name, proxies, start, steps);
    }

    private TestStart start(JsonObjectReader m) {
        List<StartMarking.Tokens> at = new ArrayList<>();
        for (JsonObjectReader p : m.objects("places")) {
            at.add(new StartMarking.Tokens(
                    known(p, "place", places), generic(p), p.texts("proxies"), p.texts("tasks")));
            p.done();
        }
        if (at.isEmpty()) {
            m.problem(Codes.BAD_VALUE, "places", "\"places\" says where the test case starts");
        }
        Map<String, Value> values = values(m, "");
        m.done();
        return new TestStart(new StartMarking(at), values);
    }

    private static int generic(JsonObjectReader m) {
        int generic = m.integer("generic", 0);
        if (generic < 0) {
            m.problem(Codes.BAD_VALUE, "generic", "A number of tokens is not negative: " + generic);
        }
        return Math.max(0, generic);
    }

    private Optional<TestStep> step(JsonObjectReader s) {
        String verb = s.has("expect") ? "expect " + s.text("expect") : s.text("do");
        return switch (verb) {
            case "answer" -> answer(s);
            case "occur" -> occur(s);
            case "press" -> Optional.of(new TestStep.Press(s.text("interrupt"), s.texts("proxies")));
            case "join" -> Optional.of(new TestStep.Join(s.text("proxy")));
            case "drop" -> Optional.of(new TestStep.Drop(s.text("proxy")));
            case "advance" -> advance(s);
            case "expect tokens" -> Optional.of(expectTokens(s));
            case "expect ended" -> Optional.of(new TestStep.ExpectEnded());
            default -> {
                s.problem(
                        Codes.UNKNOWN_WORD,
                        "",
                        "A step is \"do\": answer, occur, press, join, drop, advance; or \"expect\": tokens, ended");
                yield Optional.empty();
            }
        };
    }

    private TestStep expectTokens(JsonObjectReader s) {
        return new TestStep.ExpectTokens(known(s, "place", places), generic(s), s.texts("proxies"), s.texts("tasks"));
    }

    private Optional<TestStep> answer(JsonObjectReader s) {
        String event = s.has("event") ? known(s, "event", outputs) : "";
        Optional<TestStep.Reply> reply = Optional.empty();
        if (s.has("yes")) {
            reply = Optional.of(new TestStep.Reply.YesNo(s.flag("yes")));
        } else if (s.has("proxies")) {
            reply = Optional.of(new TestStep.Reply.Proxies(s.texts("proxies")));
        } else if (s.has("option")) {
            reply = Optional.of(new TestStep.Reply.Option(s.integer("option", 0)));
        } else if (s.has("rejected")) {
            if (!s.flag("rejected")) {
                s.problem(Codes.BAD_VALUE, "rejected", "\"rejected\" is true or not there");
            }
            reply = Optional.of(new TestStep.Reply.Rejected());
        } else if (s.has("values")) {
            reply = Optional.of(new TestStep.Reply.Values(values(s, event)));
        } else {
            s.problem(
                    Codes.MISSING,
                    "",
                    "An answer has one of \"yes\", \"proxies\", \"option\", \"rejected\", \"values\"");
        }
        return reply.map(r -> new TestStep.Answer(event, r));
    }

    private Map<String, Value> values(JsonObjectReader m, String event) {
        Map<String, Value> values = new LinkedHashMap<>();
        m.map("values")
                .forEach((key, element) -> answerType(event, key, element.pointer())
                        .flatMap(type -> parts.value(element, type))
                        .ifPresent(v -> values.put(key, v)));
        return values;
    }

    /** The type of a value in an answer, empty where the key means nothing, which is reported. */
    private Optional<ValueType> answerType(String event, String key, String pointer) {
        Optional<ValueType> type = AnswerKeys.type(parts.vocabulary(), outputs, variables, event, key);
        if (type.isEmpty() && !refused.contains(event)) {
            parts.problems().add(Codes.UNKNOWN_FIELD, pointer, "Nothing is asked under the name \"" + key + "\"");
        }
        return type;
    }

    private Optional<TestStep> occur(JsonObjectReader s) {
        String name = s.text("type");
        Optional<EventType> type = parts.vocabulary().event(name).filter(t -> t.direction() == Direction.INPUT);
        String answers = s.has("answers") ? known(s, "answers", outputs) : "";
        List<String> proxies = s.texts("proxies");
        List<String> tasks = s.texts("tasks");
        Map<String, JsonObjectReader.Element> given = s.map("values");
        if (type.isEmpty()) {
            s.problem(
                    Codes.UNKNOWN_EVENT,
                    "type",
                    "There is no input event \"" + name + "\""
                            + NearMatches.guess(parts.vocabulary(), Direction.INPUT, name));
            return Optional.empty();
        }
        List<FieldType> fields = type.get().fields();
        return Optional.of(new TestStep.Occur(
                type.get().name(),
                answers,
                proxies,
                tasks,
                parts.fields(given, fields, "event " + type.get().name())));
    }

    private Optional<TestStep> advance(JsonObjectReader s) {
        Optional<Value> by = s.node("by")
                .flatMap(n -> parts.value(new JsonObjectReader.Element(n, s.at("by")), ValueType.Simple.DURATION));
        if (!s.has("by")) {
            s.problem(Codes.MISSING, "", "\"by\" says how much time passes");
        }
        return by.map(v -> new TestStep.Advance(((DurationValue) v).millis()));
    }

    private String known(JsonObjectReader s, String member, Map<String, ?> elements) {
        String id = s.text(member);
        if (!id.isEmpty() && !elements.containsKey(id) && !refused.contains(id)) {
            s.problem(
                    Codes.DANGLING,
                    member,
                    "The plan has no \"" + id + "\" that could be meant here"
                            + Suggestions.meant(elements.keySet(), id));
        }
        return id;
    }
}
