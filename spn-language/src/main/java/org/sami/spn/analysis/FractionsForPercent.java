package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.edit.Edit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.RealValue;

/** What is given in percent is no fraction of 1. */
final class FractionsForPercent implements PlanCheck {
    private static final String PERCENT = "%";

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-FRACTION",
                "The value is read as percent: a level of 0.3 is nearly an empty battery.",
                "Write percent: 30 in place of 0.3."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (KnownFields.Known known : plan.known().all()) {
            if (known.field().unit().equals(PERCENT)) {
                known.number()
                        .filter(number -> number > 0 && number < 1)
                        .ifPresent(number -> report(known, number, report));
            }
        }
    }

    private static void report(KnownFields.Known known, double number, Consumer<Finding> report) {
        double percent = Math.round(number * 1e6) / 1e4;
        Finding finding = Finding.warning(
                "W-FRACTION",
                known.pointer(),
                known.name() + " is " + known.inWords(number) + "; a fraction of 1 is written in percent: is "
                        + known.inWords(percent) + " meant?",
                known.vertex(),
                known.event());
        Optional<Edit> edit = known.rewriting().apply(new RealValue(percent));
        report.accept(edit.map(e -> finding.fixedBy("Write " + known.inWords(percent), e))
                .orElse(finding));
    }
}
