package org.sami.spn.json;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.model.AnswerKeys;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.StartMarking;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStart;
import org.sami.spn.model.TestStep;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Vocabulary;

/** Writes the test cases that are saved with a plan. */
final class TestCaseWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private final Vocabulary vocabulary;
    private final EventSpecWriter events;
    private final ValueWriter values;
    private final Map<String, OutputEventSpec> outputs = new LinkedHashMap<>();
    private final Map<String, ValueType> variables = new LinkedHashMap<>();

    TestCaseWriter(Vocabulary vocabulary, Plan plan, Project project) {
        this.vocabulary = vocabulary;
        this.events = new EventSpecWriter(vocabulary);
        this.values = new ValueWriter(vocabulary.types());
        plan.places().forEach(p -> p.outputs().forEach(o -> outputs.put(o.id(), o)));
        project.globals().forEach(v -> variables.put(v.name(), v.type()));
        plan.variables().forEach(v -> variables.put(v.name(), v.type()));
    }

    ObjectNode write(TestCase test) {
        ObjectNode node = NODES.objectNode().put("name", test.name());
        OptionalMembers.putTexts(node, "proxies", test.proxies());
        test.start().ifPresent(start -> node.set("start", start(start)));
        ArrayNode steps = node.putArray("steps");
        test.steps().forEach(s -> steps.add(step(s)));
        return node;
    }

    private ObjectNode start(TestStart start) {
        ObjectNode node = NODES.objectNode();
        ArrayNode places = node.putArray("places");
        for (StartMarking.Tokens at : start.marking().places()) {
            putTokens(places.addObject().put("place", at.place()), at.generic(), at.proxies(), at.tasks());
        }
        if (!start.values().isEmpty()) {
            putValues(node, "", start.values());
        }
        return node;
    }

    private static void putTokens(ObjectNode node, int generic, List<String> proxies, List<String> tasks) {
        if (generic > 0) {
            node.put("generic", generic);
        }
        OptionalMembers.putTexts(node, "proxies", proxies);
        OptionalMembers.putTexts(node, "tasks", tasks);
    }

    private ObjectNode step(TestStep step) {
        ObjectNode node = NODES.objectNode();
        if (step instanceof TestStep.Answer s) {
            node.put("do", "answer");
            OptionalMembers.putText(node, "event", s.event());
            putReply(node, s.event(), s.reply());
        } else if (step instanceof TestStep.Occur s) {
            node.put("do", "occur").put("type", s.type());
            OptionalMembers.putText(node, "answers", s.answers());
            OptionalMembers.putTexts(node, "proxies", s.proxies());
            OptionalMembers.putTexts(node, "tasks", s.tasks());
            if (!s.values().isEmpty()) {
                node.set(
                        "values",
                        events.fields(s.values(), events.type(s.type()).fields(), s.type()));
            }
        } else if (step instanceof TestStep.Press s) {
            node.put("do", "press").put("interrupt", s.interrupt());
            OptionalMembers.putTexts(node, "proxies", s.proxies());
        } else if (step instanceof TestStep.Join s) {
            node.put("do", "join").put("proxy", s.proxy());
        } else if (step instanceof TestStep.Drop s) {
            node.put("do", "drop").put("proxy", s.proxy());
        } else if (step instanceof TestStep.Advance s) {
            node.put("do", "advance").set("by", SimpleValueWriter.write(new DurationValue(s.millis())));
        } else if (step instanceof TestStep.ExpectTokens s) {
            node.put("expect", "tokens").put("place", s.place());
            putTokens(node, s.generic(), s.proxies(), s.tasks());
        } else {
            node.put("expect", "ended");
        }
        return node;
    }

    private void putReply(ObjectNode node, String event, TestStep.Reply reply) {
        if (reply instanceof TestStep.Reply.YesNo r) {
            node.put("yes", r.yes());
        } else if (reply instanceof TestStep.Reply.Proxies r) {
            node.set("proxies", InputWriter.texts(r.proxies()));
        } else if (reply instanceof TestStep.Reply.Option r) {
            node.put("option", r.index());
        } else if (reply instanceof TestStep.Reply.Values r) {
            putValues(node, event, r.values());
        } else {
            node.put("rejected", true);
        }
    }

    private void putValues(ObjectNode node, String event, Map<String, Value> answers) {
        ObjectNode given = node.putObject("values");
        for (Map.Entry<String, Value> e : answers.entrySet()) {
            ValueType type = AnswerKeys.type(vocabulary, outputs, variables, event, e.getKey())
                    .orElseThrow(() -> new IllegalArgumentException("Nothing is asked as " + e.getKey()));
            given.set(e.getKey(), values.write(e.getValue(), type));
        }
    }
}
