package org.sami.crw.gui.decision;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JComponent;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.decision.OfferedOption;
import org.sami.crw.gui.value.JudgedDraft;
import org.sami.session.api.DraftAnswer;
import org.sami.spn.component.ChosenComponent;
import org.sami.spn.component.ComponentChoice;
import org.sami.spn.component.Interactions;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.Value;
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
    private final JudgedDraft judged;
    private String refusal = "";

    /**
     * A decision with nothing filled in but what it proposes.
     *
     * @param rejudged is called when the judgement of the entries changes
     */
    DecisionView(
            DecisionPresentation decision,
            Interactions interactions,
            ComponentChoice choice,
            ValueEditors editors,
            DecisionActions actions,
            Consumer<DecisionView> rejudged) {
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
        boolean offersNone = decision.question() instanceof Question.ChooseOption
                || decision.decision().isInterruptChoice(); // none withdraws the press
        refusable = offersNone
                && actions.check(decision.id(), new Answer.Rejected()).isEmpty();
        judged = new JudgedDraft(
                this::draft, draft -> actions.judge(decision.decision(), draft), () -> rejudged.accept(this));
    }

    /** Why the last answer to it was refused; empty text where it was not, or something else is filled in since. */
    String refusal() {
        return refusal;
    }

    /** The last answer to it was refused with this reason; empty text where it was not. */
    void refused(String why) {
        refusal = why;
    }

    private DraftAnswer draft() {
        Question question = decision.question();
        if (question instanceof Question.ChooseProxies) {
            return new DraftAnswer(Map.of(), chosenBoats(), Optional.empty());
        } else if (question instanceof Question.ChooseOption) {
            return new DraftAnswer(Map.of(), List.of(), editor.chosen().stream().findFirst());
        }
        return DraftAnswer.of(editor.given());
    }

    private List<String> chosenBoats() {
        return boats(editor.chosen());
    }

    private static List<String> boats(List<Value> values) {
        return values.stream()
                .filter(ProxyValue.class::isInstance)
                .map(value -> ((ProxyValue) value).proxy())
                .toList();
    }

    /** The judgement of the entries. */
    JudgedDraft judged() {
        return judged;
    }

    /** The boats that are chosen for the answer; empty where it is about something else. */
    Optional<BoatPick> pick() {
        return decision.question() instanceof Question.ChooseProxies ? Optional.of(new Pick()) : Optional.empty();
    }

    private final class Pick implements BoatPick {
        @Override
        public List<String> offered() {
            return boats(decision.options().stream().map(OfferedOption::value).toList());
        }

        @Override
        public List<String> chosen() {
            return chosenBoats();
        }

        @Override
        public void toggle(String boat) {
            editor.toggle(new ProxyValue(boat));
        }

        @Override
        public void only(List<String> boats) {
            editor.chooseOnly(boats.stream().map(ProxyValue::new).toList());
        }
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
                : actions.check(decision.id(), answer.get())
                        .or(() -> judged.isCurrent() ? judged.judgement().refusal() : Optional.empty());
    }
}
