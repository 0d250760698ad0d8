package org.sami.spn.engine.rule;

import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.sami.spn.engine.net.CompiledOutput;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;

/**
 * Questions to the operator as they are opened and closed.
 *
 * <p>Implements R-DEC-3, R-DEC-7.
 */
public final class OpenQuestions {
    private final RuleStep step;
    private final Questions questions;
    private final Timers timers;
    private final Consumer<OpenDecision> autonomy;

    /**
     * The questions of a state.
     *
     * @param autonomy answers a question that is not left to the operator
     */
    OpenQuestions(RuleStep step, Questions questions, Timers timers, Consumer<OpenDecision> autonomy) {
        this.step = step;
        this.questions = questions;
        this.timers = timers;
        this.autonomy = autonomy;
    }

    /** An activation asks. */
    public void open(SentActivation sent) {
        Question question = questions.of(sent);
        CompiledOutput output = sent.output;
        OptionalLong deadline = output.trigger == CompiledOutput.Trigger.TIMER
                ? OptionalLong.of(step.state.now + output.timeoutMillis)
                : OptionalLong.empty();
        Decision decision = new Decision(
                ++step.state.lastDecision,
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
        sent.decision = decision.id();
        add(open);
        if (output.trigger == CompiledOutput.Trigger.TIMER) {
            open.deadline = timers.deadline(open, output.timeoutMillis);
        } else if (output.trigger == CompiledOutput.Trigger.IMMEDIATELY) {
            step.post(() -> autonomy.accept(open));
        }
    }

    /** A mission that starts asks for its parameters. */
    public void openParameters(MissionState m, List<Question.Item> items) {
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
                ++step.state.lastDecision,
                Ids.NONE,
                Ids.NONE,
                asked.kind(),
                asked.prompt(),
                asked.proxies().isEmpty()
                        ? new Question.Approve()
                        : new Question.ChooseProxies(
                                asked.proxies(), 0, asked.proxies().size()),
                asked.unanswered().map(answer -> new Answer.YesNo(answer.yes())),
                asked.unanswered().stream()
                        .mapToLong(answer -> step.state.now + answer.afterMillis())
                        .findFirst(),
                asked.priority(),
                List.of());
        OpenDecision open = new OpenDecision(decision, OpenDecision.Purpose.DOMAIN, null, null, null, asked.about());
        add(open);
        asked.unanswered().ifPresent(answer -> open.deadline = timers.deadline(open, answer.afterMillis()));
    }

    /** The domain needs no answer any longer. */
    public void withdraw(Input.WithdrawQuestion withdrawn) {
        open(withdrawn.kind(), withdrawn.about()).ifPresent(this::close);
    }

    /** The domain's open question of a kind about somebody. */
    private Optional<OpenDecision> open(String kind, String about) {
        return step.state.decisions.values().stream()
                .filter(open -> open.purpose == OpenDecision.Purpose.DOMAIN
                        && open.decision.type().equals(kind)
                        && open.subject.equals(about))
                .findFirst();
    }

    private Decision own(MissionState m, String type, String prompt, Question question, Optional<Answer> automatic) {
        return new Decision(
                ++step.state.lastDecision,
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
        step.state.decisions.put(open.decision.id(), open);
        if (open.mission != null) {
            open.mission.addDecision(open.decision.id());
        }
        step.emit(new Effect.DecisionOpened(open.decision));
    }

    /** Nobody waits for the answer any longer. */
    public void close(OpenDecision open) {
        if (step.state.decisions.containsKey(open.decision.id())) {
            remove(open);
            step.emit(new Effect.DecisionClosed(open.decision.id(), Optional.empty(), Optional.empty()));
        }
    }

    /** Takes a question away that is answered or that nobody needs to answer. */
    void remove(OpenDecision open) {
        step.state.decisions.remove(open.decision.id());
        if (open.mission != null) {
            open.mission.decisions.remove(open.decision.id());
        }
        if (open.deadline != null) {
            timers.cancel(open.deadline);
        }
        if (open.sent != null && open.sent.decision == open.decision.id()) {
            open.sent.decision = Ids.NONE;
        }
    }
}
