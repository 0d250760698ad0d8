package org.sami.spn.engine.rule;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.sami.spn.engine.net.CompiledOutput;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.Value;
import org.sami.spn.value.VariableReference;
import org.sami.spn.vocabulary.AnswerNames;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Reserved;

/**
 * Questions to the operator: opened, answered once by the operator or by autonomy, closed.
 *
 * <p>Implements R-INT-8, R-DEC-1, R-DEC-2, R-DEC-3, R-DEC-5, R-DEC-6, R-DEC-7, R-DEC-9.
 */
public final class Decisions {
    private final Rules rules;
    private final Questions questions;

    Decisions(Rules rules, Questions questions) {
        this.rules = rules;
        this.questions = questions;
    }

    /** An activation asks. */
    public void open(SentActivation sent) {
        Question question = questions.of(sent);
        CompiledOutput output = sent.output;
        OptionalLong deadline = output.trigger == CompiledOutput.Trigger.TIMER
                ? OptionalLong.of(rules.state.now + output.timeoutMillis)
                : OptionalLong.empty();
        Decision decision = new Decision(
                ++rules.state.lastDecision,
                sent.activation.mission(),
                sent.activation.id(),
                output.typeName,
                questions.prompt(sent),
                question,
                Questions.automatic(output, question),
                deadline,
                output.priority,
                output.spec.markups());
        OpenDecision open = new OpenDecision(
                decision,
                OpenDecision.Purpose.ACTIVATION,
                sent.mission(),
                sent,
                null,
                question instanceof Question.ChooseProxies && questions.offersStanding(sent)
                        ? OpenDecision.STANDING
                        : "");
        sent.decision = open;
        add(open);
        if (output.trigger == CompiledOutput.Trigger.TIMER) {
            open.deadline = rules.timers.deadline(open, output.timeoutMillis);
        } else if (output.trigger == CompiledOutput.Trigger.IMMEDIATELY) {
            rules.post(() -> byAutonomy(open));
        }
    }

    /** A mission that starts asks for its parameters. */
    public void openParameters(MissionState m, StartParameters parameters) {
        List<Question.Item> items = parameters.items();
        add(new OpenDecision(
                own(m, "", "Parameters of " + m.name, new Question.FillIn(items), Questions.defaults(items)),
                OpenDecision.Purpose.PARAMETERS,
                m,
                null,
                null,
                ""));
    }

    /** An interrupt was pressed without naming robots. */
    public void openInterruptChoice(MissionState m, String interrupt, List<String> candidates) {
        Question question = new Question.ChooseProxies(candidates, 1, Integer.MAX_VALUE);
        add(new OpenDecision(
                own(m, Decision.INTERRUPT + interrupt, "Whom is '" + interrupt + "' for?", question, Optional.empty()),
                OpenDecision.Purpose.INTERRUPT_CHOICE,
                m,
                null,
                null,
                interrupt));
    }

    /** A child was aborted and no transition waits for that. */
    public void openAborted(Instance instance, String robots) {
        MissionState m = instance.place.mission;
        String prompt = "The sub-mission on '" + instance.place.place + "' was aborted. Return " + robots
                + " to the plan? Otherwise they stay there.";
        add(new OpenDecision(
                own(
                        m,
                        Decision.ABORTED + instance.place.place.id(),
                        prompt,
                        new Question.Approve(),
                        Optional.of(new Answer.YesNo(true))),
                OpenDecision.Purpose.ABORTED_CHILD,
                m,
                null,
                instance,
                ""));
    }

    /** The domain asks; nothing happens where it does already. */
    public void ask(Input.AskOperator asked) {
        if (open(asked.kind(), asked.about()).isPresent()) {
            return;
        }
        Decision decision = new Decision(
                ++rules.state.lastDecision,
                Ids.NONE,
                Ids.NONE,
                asked.kind(),
                asked.prompt(),
                asked.proxies().isEmpty()
                        ? new Question.Approve()
                        : new Question.ChooseProxies(
                                asked.proxies(), 0, asked.proxies().size()),
                Optional.empty(),
                OptionalLong.empty(),
                asked.priority(),
                List.of());
        add(new OpenDecision(decision, OpenDecision.Purpose.DOMAIN, null, null, null, asked.about()));
    }

    /** The domain needs no answer any longer. */
    public void withdraw(Input.WithdrawQuestion withdrawn) {
        open(withdrawn.kind(), withdrawn.about()).ifPresent(this::close);
    }

    private Optional<OpenDecision> open(String kind, String about) {
        return rules.state.decisions.values().stream()
                .filter(open -> open.purpose == OpenDecision.Purpose.DOMAIN
                        && open.decision.type().equals(kind)
                        && open.subject.equals(about))
                .findFirst();
    }

