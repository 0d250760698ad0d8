package org.sami.spn.analysis;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.sami.spn.analysis.PlanContext.PlacedInput;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** Edits by which several checks mend what they find. */
final class Fixes {
    private Fixes() {}

    /** Lets the operator be asked for a field when the mission starts. */
    static Finding asking(PlanContext plan, String event, String field, Finding finding) {
        return finding.fixedBy(
                "Ask for " + field + " at the start",
                new FieldEdit.SetField(plan.plan().id(), event, field, new FieldSource.Asked(Optional.empty(), true)));
    }

    /**
     * Offers to remove an input event, where it writes no variable and no requirement of its transition would be left without one to name
     * its tokens.
     */
    static Finding removing(PlanContext plan, PlacedInput input, Finding finding) {
        Transition t = input.transition();
        boolean relevant = plan.inEdges(t).stream()
                        .flatMap(e -> e.requirements().stream())
                        .anyMatch(r -> r.kind() == TokenKind.RELEVANT)
                || plan.outEdges(t).stream()
                        .flatMap(e -> e.requirements().stream())
                        .anyMatch(r -> r.kind() == TokenKind.RELEVANT);
        boolean needed = relevant && t.inputs().size() == 1;
        return needed || !input.spec().writes().isEmpty()
                ? finding
                : finding.fixedBy(
                        "Do not wait for " + input.type().title(),
                        new RemoveElements(plan.plan().id(), Set.of(input.spec().id())));
    }

    /** A finding with an edit for each word that may have been meant. */
    static Finding meant(Finding finding, List<String> words, Function<String, Edit> edit) {
        Finding fixed = finding;
        for (String word : words) {
            fixed = fixed.fixedBy("Write " + word, edit.apply(word));
        }
        return fixed;
    }
}
