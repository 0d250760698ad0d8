package org.sami.spn.analysis;

import java.util.function.Consumer;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.FieldLimits;

/** A number that handlers accept and that the domain does not think usual, such as a timer of 0 s, is probably a mistake. */
final class UnusualValues implements PlanCheck {
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