    private Decision own(MissionState m, String type, String prompt, Question question, Optional<Answer> automatic) {
        return new Decision(
                ++rules.state.lastDecision,
                m.id,
                Ids.NONE,
                type,
                prompt,
                question,
                automatic,
                OptionalLong.empty(),
                Priority.MEDIUM,
                List.<MarkupSpec>of());
    }

    /** Opens a question that is put together. */
    void add(OpenDecision open) {
        rules.state.decisions.put(open.decision.id(), open);
        if (open.mission != null) {
            open.mission.addDecision(open);
        }
        rules.emit(new Effect.DecisionOpened(open.decision));
    }

    /** An answer arrives; why it is refused, empty where it is taken. */
    public Optional<String> answer(Input.AnswerDecision input) {
        OpenDecision open = rules.state.decisions.get(input.decision());
        if (open == null) {
            return Optional.of("The decision " + input.decision() + " is not open");
        }
        if (namesNobody(open, input.answer())) {
            rules.note(
                    NoteKind.NAMES_NOBODY,
                    open.mission.id,
                    "The answer to '" + open.decision.prompt() + "' names nobody; the question stays open");
            return Optional.empty();
        }
        Optional<String> wrong = wrong(open, input.answer());
        if (wrong.isPresent()) {
            return Optional.of("The answer to '" + open.decision.prompt() + "' does not fit: " + wrong.get());
        }
        if (namesOnlyGone(open, input.answer())) {
            return Optional.empty();
        }
        take(open, input.answer(), input.by());
        return Optional.empty();
    }

    /** The operator stops the timer of a decision; why that is refused, empty where it is done. */
    public Optional<String> hold(long decision) {
        OpenDecision open = rules.state.decisions.get(decision);
        if (open == null) {
            return Optional.of("The decision " + decision + " is not open");
        }
        if (open.deadline == null) {
            return Optional.of("No timer runs for '" + open.decision.prompt() + "': there is nothing to stop");
        }
        rules.timers.cancel(open.deadline);
        open.deadline = null;
        open.decision = open.decision.withoutDeadline();
        rules.emit(new Effect.DecisionHeld(decision));
        return Optional.empty();
    }

    private Optional<String> wrong(OpenDecision open, Answer answer) {
        boolean mayReject = open.purpose == OpenDecision.Purpose.INTERRUPT_CHOICE
                || (open.sent != null
                        && open.purpose == OpenDecision.Purpose.ACTIVATION
                        && open.decision.question() instanceof Question.ChooseOption
                        && !typeOf(open).rejected().isEmpty());
        return AnswerCheck.wrong(open.decision.question(), answer, mayReject, rules.project().vocabulary);
    }

    private static boolean namesNobody(OpenDecision open, Answer answer) {
        return open.purpose == OpenDecision.Purpose.ACTIVATION
                && typeOf(open).names() == AnswerNames.CHOSEN
                && answer instanceof Answer.Proxies p
                && p.proxies().isEmpty();
    }

    /** Whether an answer names only robots that are gone, where somebody is asked for; that is noted. */
    private boolean namesOnlyGone(OpenDecision open, Answer answer) {
        if (open.purpose != OpenDecision.Purpose.ACTIVATION
                || !rules.routing.namesOnlyGone(
                        occurrence(open, answer, Map.of()),
                        open.sent,
                        offered(open),
                        typeOf(open).names() == AnswerNames.CHOSEN)) {
            return false;
        }
        rules.note(
                NoteKind.NAMES_NOBODY,
                open.mission.id,
                "Whom the answer to '" + open.decision.prompt() + "' names is gone; the question stays open");
        return true;
    }

    /** Robots that a choice offers because they stood in its place when it was asked. */
    private static List<String> offered(OpenDecision open) {
        return open.decision.question() instanceof Question.ChooseProxies choice
                        && open.subject.equals(OpenDecision.STANDING)
                ? choice.proxies()
                : List.of();
    }

    private static DecisionType typeOf(OpenDecision open) {
        return open.sent.output.decision;
    }

    public void deadline(OpenDecision open) {
        open.deadline = null;
        byAutonomy(open);
    }

    /** Autonomy answers, if the question is still open and it has an answer. */
    void byAutonomy(OpenDecision open) {
        if (!rules.state.decisions.containsKey(open.decision.id())) {
            return;
        }
        Optional<Answer> automatic = open.decision.automatic();
        if (automatic.isEmpty()) {
            rules.note(
                    NoteKind.NO_AUTOMATIC_ANSWER,
                    open.mission.id,
                    "Autonomy has no answer to '" + open.decision.prompt() + "'; the operator must decide");
            return;
        }
        if (!namesOnlyGone(open, automatic.get())) {
            take(open, automatic.get(), Answerer.AUTONOMY);
        }
    }

