package org.sami.dreamm.learn.view;

import java.util.LinkedHashSet;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.learn.QuizModel;
import org.sami.lessons.course.QuizQuestion;
import org.sami.palette.ProxyMarks;
import org.sami.palette.SemanticColor;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Token;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.TextChanges;
import org.sami.ui.value.WrappedText;

/** What a learner answers a quiz with: choices, the drawn net, tokens, or a field for a number. */
final class QuizView extends JPanel {
    private static final int DIGITS = 9;

    private final transient QuizModel quiz;
    private final transient Runnable changed;
    private final transient Optional<PictureView> picture;
    private transient Optional<ChoicesView> choices = Optional.empty();
    private transient Optional<TokenButtons> tokens = Optional.empty();
    private transient Optional<JTextField> number = Optional.empty();

    /**
     * A view of a quiz.
     *
     * @param drawn the picture of the step, with the plan that it draws
     * @param changed is run when something else is chosen
     */
    QuizView(QuizModel quiz, Optional<Drawn> drawn, ProxyMarks marks, Runnable changed) {
        super(new ColumnLayout(Spacing.NORMAL));
        this.quiz = quiz;
        this.changed = changed;
        picture = drawn.map(Drawn::view);
        setOpaque(false);
        setName("learn-quiz");
        QuizQuestion ask = quiz.quiz().ask();
        if (ask instanceof QuizQuestion.One || ask instanceof QuizQuestion.Several) {
            if (ask instanceof QuizQuestion.Several) {
                hint("Choose all that are right.");
            }
            choices = Optional.of(new ChoicesView(quiz, changed));
            choices.ifPresent(this::add);
        } else if (ask instanceof QuizQuestion.Mark mark) {
            hint("Click in the net, or go by the arrow keys and mark with Space.");
            drawn.ifPresent(there -> there.view().setPickable(elements(there.plan(), mark.of()), this::mark));
        } else if (ask instanceof QuizQuestion.Tokens asked) {
            hint(
                    sentence(asked.after())
                            + " Where do tokens stand then? Choose a place by a click or the arrow keys, and put tokens there.");
            drawn.ifPresent(there -> tokens(there, marks));
        } else if (ask instanceof QuizQuestion.Amount amount) {
            number(amount);
        }
        refresh();
    }

    /** A picture and the plan that it draws. */
    record Drawn(PictureView view, Plan plan) {}

    private static String sentence(String words) {
        String first = words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
        return first.endsWith(".") ? first : first + ".";
    }

    private void hint(String words) {
        WrappedText text = new WrappedText(words);
        text.setColor(SemanticColor.MUTED);
        text.setName("learn-quiz-hint");
        add(text);
    }

    private static Set<String> elements(Plan plan, QuizQuestion.Kind kind) {
        Set<String> ids = new LinkedHashSet<>();
        boolean all = kind == QuizQuestion.Kind.ELEMENTS;
        if (all || kind == QuizQuestion.Kind.PLACES) {
            plan.places().forEach(place -> ids.add(place.id()));
        }
        if (all || kind == QuizQuestion.Kind.TRANSITIONS) {
            plan.transitions().forEach(transition -> ids.add(transition.id()));
        }
        if (kind == QuizQuestion.Kind.EDGES || all) {
            plan.inEdges().forEach(edge -> ids.add(edge.id()));
            plan.outEdges().forEach(edge -> ids.add(edge.id()));
        }
        return ids;
    }

    private void mark(String id) {
        quiz.mark(id);
        changed.run();
    }

    private void tokens(Drawn drawn, ProxyMarks marks) {
        PictureView view = drawn.view();
        view.setPickable(elements(drawn.plan(), QuizQuestion.Kind.PLACES), place -> {});
        var kinds = quiz.tokenKinds();
        for (int i = 0; i < Math.min(DIGITS, kinds.size()); i++) {
            Token token = kinds.get(i);
            view.addKey("" + (i + 1), place -> put(place, token));
            view.addKey("NUMPAD" + (i + 1), place -> put(place, token));
        }
        view.addKey("DELETE", this::clear);
        view.addKey("BACK_SPACE", this::clear);
        TokenButtons buttons =
                new TokenButtons(kinds, marks, token -> put(view.cursor(), token), () -> clear(view.cursor()));
        tokens = Optional.of(buttons);
        view.setCursorAlways(true);
        add(buttons);
    }

    private void put(String place, Token token) {
        quiz.put(place, token);
        changed.run();
    }

    private void clear(String place) {
        quiz.clear(place);
        changed.run();
    }

    private void number(QuizQuestion.Amount amount) {
        JPanel row = new JPanel(new MigLayout("insets 0, gap " + Spacing.NORMAL));
        row.setOpaque(false);
        JTextField field = new JTextField(quiz.number(), 6);
        field.setName("learn-number");
        field.getAccessibleContext().setAccessibleName("Your number");
        field.getDocument().addDocumentListener(new TextChanges(() -> {
            if (!field.getText().equals(quiz.number())) {
                quiz.setNumber(field.getText());
                changed.run();
            }
        }));
        number = Optional.of(field);
        row.add(field, "hmin " + Spacing.HIT_TARGET);
        JLabel unit = new JLabel(amount.unit());
        LookColors.foreground(unit, SemanticColor.MUTED);
        row.add(unit);
        add(row);
    }

    /** Shows what is chosen, and whether it can still be changed. */
    void refresh() {
        boolean open = !quiz.isClosed();
        choices.ifPresent(ChoicesView::refresh);
        tokens.ifPresent(buttons -> buttons.setUsable(open));
        number.ifPresent(field -> {
            field.setEditable(open);
            if (!open && !field.getText().equals(quiz.number())) {
                field.setText(quiz.number());
            }
        });
        picture.ifPresent(view -> {
            if (quiz.quiz().ask() instanceof QuizQuestion.Mark) {
                view.setSelected(quiz.marks());
                view.setEnabled(open);
            } else if (quiz.quiz().ask() instanceof QuizQuestion.Tokens) {
                view.setMarking(quiz.tokens().marking());
                view.setEnabled(open);
            }
        });
    }
}
