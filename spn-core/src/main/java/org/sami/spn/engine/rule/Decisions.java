package org.sami.spn.engine.rule;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Answerer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
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
 * Answers to questions: one is taken of the operator or of autonomy, and the rest follows from it.
 *
 * <p>Implements R-INT-8, R-DEC-1, R-DEC-2, R-DEC-5, R-DEC-6, R-DEC-9.
 */
public final class Decisions {
    private final RuleStep step;
    private final MissionRules rules;

    Decisions(RuleStep step, MissionRules rules) {
        this.step = step;
        this.rules = rules;
    }

    /** An answer arrives; why it is refused, empty where it is taken. */
    public Optional<String> answer(Input.AnswerDecision input) {
        OpenDecision open = step.state.decisions.get(input.decision());
        if (open == null) {
            return Optional.of("The decision " + input.decision() + " is not open");
        }
        if (namesNobody(open, input.answer())) {
            step.note(
                    NoteKind.NAMES_NOBODY,
                    open.asker().id,
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
        OpenDecision open = step.state.decisions.get(decision);
        if (open == null) {
            return Optional.of("The decision " + decision + " is not open");
        }
        if (open.deadline == null) {
            return Optional.of("No timer runs for '" + open.decision.prompt() + "': there is nothing to stop");
        }
        rules.timers.cancel(open.deadline);
        open.deadline = null;
        open.decision = open.decision.withoutDeadline();
        step.emit(new Effect.DecisionHeld(decision));
        return Optional.empty();
    }

    private Optional<String> wrong(OpenDecision open, Answer answer) {
        boolean mayReject = open.purpose == OpenDecision.Purpose.INTERRUPT_CHOICE
                || (open.sent != null
                        && open.purpose == OpenDecision.Purpose.ACTIVATION
                        && open.decision.question() instanceof Question.ChooseOption
                        && !typeOf(open).rejected().isEmpty());
        return AnswerCheck.wrong(open.decision.question(), answer, mayReject, step.project().vocabulary);
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
                        open.activation(),
                        offered(open),
                        typeOf(open).names() == AnswerNames.CHOSEN)) {
            return false;
        }
        step.note(
                NoteKind.NAMES_NOBODY,
                open.asker().id,
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
        return open.activation().output.decision();
    }

    public void deadline(OpenDecision open) {
        open.deadline = null;
        byAutonomy(open);
    }

    /** Autonomy answers, if the question is still open and it has an answer. */
    void byAutonomy(OpenDecision open) {
        if (!step.state.decisions.containsKey(open.decision.id())) {
            return;
        }
        Optional<Answer> automatic = open.decision.automatic();
        if (automatic.isEmpty()) {
            step.note(
                    NoteKind.NO_AUTOMATIC_ANSWER,
                    open.asker().id,
                    "Autonomy has no answer to '" + open.decision.prompt() + "'; the operator must decide");
            return;
        }
        if (!namesOnlyGone(open, automatic.get())) {
            take(open, automatic.get(), Answerer.AUTONOMY);
        }
    }

    private void take(OpenDecision open, Answer answer, Answerer by) {
        rules.questions.remove(open);
        step.emit(new Effect.DecisionClosed(open.decision.id(), Optional.of(answer), Optional.of(by)));
        switch (open.purpose) {
            case ACTIVATION -> occur(open, answer);
            case PARAMETERS -> {
                MissionState starting = open.asker();
                Map<String, Value> values = new LinkedHashMap<>(starting.parameters);
                values.putAll(AnswerCheck.values((Question.FillIn) open.decision.question(), (Answer.Fields) answer));
                starting.parameters = values;
                rules.missionStart.begin(starting);
            }
            case INTERRUPT_CHOICE -> {
                if (answer instanceof Answer.Proxies chosen) { // else the press is withdrawn
                    rules.interrupts.chosen(open.asker(), open.subject, chosen.proxies());
                }
            }
            case DOMAIN -> step.emit(answered(open, answer));
            case ABORTED_CHILD ->
                rules.subMissions.decided(Objects.requireNonNull(open.instance), ((Answer.YesNo) answer).yes());
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
        Activation asked = open.activation().activation;
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
            if (rules.scopes.write(open.mission, name, value)) {
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
}
