package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Collection;
import java.util.Map;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** Writes inputs in the form that {@link InputReader} reads. */
final class InputWriter {
    private static final JsonNodeFactory NODES = JsonNodeFactory.instance;

    private InputWriter() {}

    static ObjectNode write(Input input) {
        ObjectNode node = NODES.objectNode();
        if (input instanceof Input.Received i) {
            node.put("input", "received").setAll(occurrence(i.occurrence()));
        } else if (input instanceof Input.StartMission i) {
            node.put("input", "start-mission").put("plan", i.plan()).put("name", i.name());
            node.set("parameters", values(i.parameters()));
        } else if (input instanceof Input.LoadProject i) {
            node.put("input", "load-project").put("document", i.document());
        } else if (input instanceof Input.ProxyJoined i) {
            node.put("input", "proxy-joined").put("proxy", i.proxy());
        } else if (input instanceof Input.ProxyDropped i) {
            node.put("input", "proxy-dropped").put("proxy", i.proxy()).put("mission", i.mission());
        } else if (input instanceof Input.TimeReached) {
            node.put("input", "time-reached");
        } else if (input instanceof Input.Interrupt i) {
            node.put("input", "interrupt").put("mission", i.mission()).put("name", i.name());
            node.set("proxies", texts(i.proxies()));
        } else if (input instanceof Input.AbortMission i) {
            node.put("input", "abort-mission").put("mission", i.mission());
        } else if (input instanceof Input.CompleteMission i) {
            node.put("input", "complete-mission").put("mission", i.mission());
        } else {
            writeRest(input, node);
        }
        return node;
    }

    private static void writeRest(Input input, ObjectNode node) {
        if (input instanceof Input.AnswerDecision i) {
            node.put("input", "answer-decision").put("decision", i.decision()).put("by", Words.of(i.by()));
            node.set("answer", answer(i.answer()));
        } else if (input instanceof Input.SetVariable i) {
            node.put("input", "set-variable").put("mission", i.mission()).put("variable", i.variable());
            node.set("value", TaggedValues.write(i.value()));
        } else if (input instanceof Input.AllocateTasks i) {
            ArrayNode allocation = node.put("input", "allocate-tasks").putArray("allocation");
            i.allocation().forEach((task, proxy) -> {
                ObjectNode entry = allocation.addObject();
                entry.set("task", task(task));
                proxy.ifPresent(p -> entry.put("proxy", p));
            });
        } else if (input instanceof Input.AddTasks i) {
            ArrayNode tasks =
                    node.put("input", "add-tasks").put("mission", i.mission()).putArray("tasks");
            i.tasks().forEach(t -> tasks.add(taskSpec(t)));
        } else if (input instanceof Input.HandlerFailed i) {
            node.put("input", "handler-failed")
                    .put("activation", i.activation())
                    .put("reason", i.reason());
        } else if (input instanceof Input.Remember i) {
            node.put("input", "remember").put("mission", i.mission()).put("key", i.key());
            node.set("value", TaggedValues.write(i.value()));
        } else if (input instanceof Input.AskOperator i) {
            node.put("input", "ask-operator")
                    .put("kind", i.kind())
                    .put("about", i.about())
                    .put("prompt", i.prompt())
                    .put("priority", Words.of(i.priority()));
            if (!i.proxies().isEmpty()) {
                node.set("proxies", texts(i.proxies()));
            }
            i.unanswered()
                    .ifPresent(answer -> node.putObject("unanswered")
                            .put("yes", answer.yes())
                            .put("afterMillis", answer.afterMillis()));
        } else if (input instanceof Input.HoldDecision i) {
            node.put("input", "hold-decision").put("decision", i.decision());
        } else if (input instanceof Input.WithdrawQuestion i) {
            node.put("input", "withdraw-question").put("kind", i.kind()).put("about", i.about());
        } else {
            throw new IllegalArgumentException("An input of an unknown kind: " + input);
        }
    }

    /** An occurrence; members that would be empty or 0 are left out, as there are very many occurrences. */
    static ObjectNode occurrence(Occurrence o) {
        ObjectNode node = NODES.objectNode().put("type", o.type());
        if (o.mission() != 0) {
            node.put("mission", o.mission());
        }
        if (o.activation() != 0) {
            node.put("activation", o.activation());
        }
        if (!o.proxies().isEmpty()) {
            node.set("proxies", texts(o.proxies()));
        }
        if (!o.tasks().isEmpty()) {
            ArrayNode tasks = node.putArray("tasks");
            o.tasks().forEach(t -> tasks.add(task(t)));
        }
        if (!o.values().isEmpty()) {
            node.set("values", values(o.values()));
        }
        return node;
    }

    static ObjectNode answer(Answer answer) {
        ObjectNode node = NODES.objectNode();
        if (answer instanceof Answer.YesNo a) {
            node.put("yes", a.yes());
        } else if (answer instanceof Answer.Proxies a) {
            node.set("proxies", texts(a.proxies()));
        } else if (answer instanceof Answer.Option a) {
            node.put("option", a.index());
        } else if (answer instanceof Answer.Fields a) {
            node.set("values", values(a.values()));
        } else {
            node.put("rejected", true);
        }
        return node;
    }

    static ObjectNode values(Map<String, Value> values) {
        ObjectNode node = NODES.objectNode();
        values.forEach((name, value) -> node.set(name, TaggedValues.write(value)));
        return node;
    }

    static ArrayNode texts(Collection<String> texts) {
        ArrayNode array = NODES.arrayNode();
        texts.forEach(array::add);
        return array;
    }

    static JsonNode task(TaskId task) {
        return SimpleValueWriter.write(task);
    }

    private static ObjectNode taskSpec(TaskSpec task) {
        ObjectNode node = NODES.objectNode().put("name", task.name()).put("class", task.taskClass());
        node.set("fields", values(task.fields()));
        return node;
    }
}
