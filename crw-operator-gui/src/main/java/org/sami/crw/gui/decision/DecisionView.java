package org.sami.crw.gui.decision;

import java.util.List;
import java.util.Optional;
import javax.swing.JComponent;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.Interactions;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.ui.value.ChoiceRow;
import org.sami.ui.value.OfferedRow;
import org.sami.ui.value.QuestionEditor;
import org.sami.ui.value.ValueEditors;

/** One decision with what the operator has filled in of it; it is kept while the decision waits, so that browsing loses nothing. */
final class DecisionView {
    private static final String NAME = "decision";

    private final DecisionPresentation decision;
    private final QuestionEditor editor;
    private final boolean refusable;

    DecisionView(
            DecisionPresentation decision,
            Interactions interactions,
            ComponentChoice choice,
            ValueEditors editors,
            DecisionActions actions) {
        this.decision = decision;
        ChosenComponent chosen = interactions
                .of(decision.decision())
                .map(choice::choose)
                .orElse(new ChosenComponent.Warning("This decision asks for nothing: answer it"));
        List<OfferedRow> offered = decision.options().stream()
                .map(option -> new OfferedRow(
                        option.index(),
                        new ChoiceRow(option.value(), option.label(), option.detail()),
                        option.selected()))
                .toList();
        editor = new QuestionEditor(NAME, decision.question(), offered, chosen, editors);
        refusable = decision.question() instanceof Question.ChooseOption
                && actions.check(decision.id(), new Answer.Rejected()).isEmpty();
    }

    DecisionPresentation decision() {
        return decision;
    }

    QuestionEditor editor() {
        return editor;
    }

    JComponent component() {
        return editor.component();
    }

    /** Whether "none of these" is an answer. */
    boolean refusable() {
        return refusable;
    }

    /** Why what is filled in is no answer that would be accepted; empty where it is. */
    Optional<String> whyNot(DecisionActions actions) {
        Optional<Answer> answer = editor.answer();
        return answer.isEmpty()
                ? editor.reason().or(() -> Optional.of("Nothing is chosen yet"))
                : actions.check(decision.id(), answer.get());
    }
}
