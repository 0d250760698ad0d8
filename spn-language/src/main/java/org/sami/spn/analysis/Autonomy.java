package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.edit.EventEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Reserved;

/** Where autonomy is to answer it can, and knows when (markup Mixed Initiative Trigger, appendix .2.3). */
final class Autonomy implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "E-NO-TIMEOUT",
                        "Without a time autonomy never answers, and nobody knows when the operator has to.",
                        "Give the time in seconds, or let the operator alone answer."),
                new Advice(
                        "E-DRAWN-BY-AUTONOMY",
                        "Nobody can make up what is to be drawn on the map: the mission would wait for an answer that"
                                + " never comes.",
                        "Let the operator alone answer."),
                new Advice(
                        "W-NO-AUTOMATIC-ANSWER",
                        "When the time is over nothing happens: the mission waits for the operator all the same.",
                        "Let the operator alone answer, or ask for something that autonomy can choose."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (PlacedOutput output : plan.outputs()) {
            for (MarkupSpec markup : output.spec().markups()) {
                if (markup.type().equals(Reserved.MIXED_INITIATIVE_TRIGGER)) {
                    check(plan, output, markup, report);
                }
            }
        }
    }

    private static void check(PlanContext plan, PlacedOutput output, MarkupSpec markup, Consumer<Finding> report) {
        Optional<Value> trigger = markup.option(Reserved.TRIGGER);
        String constant = trigger.isPresent() && trigger.get() instanceof EnumValue e ? e.constant() : Reserved.NEVER;
        if (constant.equals(Reserved.TIMER) && markup.option(Reserved.TIMEOUT).isEmpty()) {
            report.accept(Finding.error(
                            "E-NO-TIMEOUT",
                            output.pointer(),
                            plan.name(output) + " lets autonomy answer after a time, but does not say after which",
                            output.place().id(),
                            output.spec().id())
                    .fixedBy(
                            "Let the operator alone answer",
                            new EventEdit.RemoveMarkup(
                                    plan.plan().id(), output.spec().id(), markup.type())));
        }
        if (!constant.equals(Reserved.NEVER) && !canAnswer(output)) {
            String where = plan.name(output);
            Finding finding = isDrawing(output)
                    ? Finding.error(
                            "E-DRAWN-BY-AUTONOMY",
                            output.pointer(),
                            "Autonomy cannot draw what " + where + " asks for: the operator must answer",
                            output.place().id(),
                            output.spec().id())
                    : Finding.warning(
                            "W-NO-AUTOMATIC-ANSWER",
                            output.pointer(),
                            "Autonomy has no answer to " + where + ": the operator must answer",
                            output.place().id(),
                            output.spec().id());
            report.accept(finding.fixedBy(
                    "Let the operator alone answer",
                    new EventEdit.RemoveMarkup(plan.plan().id(), output.spec().id(), markup.type())));
        }
    }

    private static boolean canAnswer(PlacedOutput output) {
        Optional<DecisionType> decision = output.type().decision();
        return decision.isPresent()
                && decision.get().autonomy() != AutonomyAnswer.NONE
                && !(decision.get().autonomy() == AutonomyAnswer.ALL && selectsNobody(output));
    }

    /** Whether values are asked for that nobody can make up (R-DEC-2). */
    private static boolean isDrawing(PlacedOutput output) {
        return output.type()
                .decision()
                .filter(decision ->
                        decision.form() == DecisionForm.PROVIDE && decision.autonomy() == AutonomyAnswer.NONE)
                .isPresent();
    }

    private static boolean selectsNobody(PlacedOutput output) {
        return output.spec().markups().stream()
                .filter(markup -> markup.type().equals(Reserved.DEFAULT_SELECTION))
                .flatMap(markup -> markup.option(Reserved.SELECTION).stream())
                .anyMatch(value -> value instanceof EnumValue e && e.constant().equals(Reserved.NONE));
    }
}
