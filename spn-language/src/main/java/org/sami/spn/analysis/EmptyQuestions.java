package org.sami.spn.analysis;

import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.vocabulary.Reserved;

/** Questions and messages to the operator are not empty: no text is blank, and no list of requested values is empty. */
final class EmptyQuestions implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-EMPTY-QUESTION",
                "The operator gets a dialog or button without words and cannot know what is asked.",
                "Write the question, message or name."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (KnownFields.Known known : plan.known().all()) {
            String field = known.field().name();
            boolean question = field.equals(Reserved.QUESTION);
            boolean blank =
                    known.value() instanceof TextValue text && text.value().isBlank();
            boolean none = field.equals(Reserved.VARIABLES)
                    && known.value() instanceof ListValue list
                    && list.items().isEmpty();
            if (none || (blank && (question || known.field().required()))) {
                Finding finding = Finding.warning(
                        "W-EMPTY-QUESTION",
                        known.pointer(),
                        known.name() + " is empty: " + (none ? "name what is asked for" : "write what people read"),
                        known.vertex(),
                        known.event());
                report.accept(
                        question && !known.field().required()
                                ? finding.fixedBy(
                                        "Ask the usual question",
                                        new FieldEdit.ClearField(plan.plan().id(), known.event(), field))
                                : finding);
            }
        }
    }
}
