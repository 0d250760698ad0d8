package org.sami.crw.gui.decision;

import java.util.ArrayList;
import java.util.List;
import java.util.function.LongConsumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingConstants;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.decision.DecisionPresentation;
import org.sami.crw.operator.message.PendingDecision;
import org.sami.spn.protocol.Priority;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.look.Spacing;

/** The decisions that wait behind the shown one: a line each, the most urgent first; pressing one shows it and answers nothing. */
final class WaitingList extends JPanel {
    private static final int MOST = 6;

    private final LongConsumer selected;
    private final JLabel more = new JLabel();
    private List<PendingDecision> shown = List.of();
    private final List<JLabel> ages = new ArrayList<>();

    WaitingList(LongConsumer selected) {
        super(new MigLayout("novisualpadding, insets 0, gap 8 2, fillx, hidemode 3, wrap 2", "[grow,fill][right]"));
        this.selected = selected;
        setOpaque(false);
        setName("decisions-waiting");
        more.setName("decisions-more");
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (ages != null) {
            ages.forEach(WaitingList::dress);
        }
    }

    private static void dress(JLabel age) {
        age.setFont(Fonts.small());
        LookColors.foreground(age, SemanticColor.MUTED);
    }

    /** Shows these; what is shown already stays where it is. */
    void show(List<PendingDecision> others, long nowMillis) {
        if (!ids(others).equals(ids(shown))) {
            removeAll();
            ages.clear();
            others.stream().limit(MOST).forEach(this::addRow);
            more.setText(others.size() > MOST ? "and " + (others.size() - MOST) + " more" : "");
            more.setVisible(others.size() > MOST);
            LookColors.foreground(more, SemanticColor.MUTED);
            add(more, "span 2");
            revalidate();
            repaint();
        }
        shown = List.copyOf(others);
        for (int i = 0; i < ages.size(); i++) {
            ages.get(i).setText(DecisionWords.span(shown.get(i).ageMillis(nowMillis)));
        }
    }

    private static List<Long> ids(List<PendingDecision> some) {
        return some.stream().map(one -> one.decision().id()).toList();
    }

    private void addRow(PendingDecision pending) {
        Priority priority = pending.decision().priority();
        String mark = priority == Priority.CRITICAL ? "▲ " : priority == Priority.HIGH ? "△ " : "";
        JButton row = new JButton(mark + words(pending.presentation()));
        row.setName("decision-waiting-" + (ages.size() + 1));
        row.setHorizontalAlignment(SwingConstants.LEADING);
        row.putClientProperty("JButton.buttonType", "borderless");
        row.setToolTipText(DecisionWords.asker(pending.presentation()) + ": "
                + pending.presentation().title());
        row.addActionListener(event -> selected.accept(pending.decision().id()));
        JLabel age = new JLabel();
        age.setName("decision-waiting-age-" + (ages.size() + 1));
        dress(age);
        ages.add(age);
        add(row, "wmin 0, hmin " + (Look.hasHighRows() ? Spacing.HIT_TARGET_FIELD : Spacing.HIT_TARGET));
        add(age);
    }

    /** What is asked, and about whom: several boats may be asked about alike. */
    private static String words(DecisionPresentation decision) {
        String boats = DecisionWords.boats(decision);
        return (boats.isEmpty() ? "" : boats + ": ") + shortened(DecisionWords.heading(decision));
    }

    private static String shortened(String title) {
        return title.length() <= 40 ? title : title.substring(0, 39).strip() + "…";
    }
}
