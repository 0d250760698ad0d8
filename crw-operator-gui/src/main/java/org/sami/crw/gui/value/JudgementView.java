package org.sami.crw.gui.value;

import java.util.ArrayList;
import java.util.List;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.session.api.Judgement;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.LookColors;
import org.sami.ui.value.WrappedText;

/** What is to be minded of what is filled in, and what it takes; in a low panel as one line whose tooltip has all of it. */
public final class JudgementView extends JPanel {
    private final WrappedText doubts = new WrappedText("");
    private final WrappedText costs = new WrappedText("");
    private final JLabel line = new JLabel();
    private Judgement shown = Judgement.NOTHING;
    private boolean low;

    /**
     * Shows nothing yet.
     *
     * @param name with which the names of its parts begin
     */
    public JudgementView(String name) {
        super(new MigLayout("novisualpadding, insets 0, gap 4 2, fillx, hidemode 3, wrap 1", "[grow,fill]"));
        setOpaque(false);
        setName(name + "-judgement");
        doubts.setName(name + "-doubts");
        doubts.setColor(SemanticColor.WARNING);
        costs.setName(name + "-costs");
        costs.setColor(SemanticColor.MUTED);
        line.setName(name + "-judgement-line");
        add(doubts, "wmin 60");
        add(costs, "wmin 60");
        add(line, "wmin 0");
        arrange();
    }

    /** Shows a judgement; why an answer is refused stands at the answer. */
    public void show(Judgement judgement) {
        if (!judgement.equals(shown)) {
            shown = judgement;
            doubts.setText(String.join("\n", marked(judgement.doubts())));
            costs.setText(String.join("\n", judgement.costs()));
            List<String> all = new ArrayList<>(marked(judgement.doubts()));
            all.addAll(judgement.costs());
            line.setText(String.join(" · ", all));
            line.setToolTipText(all.isEmpty() ? null : line.getText());
            arrange();
        }
    }

    private static List<String> marked(List<String> doubts) {
        return doubts.stream().map(words -> "△ " + words).toList();
    }

    /** In a low panel there is one line. */
    public void setLow(boolean low) {
        if (this.low != low) {
            this.low = low;
            arrange();
        }
    }

    private void arrange() {
        boolean doubted = !shown.doubts().isEmpty();
        boolean costing = !shown.costs().isEmpty();
        line.setFont(Fonts.small());
        LookColors.foreground(line, doubted ? SemanticColor.WARNING : SemanticColor.MUTED);
        doubts.setVisible(!low && doubted);
        costs.setVisible(!low && costing);
        line.setVisible(low && (doubted || costing));
        setVisible(doubted || costing);
        revalidate();
    }
}
