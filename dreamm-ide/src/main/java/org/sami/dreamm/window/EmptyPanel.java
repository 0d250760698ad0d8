package org.sami.dreamm.window;

import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.SemanticColor;

/** The place of a panel that has nothing to show: it says what will stand here, and what to do for it. */
final class EmptyPanel extends JPanel {
    private final JLabel title = new JLabel();
    private final JTextArea text = new JTextArea();

    EmptyPanel(String title, String text) {
        super(new MigLayout("insets 16, wrap, gap 8", "[grow, fill]"));
        this.title.setText(title);
        this.text.setText(text);
        this.text.setLineWrap(true);
        this.text.setWrapStyleWord(true);
        this.text.setEditable(false);
        this.text.setFocusable(false);
        this.text.setOpaque(false);
        this.text.setBorder(null);
        add(this.title);
        add(this.text, "wmin 0");
        style();
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (title != null) {
            style();
        }
    }

    private void style() {
        setBackground(SemanticColor.SURFACE.get());
        title.setFont(Fonts.heading());
        text.setFont(Fonts.text());
        text.setForeground(SemanticColor.MUTED.get());
    }
}
