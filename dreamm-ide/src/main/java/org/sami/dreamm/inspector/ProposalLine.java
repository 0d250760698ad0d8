package org.sami.dreamm.inspector;

import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.value.WrappedText;

/** One line that says what could be done, with a button that does it. */
final class ProposalLine extends JPanel {
    ProposalLine(String words, String name, Runnable use) {
        super(new MigLayout("novisualpadding, insets 0, gap 4, fillx", "[grow, fill][]"));
        setOpaque(false);
        WrappedText text = new WrappedText(words);
        text.setColor(SemanticColor.MUTED);
        add(text, "wmin 0");
        add(Form.button("Use", name, "Use " + words, use), "aligny top");
    }
}
