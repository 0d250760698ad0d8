package org.sami.crw.gui.decision;

import java.util.List;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.operator.decision.PendingDecision;
import org.sami.palette.SemanticColor;
import org.sami.spn.protocol.Priority;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.WrappedText;

/** The question, who asks it, since when, and what autonomy will answer and when; its timer can be stopped here. */
final class DecisionHeader extends JPanel {
    private final JLabel age = new JLabel(" ");
    private final JLabel asker = new JLabel(" ");
    private final WrappedText title = WrappedText.heading("");
    private final WrappedText description = new WrappedText("");
    private final JPanel autonomy =
            new JPanel(new MigLayout("novisualpadding, insets 6 8 6 8, gap 8, fillx", "[grow,fill][]"));
    private final WrappedText countdown = new WrappedText("");
    private final JButton stop;

    DecisionHeader(JButton stop) {
        super(new MigLayout("novisualpadding, insets 0, gap 4 4, fillx, hidemode 3, wrap 1", "[grow,fill]"));
        this.stop = stop;
        setOpaque(false);
        title.setName("decision-title");
        description.setName("decision-description");
        description.setColor(SemanticColor.MUTED);
        asker.setName("decision-asker");
        age.setName("decision-age");
        countdown.setName("decision-autonomy");
        autonomy.add(countdown, "wmin 60");
        autonomy.add(stop, "hmin " + Spacing.HIT_TARGET_FIELD);
        add(title, "split 2, wmin 60, growx");
        add(age, "growx 0, aligny top, gapleft 12, gaptop 2");
        add(asker, "wmin 0"); // its tooltip has all of it
        add(autonomy);
        dress();
    }

    private void dress() {
        if (autonomy == null) { // the superclass sets the look before there are parts
            return;
        }
        asker.setFont(Fonts.small());
        LookColors.foreground(asker, SemanticColor.MUTED);
        age.setFont(Fonts.small());
        LookColors.background(autonomy, SemanticColor.SURFACE_RAISED);
    }

    @Override
    public void updateUI() {
        super.updateUI();
        dress();
    }

    /** What the asker says about it; it may be long, so it lies where the panel scrolls. */
    JComponent description() {
        return description;
    }

    /** Leaves who asks to the tooltip of what is asked, or says it in a line. */
    void setLow(boolean low) {
        asker.setVisible(!low);
    }

    /** Shows a decision as it is now. */
    void show(PendingDecision pending, long nowMillis) {
        set(title, DecisionWords.heading(pending.presentation()));
        List<String> lines = pending.presentation().description();
        set(description, String.join("\n", lines));
        description.setVisible(!lines.isEmpty());
        asker.setText(DecisionWords.asker(pending.presentation()));
        asker.setToolTipText(asker.getText());
        title.setToolTipText(asker.getText());
        Priority priority = pending.decision().priority();
        age.setText(DecisionWords.age(pending, nowMillis));
        LookColors.foreground(
                age,
                priority == Priority.CRITICAL
                        ? SemanticColor.CRITICAL
                        : priority == Priority.HIGH ? SemanticColor.WARNING : SemanticColor.MUTED);
        String words = DecisionWords.autonomy(pending, nowMillis);
        set(countdown, words);
        autonomy.setVisible(!words.isEmpty());
        stop.setVisible(pending.presentation().autonomy().counts());
    }

    private static void set(WrappedText text, String words) {
        if (!text.getText().equals(words)) {
            text.setText(words);
        }
    }
}
