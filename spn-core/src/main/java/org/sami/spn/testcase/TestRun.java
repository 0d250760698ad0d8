package org.sami.spn.testcase;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.EngineView;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TestCase;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;

/** One test case under way. */
final class TestRun {
    private final Engine engine;
    private final EngineState state;
    private final Map<Long, Activation> activations = new LinkedHashMap<>();
    private long mission = Ids.NONE;
    private Optional<Outcome> outcome = Optional.empty();
    private long nowMillis;

    TestRun(Engine engine, Plan plan, TestCase test) {
        this.engine = engine;
        this.state = engine.newState();
        test.proxies().forEach(p -> step(new Input.ProxyJoined(p)));
        step(new Input.StartMission(plan.id(), test.name(), Map.of()));
    }

    /** Takes a step; what went another way, in words, or empty. */
    Optional<String> take(TestStep step) {
        if (step instanceof TestStep.Answer s) {
            return answer(s);
        } else if (step instanceof TestStep.Occur s) {
            return occur(s);
        } else if (step instanceof TestStep.Press s) {
            step(new Input.Interrupt(Ids.NONE, s.interrupt(), s.proxies()));
        } else if (step instanceof TestStep.Join s) {
            step(new Input.ProxyJoined(s.proxy()));
        } else if (step instanceof TestStep.Drop s) {
            step(new Input.ProxyDropped(s.proxy(), mission));
        } else if (step instanceof TestStep.Advance s) {
            advance(s.millis());
        } else if (step instanceof TestStep.ExpectTokens s) {
            return compare(s);
        } else if (outcome.isEmpty() || outcome.get() != Outcome.ENDED) {
            return Optional.of(
                    "the mission has not ended; tokens stand in " + marking().keySet());
        }
        return Optional.empty();
    }

    private void step(Input input) {
        for (Effect effect : engine.step(state, nowMillis, input)) {
            if (effect instanceof Effect.Activated e) {
                activations.put(e.activation().id(), e.activation());
            } else if (effect instanceof Effect.ActivationEnded e) {
                activations.remove(e.activation());
            } else if (effect instanceof Effect.MissionStarted e && mission == Ids.NONE) {
                mission = e.mission();
            } else if (effect instanceof Effect.MissionEnded e && e.mission() == mission) {
                outcome = Optional.of(e.outcome());
            }
        }
    }

    /** Time passes from one timer to the next, as it would for a host. */
    private void advance(long millis) {
        long until = nowMillis + millis;
        OptionalLong due = view().nextDueMillis();
        while (due.isPresent() && due.getAsLong() < until) {
            nowMillis = Math.max(nowMillis, due.getAsLong());
            step(new Input.TimeReached());
            due = view().nextDueMillis();
        }
        nowMillis = until;
        step(new Input.TimeReached());
    }

    private Optional<String> answer(TestStep.Answer s) {
        Optional<Decision> decision =
                view().decisions().stream().filter(d -> asks(d, s.event())).findFirst();
        decision.ifPresent(
                d -> step(new Input.AnswerDecision(d.id(), answer(s.reply(), d.question()), Answerer.OPERATOR)));
        return decision.isPresent()
                ? Optional.empty()
                : Optional.of("nothing is asked of the operator by \"" + s.event() + "\"");
    }

    private boolean asks(Decision decision, String event) {
        Activation activation = activations.get(decision.activation());
        return event.isEmpty()
                ? decision.activation() == Ids.NONE && decision.mission() == mission
                : activation != null && activation.event().equals(event);
    }

    /** The answer; what the step does not say is answered as it was proposed. */
    private static Answer answer(TestStep.Reply reply, Question question) {
        if (reply instanceof TestStep.Reply.YesNo r) {
            return new Answer.YesNo(r.yes());
        } else if (reply instanceof TestStep.Reply.Proxies r) {
            return new Answer.Proxies(r.proxies());
        } else if (reply instanceof TestStep.Reply.Option r) {
            return new Answer.Option(r.index());
        } else if (reply instanceof TestStep.Reply.Rejected) {
            return new Answer.Rejected();
        }
        Map<String, Value> values = new LinkedHashMap<>();
        if (question instanceof Question.FillIn fillIn) {
            fillIn.items().forEach(i -> i.defaultValue().ifPresent(v -> values.put(i.key(), v)));
        }
        values.putAll(((TestStep.Reply.Values) reply).values());
        return new Answer.Fields(values);
    }

    private Optional<String> occur(TestStep.Occur s) {
        List<TaskId> tasks = tasks(s.tasks());
        if (s.answers().isEmpty()) {
            long about = tasks.isEmpty() ? Ids.NONE : mission;
            step(new Input.Received(new Occurrence(s.type(), about, Ids.NONE, s.proxies(), tasks, s.values())));
            return Optional.empty();
        }
        Optional<Activation> asked = asked(view().openActivations(), s).or(() -> asked(activations.values(), s));
        asked.ifPresent(a -> step(new Input.Received(Occurrence.answer(s.type(), a, s.proxies(), tasks, s.values()))));
        return asked.isPresent()
                ? Optional.empty()
                : Optional.of("\"" + s.answers() + "\" has asked for nothing that " + s.type() + " could answer");
    }

    private List<TaskId> tasks(List<String> names) {
        return names.stream().map(name -> new TaskId(mission, name)).toList();
    }

    /** Robots and tasks that are named answer to what they were asked last; who answers without a name, to the oldest question. */
    private static Optional<Activation> asked(Collection<Activation> activations, TestStep.Occur s) {
        Stream<Activation> fitting = activations.stream()
                .filter(a -> a.event().equals(s.answers()))
                .filter(a ->
                        a.proxies().containsAll(s.proxies()) && names(a.tasks()).containsAll(s.tasks()));
        return s.proxies().isEmpty() && s.tasks().isEmpty()
                ? fitting.findFirst()
                : fitting.reduce((older, newer) -> newer);
    }

    private static List<String> names(List<TaskId> tasks) {
        return tasks.stream().map(TaskId::name).toList();
    }

    private Optional<String> compare(TestStep.ExpectTokens s) {
        List<Token> expected = new ArrayList<>();
        for (int i = 0; i < s.generic(); i++) {
            expected.add(Token.GENERIC);
        }
        s.proxies().forEach(p -> expected.add(new Token.Proxy(p)));
        tasks(s.tasks()).forEach(task -> expected.add(new Token.Task(task)));
        List<Token> found = marking().getOrDefault(s.place(), List.of());
        boolean equal = count(expected).equals(count(found));
        return equal
                ? Optional.empty()
                : Optional.of("expected in " + s.place() + " are " + words(expected) + ", found " + words(found));
    }

    private Map<String, List<Token>> marking() {
        return view().mission(mission).map(MissionView::marking).orElse(Map.of());
    }

    private EngineView view() {
        return engine.view(state);
    }

    private static Map<Token, Long> count(List<Token> tokens) {
        return tokens.stream().collect(Collectors.groupingBy(t -> t, Collectors.counting()));
    }

    private static String words(List<Token> tokens) {
        return tokens.isEmpty()
                ? "no tokens"
                : tokens.stream().map(TestRun::word).collect(Collectors.joining(", "));
    }

    private static String word(Token token) {
        if (token instanceof Token.Proxy proxy) {
            return proxy.proxy();
        }
        return token instanceof Token.Task task ? task.task().name() : "generic";
    }
}
