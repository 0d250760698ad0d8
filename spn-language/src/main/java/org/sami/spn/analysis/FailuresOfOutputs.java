package org.sami.spn.analysis;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventType;

/**
 * Where a plan waits for an answer, it also waits for the failure: else the tokens stay in the place for good and the
 * mission hangs. Which input events say so the vocabulary declares ({@link EventFlag#FAILURE}). A failure that also comes as news
 * may be waited for anywhere in the plan, or in one that runs it. Where no answer at all is awaited, {@link AnswersOfOutputs} says so.
 */
final class FailuresOfOutputs implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-FAILURE-IGNORED",
                "When the command fails its robot stays in the place: nothing moves it on and the mission " + "hangs.",
                "Draw a transition after the place that waits for the failure, and lead it to what is to be "
                        + "done then."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            Set<String> awaited = plan.awaitedAfter(output.place());
            if (output.place().end() || output.type().answers().stream().noneMatch(awaited::contains)) {
                continue;
            }
            failures(plan, output.type())
                    .filter(failure -> !awaited.contains(failure.name()) && !awaitedElsewhere(plan, failure))
                    .forEach(failure -> report.accept(Finding.warning(
                            "W-FAILURE-IGNORED",
                            output.pointer(),
                            "When " + plan.name(output)
                                    + " ends with " + failure.title()
                                    + ", nothing happens: no transition after it waits"
                                    + " for that, and the mission may hang. Draw what is to be done then",
                            output.place().id(),
                            output.spec().id())));
        }
    }

    private static Stream<EventType> failures(PlanContext plan, EventType output) {
        return output.answers().stream()
                .flatMap(answer -> plan.vocabulary().event(answer).stream())
                .filter(answer -> answer.flags().contains(EventFlag.FAILURE));
    }

    private static boolean awaitedElsewhere(PlanContext plan, EventType failure) {
        if (!failure.flags().contains(EventFlag.NEWS)) {
            return false;
        }
        Set<String> names = new HashSet<>(failure.aliases());
        names.add(failure.name());
        return Stream.concat(Stream.of(plan.plan()), plan.parents().stream())
                .map(Plan::transitions)
                .flatMap(List::stream)
                .flatMap(t -> t.inputs().stream())
                .map(InputEventSpec::type)
                .anyMatch(names::contains);
    }
}
