package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.FieldLimits;

/** A number that handlers accept and that the domain does not think usual, such as a timer of 0 s, is probably a mistake. */
final class UnusualValues implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-UNUSUAL-VALUE",
                "The number is accepted but far from what missions use: probably a slip of the pen or a wrong"
                        + " unit.",
                "Check the unit and the number; if it is meant so, the warning may stay."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (KnownFields.Known known : plan.known().all()) {
            FieldLimits limits = known.field().limits();
            known.number()
                    .filter(number ->
                            limits.range().contains(number) && !limits.usual().contains(number))
                    .ifPresent(number -> report.accept(Finding.warning(
                            "W-UNUSUAL-VALUE",
                            known.pointer(),
                            known.name() + " is " + known.inWords(number) + "; usual is "
                                    + known.inWords(limits.usual().least()) + " to "
                                    + known.inWords(limits.usual().most()) + ": is it right?",
                            known.vertex(),
                            known.event())));
        }
    }
}
