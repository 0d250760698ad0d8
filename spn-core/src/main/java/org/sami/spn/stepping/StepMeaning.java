package org.sami.spn.stepping;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.stream.Stream;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.TestStep;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.TokenNeed;

/** Which input of the engine a step of a test case means at one moment, and which step says what an input says. */
final class StepMeaning {
    private final Moment moment;
    private final EngineView view;

    StepMeaning(Moment moment, EngineView view) {
        this.moment = moment;
        this.view = view;
    }

    /** The decision that a step answers: the oldest that its output event, or empty text the mission itself, has open. */
    Optional<Decision> decision(String event) {
        return view.decisions().stream().filter(d -> asks(d, event)).findFirst();
    }

    private boolean asks(Decision decision, String event) {
        Activation activation = moment.activations.get(decision.activation());
        return event.isEmpty()
                ? decision.activation() == Ids.NONE && decision.mission() == moment.mission
                : activation != null && activation.event().equals(event);
    }

    /** The name of the output event that asks a decision; empty text where the mission itself asks. */
    String eventOf(Decision decision) {
        Activation activation = moment.activations.get(decision.activation());
        return activation == null ? "" : activation.event();
    }

    Input answer(TestStep.Reply reply, Decision decision) {
        return new Input.AnswerDecision(decision.id(), answer(reply, decision.question()), Answerer.OPERATOR);
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

    static TestStep.Reply reply(Answer answer) {
        if (answer instanceof Answer.YesNo a) {
            return new TestStep.Reply.YesNo(a.yes());
        } else if (answer instanceof Answer.Proxies a) {
            return new TestStep.Reply.Proxies(a.proxies());
        } else if (answer instanceof Answer.Option a) {
            return new TestStep.Reply.Option(a.index());
        } else if (answer instanceof Answer.Rejected) {
            return new TestStep.Reply.Rejected();
        }
        return new TestStep.Reply.Values(((Answer.Fields) answer).values());
    }

    /**
     * The activation that a step answers: a step that names robots answers their last question, one that names nobody the oldest question. What asks of
     * nobody, or means none of those who entered, may be answered with somebody new, as by robots that connect.
     */
    Optional<Activation> activation(TestStep.Occur step) {
        return asked(view.openActivations(), step, a -> asksOfNobody(a) || asks(a, step))
                .or(() -> asked(moment.activations.values(), step, a -> asksOfNobody(a) || asks(a, step)))
                .or(() -> asked(view.openActivations(), step, this::meansNobody));
    }

    private static Optional<Activation> asked(
            Collection<Activation> activations, TestStep.Occur s, Predicate<Activation> isAsked) {
        Stream<Activation> fitting =
                activations.stream().filter(a -> a.event().equals(s.answers())).filter(isAsked);
        return s.proxies().isEmpty() && s.tasks().isEmpty()
                ? fitting.findFirst()
                : fitting.reduce((older, newer) -> newer);
    }

    private static boolean asks(Activation asked, TestStep.Occur s) {
        return asked.proxies().containsAll(s.proxies()) && names(asked.tasks()).containsAll(s.tasks());
    }

    private static boolean asksOfNobody(Activation activation) {
        return activation.proxies().isEmpty() && activation.tasks().isEmpty();
    }

    private boolean meansNobody(Activation activation) {
        return view.vocabulary()
                .event(activation.type())
                .filter(type -> type.tokens() == TokenNeed.NONE)
                .isPresent();
    }

    private static List<String> names(List<TaskId> tasks) {
        return tasks.stream().map(TaskId::name).toList();
    }

    /** News; where it names tasks, to the mission that they are of. */
    Input news(TestStep.Occur s) {
        List<TaskId> tasks = tasks(s.tasks());
        long about = tasks.isEmpty() ? Ids.NONE : moment.mission;
        return new Input.Received(new Occurrence(s.type(), about, Ids.NONE, s.proxies(), tasks, s.values()));
    }

    Input answer(TestStep.Occur s, Activation activation) {
        return new Input.Received(
                Occurrence.answer(s.type(), activation, s.proxies(), tasks(s.tasks(), activation), s.values()));
    }

    private List<TaskId> tasks(List<String> names) {
        return names.stream().map(name -> new TaskId(moment.mission, name)).toList();
    }

    /** Tasks by their names in the mission that asked: in a sub-mission a task of the parent has a name of its own. */
    private List<TaskId> tasks(List<String> names, Activation asked) {
        return names.stream()
                .map(name -> asked.tasks().stream()
                        .filter(task -> task.name().equals(name))
                        .findFirst()
                        .orElse(new TaskId(moment.mission, name)))
                .toList();
    }
}
