package org.sami.dreamm.learn.view;

import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.ButtonGroup;
import javax.swing.JCheckBox;
import javax.swing.JPanel;
import javax.swing.JRadioButton;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;
import org.sami.dreamm.learn.QuizModel;
import org.sami.lessons.course.QuizQuestion;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.WrappedText;

/** The choices of a quiz, in the order that was drawn: a click anywhere in a row, or its digit, chooses it. */
final class ChoicesView extends JPanel {
    private final transient QuizModel quiz;
    private final transient Runnable changed;
    private final transient List<Row> rows = new ArrayList<>();

    /** A choice as it is shown. */
    private record Row(int index, JToggleButton button, JPanel panel) {}

    ChoicesView(QuizModel quiz, Runnable changed) {
        super(new ColumnLayout(Spacing.TIGHT));
        this.quiz = quiz;
        this.changed = changed;
        setOpaque(false);
        setName("learn-choices");
        boolean single = quiz.quiz().ask() instanceof QuizQuestion.One;
        ButtonGroup group = new ButtonGroup();
        for (int shown = 0; shown < quiz.order().size(); shown++) {
            int index = quiz.order().get(shown);
            String text = quiz.choice(index).text();
            JToggleButton button = single ? new JRadioButton() : new JCheckBox();
            button.setName("learn-choice-" + (shown + 1));
            button.setOpaque(false);
            button.getAccessibleContext().setAccessibleName(text);
            button.setToolTipText("Choose with the key " + (shown + 1));
            button.addActionListener(e -> choose(index));
            if (single) {
                group.add(button);
            }
            Row row = new Row(index, button, row(button, text));
            rows.add(row);
            add(row.panel());
            digit(shown + 1, button);
        }
        refresh();
    }

    private JPanel row(JToggleButton button, String text) {
        JPanel row = new JPanel(new LeadLayout(Spacing.TIGHT));
        row.setOpaque(false);
        WrappedText words = new WrappedText(text);
        MouseAdapter click = new MouseAdapter() {
            @Override
            public void mousePressed(MouseEvent e) {
                if (button.isEnabled()) {
                    button.requestFocusInWindow();
                    button.doClick(0);
                }
            }
        };
        row.addMouseListener(click);
        words.addMouseListener(click);
        row.add(button);
        row.add(words);
        return row;
    }

    private void digit(int digit, JToggleButton button) {
        String id = "choose-" + digit;
        for (String stroke : List.of("" + digit, "NUMPAD" + digit)) {
            getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke(stroke), id);
        }
        getActionMap().put(id, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                if (button.isEnabled()) {
                    button.requestFocusInWindow();
                    button.doClick(0);
                }
            }
        });
    }

    private void choose(int index) {
        boolean chosen = quiz.chosen().contains(index);
        boolean wanted = rows.stream()
                .anyMatch(row -> row.index() == index && row.button().isSelected());
        if (chosen != wanted) {
            quiz.choose(index);
            changed.run();
        }
    }

    /** Shows what is chosen; once the right answer is known, which choices are right. */
    void refresh() {
        for (Row row : rows) {
            row.button().setSelected(quiz.chosen().contains(row.index()));
            row.button().setEnabled(!quiz.isClosed());
            boolean right = quiz.isClosed() && quiz.choice(row.index()).right();
            LookColors.border(
                    row.panel(),
                    () -> BorderFactory.createCompoundBorder(
                            BorderFactory.createLineBorder(
                                    (right ? SemanticColor.OK : SemanticColor.BORDER).get(), Look.px(right ? 2 : 1)),
                            BorderFactory.createEmptyBorder(
                                    Look.px(right ? 3 : 4),
                                    Look.px(right ? 5 : 6),
                                    Look.px(right ? 3 : 4),
                                    Look.px(6))));
        }
    }
}
