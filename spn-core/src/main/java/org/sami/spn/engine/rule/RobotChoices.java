package org.sami.spn.engine.rule;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.sami.spn.engine.net.CompiledOutput;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Question;

/**
 * Open choices of robots after robots that they offer have gone: asked again without them, or given up.
 *
 * <p>Implements R-DEC-8, R-DEC-10.
 */
public final class RobotChoices {
    private final RuleStep step;
    private final Questions questions;
    private final OpenQuestions asked;
    private final Timers timers;
    private final Consumer<OpenDecision> autonomy;

    /**
     * The choices of a state.
     *
     * @param autonomy answers a question that is not left to the operator
     */
    RobotChoices(
            RuleStep step, Questions questions, OpenQuestions asked, Timers timers, Consumer<OpenDecision> autonomy) {
        this.step = step;
        this.questions = questions;
        this.asked = asked;
        this.timers = timers;
        this.autonomy = autonomy;
    }

    /**
     * Robots have gone: choices that offer them are asked again without them, in the order in which they were asked.
     *
     * @param gone by mission, the robots that its choices must no longer offer
     * @param how what became of them, as the end of a sentence: {@code dropped}
     */
    void gone(Map<MissionState, Set<String>> gone, String how) {
        for (OpenDecision open : List.copyOf(step.state.decisions.values())) {
            Set<String> without = gone.getOrDefault(open.mission, Set.of());
            if (open.decision.question() instanceof Question.ChooseProxies choice
                    && choice.proxies().stream().anyMatch(without::contains)) {
                List<String> left = choice.proxies().stream()
                        .filter(robot -> !without.contains(robot))
                        .toList();
                String who = choice.proxies().stream()
                        .filter(without::contains)
                        .map(robot -> "'" + robot + "' was " + how)
                        .collect(Collectors.joining(", "));
                List<String> all = questions.all(open, without);
                if (tooFew(left, choice) && filtered(open) && all.size() > left.size()) {
                    askAll(open, all, who);
                } else if (left.isEmpty() && open.purpose == OpenDecision.Purpose.INTERRUPT_CHOICE) {
                    asked.close(open);
                    step.note(
                            NoteKind.INTERRUPT_REFUSED,
                            open.asker().id,
                            "Nobody is left for the interrupt '" + open.subject + "': " + who);
                } else {
                    askAgain(open, new Question.ChooseProxies(left, choice.min(), choice.max()), who);
                }
            }
        }
    }

    /** Tokens left places of a mission: a filter that keeps nobody who is there any longer is given up. */
    void left(MissionState m) {
        for (OpenDecision open : step.state.decisionsOf(m)) {
            if (filtered(open) && open.decision.question() instanceof Question.ChooseProxies choice) {
                List<String> all = questions.all(open, Set.of());
                List<String> left =
                        choice.proxies().stream().filter(all::contains).toList();
                if (left.size() < choice.proxies().size() && tooFew(left, choice) && all.size() > left.size()) {
                    askAll(
                            open,
                            all,
                            choice.proxies().stream()
                                    .filter(robot -> !left.contains(robot))
                                    .map(robot -> "'" + robot + "' has left")
                                    .collect(Collectors.joining(", ")));
                }
            }
        }
    }

    private static boolean filtered(OpenDecision open) {
        return open.purpose == OpenDecision.Purpose.ACTIVATION
                && !open.activation().output.filters.isEmpty();
    }

    private static boolean tooFew(List<String> left, Question.ChooseProxies choice) {
        return left.size() < Math.max(1, choice.min());
    }

    private void askAll(OpenDecision open, List<String> all, String why) {
        Question.ChooseProxies choice = (Question.ChooseProxies) open.decision.question();
        askAgain(open, new Question.ChooseProxies(all, choice.min(), choice.max()), why);
        step.note(
                NoteKind.GONE,
                open.asker().id,
                "The filter of '" + open.decision.prompt() + "' leaves too few (" + why + "): all are offered again");
    }

    private void askAgain(OpenDecision open, Question.ChooseProxies question, String why) {
        Decision before = open.decision;
        OptionalLong deadline = open.deadline == null ? OptionalLong.empty() : before.deadlineMillis();
        asked.close(open);
        Decision decision = new Decision(
                ++step.state.lastDecision,
                before.mission(),
                before.activation(),
                before.type(),
                before.prompt(),
                question,
                open.sent == null ? Optional.empty() : Questions.automatic(open.sent.output, question),
                deadline,
                before.priority(),
                before.markups());
        OpenDecision again =
                new OpenDecision(decision, open.purpose, open.mission, open.sent, open.instance, open.subject);
        if (open.sent != null) {
            open.sent.decision = decision.id();
        }
        asked.add(again);
        deadline.ifPresent(at -> again.deadline = timers.deadline(again, at - step.state.now));
        if (question.proxies().isEmpty()) {
            step.note(
                    NoteKind.NAMES_NOBODY,
                    open.asker().id,
                    "Nobody is left to choose for '" + before.prompt() + "': " + why);
        } else if (open.sent != null
                && open.sent.output.trigger == CompiledOutput.Trigger.IMMEDIATELY
                && decision.automatic().isPresent()) {
            step.post(() -> autonomy.accept(again)); // it had not come to answer the one before
        }
    }
}
