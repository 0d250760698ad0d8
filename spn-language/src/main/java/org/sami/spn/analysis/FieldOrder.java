package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.analysis.KnownFields.Known;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditSequence;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;

/** Of two numbers of one event, one of which the domain wants above the other, it is: a low level is above the critical one. */
final class FieldOrder implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-NOT-ABOVE",
                "The lower level is passed first, so what the higher one is to warn of is never in time.",
                "Exchange the two values, or raise the upper one."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            boolean ordered = output.type().fields().stream()
                    .anyMatch(f -> f.limits().above().isPresent());
            if (ordered) {
                List<Known> known = KnownFields.of(plan, output);
                known.forEach(upper -> upper.field()
                        .limits()
                        .above()
                        .flatMap(below -> known.stream()
                                .filter(k -> k.field().name().equals(below))
                                .findFirst())
                        .ifPresent(lower -> check(upper, lower, report)));
            }
        }
    }

    private static void check(Known upper, Known lower, Consumer<Finding> report) {
        Optional<Double> high = upper.number();
        Optional<Double> low = lower.number();
        if (high.isEmpty() || low.isEmpty() || high.get() > low.get()) {
            return;
        }
        Finding finding = Finding.warning(
                "W-NOT-ABOVE",
                upper.pointer(),
                upper.name() + " is " + upper.inWords(high.get()) + ", which is not above "
                        + lower.field().name() + ", " + lower.inWords(low.get()) + ": give a greater "
                        + upper.field().name() + " or a smaller "
                        + lower.field().name(),
                upper.vertex(),
                upper.event());
        Optional<Edit> raise = upper.rewriting().apply(lower.value());
        Optional<Edit> drop = lower.rewriting().apply(upper.value());
        boolean exchange = raise.isPresent() && drop.isPresent() && high.get() < low.get();
        report.accept(
                exchange
                        ? finding.fixedBy(
                                "Exchange them",
                                new EditSequence("Exchange two values", List.of(raise.get(), drop.get())))
                        : finding);
    }
}
