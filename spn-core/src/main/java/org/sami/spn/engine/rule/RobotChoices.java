package org.sami.spn.engine.rule;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.Set;
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
    private final Rules rules;
    private final Questions questions;

    RobotChoices(Rules rules, Questions questions) {
        this.rules = rules;
        this.questions = questions;
    }

    /**
     * Robots have gone: choices that offer them are asked again without them, in the order in which they were asked.
     *
     * @param gone by mission, the robots that its choices must no longer offer
     * @param how what became of them, as the end of a sentence: {@code dropped}
     */
    void gone(Map<MissionState, Set<String>> gone, String how) {
        for (OpenDecision open : List.copyOf(rules.state.decisions.values())) {
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
                    rules.decisions.close(open);
                    rules.note(
                            NoteKind.INTERRUPT_REFUSED,
                            open.mission.id,
                            "Nobody is left for the interrupt '" + open.subject + "': " + who);
                } else {
                    askAgain(open, new Question.ChooseProxies(left, choice.min(), choice.max()), who);
                }
            }
        }
    }

    /** Tokens left places of a mission: a filter that keeps nobody who is there any longer is given up. */
    void left(MissionState m) {
        for (OpenDecision open : List.copyOf(m.decisions.values())) {
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
        return open.purpose == OpenDecision.Purpose.ACTIVATION && !open.sent.output.filters.isEmpty();
    }

    private static boolean tooFew(List<String> left, Question.ChooseProxies choice) {
        return left.size() < Math.max(1, choice.min());
    }

    private void askAll(OpenDecision open, List<String> all, String why) {
        Question.ChooseProxies choice = (Question.ChooseProxies) open.decision.question();
        askAgain(open, new Question.ChooseProxies(all, choice.min(), choice.max()), why);
        rules.note(
                NoteKind.GONE,
                open.mission.id,
                "The filter of '" + open.decision.prompt() + "' leaves too few (" + why + "): all are offered again");
    }

    private void askAgain(OpenDecision open, Question.ChooseProxies question, String why) {
        Decision before = open.decision;
        OptionalLong deadline = open.deadline == null ? OptionalLong.empty() : before.deadlineMillis();
        rules.decisions.close(open);
        Decision decision = new Decision(
                ++rules.state.lastDecision,
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
            open.sent.decision = again;
        }
        rules.decisions.add(again);
        deadline.ifPresent(at -> again.deadline = rules.timers.deadline(again, at - rules.state.now));
        if (question.proxies().isEmpty()) {
            rules.note(
                    NoteKind.NAMES_NOBODY,
                    open.mission.id,
                    "Nobody is left to choose for '" + before.prompt() + "': " + why);
        } else if (open.sent != null
                && open.sent.output.trigger == CompiledOutput.Trigger.IMMEDIATELY
                && decision.automatic().isPresent()) {
            rules.post(() -> rules.decisions.byAutonomy(again)); // it had not come to answer the one before
        }
    }
}
