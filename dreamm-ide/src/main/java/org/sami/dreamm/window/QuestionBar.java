package org.sami.dreamm.window;

import java.awt.KeyboardFocusManager;
import java.awt.event.ActionEvent;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.KeyStroke;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.context.AuthorQuestion;
import org.sami.dreamm.context.Questions;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;

/** The bar at the top of the window in which the author is asked something. Escape leaves it; it is gone while nothing is asked. */
final class QuestionBar extends JPanel {
    private final transient Questions questions;
    private final JLabel text = new JLabel();
    private transient Optional<AuthorQuestion> shown = Optional.empty();

    QuestionBar(Questions questions) {
        super(new MigLayout("insets 8 12 8 12, gap 8", "[grow, fill][]", "[]"));
        this.questions = questions;
        setName("question-bar");
        text.setName("question");
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), "dismiss");
        getActionMap().put("dismiss", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                questions.current().ifPresent(questions::dismiss);
            }
        });
        questions.addListener(this::showCurrent);
        showCurrent();
    }

    private void showCurrent() {
        Optional<AuthorQuestion> now = questions.current();
        boolean takesFocus = now.isPresent()
                && (isAncestorOf(KeyboardFocusManager.getCurrentKeyboardFocusManager()
                                .getFocusOwner())
                        || (!now.equals(shown) && questions.takesFocus(now.get())));
        shown = now;
        removeAll();
        questions.current().ifPresent(this::fill);
        setVisible(questions.current().isPresent());
        style();
        revalidate();
        repaint();
        if (takesFocus && getComponentCount() > 1) {
            getComponent(1).requestFocusInWindow();
        }
    }

    private void fill(AuthorQuestion question) {
        String more = questions.waiting() == 0 ? "" : " (" + questions.waiting() + " more)";
        text.setText(question.text() + more);
        text.setToolTipText(question.text());
        add(text, "wmin 0");
        for (AuthorQuestion.Choice choice : question.choices()) {
            JButton button = new JButton(choice.label());
            button.setName(choice.id());
            button.addActionListener(e -> questions.answer(question, choice));
            button.getInputMap().put(KeyStroke.getKeyStroke("ENTER"), "pressed");
            button.getInputMap().put(KeyStroke.getKeyStroke("released ENTER"), "released");
            add(button, "h 32!");
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (text != null) {
            text.updateUI();
            style();
        }
    }

    private void style() {
        LookColors.background(this, SemanticColor.WARNING_FILL);
        LookColors.border(this, () -> BorderFactory.createMatteBorder(0, 0, 1, 0, SemanticColor.BORDER.get()));
        text.setFont(Fonts.strong());
        LookColors.foreground(text, SemanticColor.ON_WARNING);
    }
}
