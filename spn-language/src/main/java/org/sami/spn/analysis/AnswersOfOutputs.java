package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;

/** What a place asks for, a transition after it waits for (thesis 4.3.3, Events). */
final class AnswersOfOutputs implements PlanCheck {
    private static final Set<EventRole> ANSWERED_BY_THE_MISSION =
            Set.of(EventRole.ABORT_MISSION, EventRole.COMPLETE_MISSION);

    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "W-UNANSWERED",
                        "The answer comes and moves nobody: the tokens stay in the place and the mission does not go "
                                + "on.",
                        "Draw a transition after the place that waits for the answer."),
                new Advice(
                        "W-ANSWER-IGNORED",
                        "If the operator gives the answer that nobody waits for, the tokens stay in the place and the"
                                + " mission hangs.",
                        "Draw a transition after the place that waits for the other answer too."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            if (output.type().answers().isEmpty()
                    || output.type().flags().contains(EventFlag.ANSWER_OPTIONAL)
                    || output.place().end()
                    || ANSWERED_BY_THE_MISSION.contains(output.type().role())) {
                continue;
            }
            Set<String> awaited = plan.awaitedAfter(output.place());
            if (output.type().answers().stream().noneMatch(awaited::contains)) {
                report.accept(Finding.warning(
                        "W-UNANSWERED",
                        output.pointer(),
                        "The " + plan.name(output.place()) + " asks for "
                                + output.type().title() + ", but no transition after it waits for "
                                + plan.titles(output.type().answers()),
                        output.place().id(),
                        output.spec().id()));
            } else {
                output.type().decision().ifPresent(d -> checkBothAnswers(plan, output, d, awaited, report));
            }
        }
    }

    private static void checkBothAnswers(
            PlanContext plan,
            PlacedOutput output,
            DecisionType decision,
            Set<String> awaited,
            Consumer<Finding> report) {
        for (String answer : List.of(decision.accepted(), decision.rejected())) {
            if (!answer.isEmpty() && !awaited.contains(answer)) {
                report.accept(Finding.warning(
                        "W-ANSWER-IGNORED",
                        output.pointer(),
                        "When the operator answers " + plan.vocabulary().title(answer) + " at the "
                                + plan.name(output.place())
                                + ", nothing happens: no transition after it waits for that",
                        output.place().id(),
                        output.spec().id()));
            }
        }
    }
}
