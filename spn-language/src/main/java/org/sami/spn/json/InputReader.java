package org.sami.spn.json;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Reads inputs as {@link InputWriter} wrote them. */
final class InputReader {
    private final Problems problems;
    private final ValueReader values;

    InputReader(Problems problems) {
        this.problems = problems;
        this.values = new ValueReader(Map.of(), problems);
    }

    Optional<Input> read(JsonNode node) {
        Optional<JsonObjectReader> members = JsonObjectReader.of(node, "", problems);
        Optional<Input> input = members.flatMap(this::read);
        members.filter(m -> input.isPresent()).ifPresent(JsonObjectReader::done);
        return input;
    }

    private Optional<Input> read(JsonObjectReader m) {
        String kind = m.text("input");
        return switch (kind) {
            case "received" -> Optional.of(new Input.Received(occurrence(m)));
            case "start-mission" ->
                Optional.of(new Input.StartMission(m.text("plan"), m.text("name", ""), values(m, "parameters")));
            case "load-project" -> Optional.of(new Input.LoadProject(m.text("document", "")));
            case "proxy-joined" -> Optional.of(new Input.ProxyJoined(m.text("proxy")));
            case "proxy-dropped" -> Optional.of(new Input.ProxyDropped(m.text("proxy"), m.whole("mission")));
            case "time-reached" -> Optional.of(new Input.TimeReached());
            case "interrupt" ->
                Optional.of(new Input.Interrupt(m.whole("mission"), m.text("name", ""), m.texts("proxies")));
            case "abort-mission" -> Optional.of(new Input.AbortMission(m.whole("mission")));
            case "complete-mission" -> Optional.of(new Input.CompleteMission(m.whole("mission")));
            case "answer-decision" -> answerDecision(m);
            case "hold-decision" -> Optional.of(new Input.HoldDecision(m.whole("decision")));
            case "set-variable" ->
                value(m).map(v -> new Input.SetVariable(m.whole("mission"), m.text("variable", ""), v));
            case "allocate-tasks" -> Optional.of(allocateTasks(m));
            case "add-tasks" -> Optional.of(new Input.AddTasks(m.whole("mission"), tasks(m)));
            case "handler-failed" -> Optional.of(new Input.HandlerFailed(m.whole("activation"), m.text("reason", "")));
            case "remember" -> value(m).map(v -> new Input.Remember(m.whole("mission"), m.text("key", ""), v));
            case "ask-operator" -> m.word("priority", Priority.class).map(p -> askOperator(m, p));
            case "withdraw-question" -> Optional.of(new Input.WithdrawQuestion(m.text("kind"), m.text("about", "")));
            default -> {
                m.problem(Codes.UNKNOWN_WORD, "input", "\"" + kind + "\" is no kind of input");
                yield Optional.empty();
            }
        };
    }

    private Occurrence occurrence(JsonObjectReader m) {
        return new Occurrence(
                m.text("type"),
                m.has("mission") ? m.whole("mission") : 0,
                m.has("activation") ? m.whole("activation") : 0,
                m.texts("proxies"),
                m.array("tasks").stream()
                        .map(this::task)
                        .flatMap(Optional::stream)
                        .toList(),
                values(m, "values"));
    }

    private static Input askOperator(JsonObjectReader m, Priority priority) {
        List<String> proxies = m.texts("proxies");
        Optional<Input.AskOperator.Unanswered> unanswered = m.object("unanswered")
                .filter(answer -> proxies.isEmpty())
                .map(answer ->
                        new Input.AskOperator.Unanswered(answer.flag("yes"), Math.max(0, answer.whole("afterMillis"))));
        return new Input.AskOperator(
                m.text("kind"), m.text("about", ""), m.text("prompt", ""), priority, proxies, unanswered);
    }

    private Optional<Input> answerDecision(JsonObjectReader m) {
        long decision = m.whole("decision");
        Optional<Answerer> by = m.word("by", Answerer.class);
        Optional<Answer> answer = m.object("answer").flatMap(this::answer);
        if (answer.isEmpty()) {
            m.problem(Codes.MISSING, "", "An answer is missing");
        }
        return by.flatMap(b -> answer.map(a -> new Input.AnswerDecision(decision, a, b)));
    }

    private Optional<Answer> answer(JsonObjectReader m) {
        Optional<Answer> answer = Optional.empty();
        if (m.has("yes")) {
            answer = Optional.of(new Answer.YesNo(m.flag("yes")));
        } else if (m.has("proxies")) {
            answer = Optional.of(new Answer.Proxies(m.texts("proxies")));
        } else if (m.has("option")) {
            answer = Optional.of(new Answer.Option(m.integer("option", 0)));
        } else if (m.has("values")) {
            answer = Optional.of(new Answer.Fields(values(m, "values")));
        } else if (m.flag("rejected")) {
            answer = Optional.of(new Answer.Rejected());
        }
        m.done();
        return answer;
    }

    private Input allocateTasks(JsonObjectReader m) {
        Map<TaskId, Optional<String>> allocation = new LinkedHashMap<>();
        for (JsonObjectReader entry : m.objects("allocation")) {
            Optional<TaskId> task =
                    entry.node("task").flatMap(n -> task(new JsonObjectReader.Element(n, entry.at("task"))));
            Optional<String> proxy = entry.has("proxy") ? Optional.of(entry.text("proxy")) : Optional.empty();
            entry.done();
            task.ifPresent(t -> allocation.put(t, proxy));
        }
        return new Input.AllocateTasks(allocation);
    }

    private List<TaskSpec> tasks(JsonObjectReader m) {
        List<TaskSpec> tasks = new ArrayList<>();
        for (JsonObjectReader t : m.objects("tasks")) {
            tasks.add(new TaskSpec(t.text("name"), t.text("class"), values(t, "fields")));
            t.done();
        }
        return tasks;
    }

    private Optional<TaskId> task(JsonObjectReader.Element element) {
        return values.read(element.node(), ValueType.Simple.TASK, element.pointer())
                .map(TaskId.class::cast);
    }

    private Optional<Value> value(JsonObjectReader m) {
        Optional<JsonNode> node = m.node("value");
        if (node.isEmpty()) {
            m.problem(Codes.MISSING, "", "The member \"value\" is missing");
        }
        return node.flatMap(n -> new TaggedValues(problems).read(n, m.at("value")));
    }

    private Map<String, Value> values(JsonObjectReader m, String member) {
        Map<String, Value> read = new LinkedHashMap<>();
        TaggedValues tagged = new TaggedValues(problems);
        m.map(member).forEach((name, e) -> tagged.read(e.node(), e.pointer()).ifPresent(v -> read.put(name, v)));
        return read;
    }
}