    private void take(OpenDecision open, Answer answer, Answerer by) {
        remove(open);
        rules.emit(new Effect.DecisionClosed(open.decision.id(), Optional.of(answer), Optional.of(by)));
        switch (open.purpose) {
            case ACTIVATION -> occur(open, answer);
            case PARAMETERS -> {
                Map<String, Value> values = new LinkedHashMap<>(open.mission.parameters);
                values.putAll(AnswerCheck.values((Question.FillIn) open.decision.question(), (Answer.Fields) answer));
                open.mission.parameters = values;
                rules.missionStart.begin(open.mission);
            }
            case INTERRUPT_CHOICE -> {
                if (answer instanceof Answer.Proxies chosen) { // else the press is withdrawn
                    rules.interrupts.chosen(open.mission, open.subject, chosen.proxies());
                }
            }
            case DOMAIN -> rules.emit(answered(open, answer));
            case ABORTED_CHILD -> rules.subMissions.decided(open.instance, ((Answer.YesNo) answer).yes());
        }
    }

    private static Effect.QuestionAnswered answered(OpenDecision open, Answer answer) {
        String kind = open.decision.type();
        return answer instanceof Answer.Proxies chosen
                ? new Effect.QuestionAnswered(
                        kind, open.subject, !chosen.proxies().isEmpty(), chosen.proxies())
                : new Effect.QuestionAnswered(kind, open.subject, ((Answer.YesNo) answer).yes());
    }

    /** The answer becomes the occurrence of an input event. */
    private void occur(OpenDecision open, Answer answer) {
        DecisionType type = typeOf(open);
        Map<String, Value> values = values(open, type, answer);
        if (type.form() == DecisionForm.REDEFINE_VARIABLE || type.form() == DecisionForm.DEFINE_VARIABLES) {
            values = written(open, values);
        }
        Occurrence occurrence = occurrence(open, answer, values);
        if (!occurrence.type().isEmpty()) {
            rules.routing.route(occurrence, offered(open));
        }
    }

    /** The answer as an occurrence; of no type where the question's type has none for it. */
    private static Occurrence occurrence(OpenDecision open, Answer answer, Map<String, Value> values) {
        DecisionType type = typeOf(open);
        Activation asked = open.sent.activation;
        boolean no = answer instanceof Answer.Rejected || (answer instanceof Answer.YesNo yesNo && !yesNo.yes());
        List<String> proxies = List.of();
        List<TaskId> tasks = List.of();
        if (type.names() == AnswerNames.ENTERING) {
            proxies = asked.proxies();
            tasks = asked.tasks();
        } else if (type.names() == AnswerNames.CHOSEN && answer instanceof Answer.Proxies chosen) {
            proxies = chosen.proxies();
        }
        return Occurrence.answer(no ? type.rejected() : type.accepted(), asked, proxies, tasks, values);
    }

    /** Writes variables; the answer carries what they were given as one map. */
    private Map<String, Value> written(OpenDecision open, Map<String, Value> given) {
        Map<Value, Value> written = new LinkedHashMap<>();
        given.forEach((name, value) -> {
            if (rules.variables.write(open.mission, name, value)) {
                written.put(new VariableReference(name), value);
            }
        });
        return Map.of(Reserved.VALUES, new MapValue(written));
    }

    private static Map<String, Value> values(OpenDecision open, DecisionType type, Answer answer) {
        if (answer instanceof Answer.Fields fields) {
            return AnswerCheck.values((Question.FillIn) open.decision.question(), fields);
        }
        Map<String, Value> values = new LinkedHashMap<>();
        if (answer instanceof Answer.Option chosen) {
            Value option =
                    ((Question.ChooseOption) open.decision.question()).options().get(chosen.index());
            type.answerFields().forEach((field, from) -> {
                if (from.equals(".")) {
                    values.put(field, option);
                } else if (option instanceof RecordValue r && r.fields().containsKey(from)) {
                    values.put(field, r.fields().get(from));
                }
            });
        }
        return values;
    }

    /** Nobody waits for the answer any longer. */
    public void close(OpenDecision open) {
        if (rules.state.decisions.containsKey(open.decision.id())) {
            remove(open);
            rules.emit(new Effect.DecisionClosed(open.decision.id(), Optional.empty(), Optional.empty()));
        }
    }

    private void remove(OpenDecision open) {
        rules.state.decisions.remove(open.decision.id());
        if (open.mission != null) {
            open.mission.decisions.remove(open.decision.id());
        }
        if (open.deadline != null) {
            rules.timers.cancel(open.deadline);
        }
        if (open.sent != null && open.sent.decision == open) {
            open.sent.decision = null;
        }
    }
}
