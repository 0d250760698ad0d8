package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.vocabulary.FieldLimits.Range;

/** A number that is known before the run is one that the domain's handlers accept. */
final class OutOfRange implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "E-OUT-OF-RANGE",
                "The handler of the event refuses the number: the command fails whenever it is given.",
                "Write a number within the range that the message names."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (KnownFields.Known known : plan.known().all()) {
            Range range = known.field().limits().range();
            known.number()
                    .filter(number -> !range.contains(number))
                    .ifPresent(number -> report.accept(Finding.error(
                            "E-OUT-OF-RANGE",
                            known.pointer(),
                            known.name() + " is " + known.inWords(number) + ": give " + known.inWords(range.least())
                                    + " to " + known.inWords(range.most()),
                            known.vertex(),
                            known.event())));
        }
    }
}
