package org.sami.crw.gui.decision;

import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.value.WrappedText;

/**
 * What is done with the shown decision: its answer, why there is none yet, and the way to other decisions. In a narrow panel the reason
 * stands above the buttons, in a low one it is a line. On the event thread.
 */
final class AnswerBar extends JPanel {
    private static final int NARROW = 440;
    private static final int WIDE = 600;
    private static final String LAYOUT = "novisualpadding, insets 0, gap 8, fillx, hidemode 3";
    private static final String IN_ROW = "split 2, wmin 80";
    private static final String LINE_IN_ROW = "wmin 0";
    private static final String LINE_ABOVE = "dock north, wmin 0";
    private static final String ABOVE = "dock north, wmin 80, gapbottom 4";

    private final transient MigLayout layout = new MigLayout(LAYOUT, "[][][][grow,fill][][][]", "[center]");
    private final CommandButton answer;
    private final CommandButton refuse;
    private final CommandButton draw;
    private final CommandButton earlier;
    private final CommandButton later;
    private final WrappedText problem = new WrappedText("");
    private final JLabel problemLine = new JLabel(); // the same in a low panel; its tooltip has all of it
    private final JLabel position = new JLabel(" ");
    private boolean narrow;
    private boolean others;

    AnswerBar(DecisionCommands commands) {
        setLayout(layout);
        answer = CommandButton.primary(commands.answer(), "check");
        refuse = new CommandButton(commands.refuse());
        draw = new CommandButton(commands.draw());
        earlier = CommandButton.iconOnly(commands.earlier());
        later = CommandButton.iconOnly(commands.later());
        setOpaque(false);
        problem.setName("decision-problem");
        problem.setColor(SemanticColor.MUTED);
        problemLine.setName("decision-problem-line");
        position.setName("decision-position");
        add(answer);
        add(refuse);
        add(draw);
        add(problem, IN_ROW);
        add(problemLine, LINE_IN_ROW);
        add(position);
        add(earlier);
        add(later);
    }

    /**
     * Leaves out what there is no room for.
     *
     * @param width of the panel, in pixels
     * @param low whether the reason has one line only
     */
    void fit(int width, boolean low) {
        narrow = width < Look.px(NARROW);
        String place = narrow && !low ? ABOVE : IN_ROW;
        put(problem, place);
        problemLine.setFont(Fonts.small()); // of the scale in force
        put(problemLine, narrow ? LINE_ABOVE : LINE_IN_ROW);
        problem.setVisible(!low && !(narrow && problem.getText().isEmpty()));
        problemLine.setVisible(low && !(narrow && problemLine.getText().isEmpty()));
        position.setVisible(!narrow);
        draw.setHideActionText(width < Look.px(WIDE));
        showOthers();
    }

    private void put(JComponent part, String place) {
        if (!place.equals(layout.getComponentConstraints(part))) {
            layout.setComponentConstraints(part, place);
            invalidate();
        }
    }

    /** In a narrow panel the way to other decisions is there where there are others. */
    private void showOthers() {
        earlier.setVisible(!narrow || others);
        later.setVisible(!narrow || others);
    }

    /** Says which of the decisions that wait is shown; blank where there is one. */
    void showPosition(String text) {
        position.setText(text);
        others = !text.isBlank();
        showOthers();
    }

    /** Shows the answers that the decision takes besides the one that is filled in. */
    void offer(boolean none, boolean drawing) {
        refuse.setVisible(none);
        draw.setVisible(drawing);
    }

    /** Says why there is no answer yet, or why one was refused. */
    void tell(String text, boolean refused) {
        SemanticColor color = refused ? SemanticColor.CRITICAL : SemanticColor.MUTED;
        problem.setColor(color);
        LookColors.foreground(problemLine, color);
        if (!problem.getText().equals(text)) {
            problem.setText(text);
            problemLine.setText(text);
            problemLine.setToolTipText(text.isEmpty() ? null : text);
            revalidate();
        }
    }

    /** Brings the keyboard's focus to the answer, or to the drawing where there is no answer yet. */
    void focus() {
        (answer.isEnabled() ? answer : draw).requestFocusInWindow();
    }
}
