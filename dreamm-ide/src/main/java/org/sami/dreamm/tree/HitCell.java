package org.sami.dreamm.tree;

import java.awt.Component;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.ElidedText;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;

/** Shows something that was found: what it is, and below it where. */
final class HitCell extends JPanel implements ListCellRenderer<Hit> {
    private static final int INSET = 12;

    private final JLabel title = new JLabel();
    private final JLabel detail = new JLabel();

    HitCell() {
        super(new MigLayout("insets 4 " + INSET + " 4 " + INSET + ", wrap, gap 0", "[grow, fill]"));
        add(title, "wmin 0");
        add(detail, "wmin 0");
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends Hit> list, Hit hit, int index, boolean selected, boolean focused) {
        title.setFont(Fonts.text());
        detail.setFont(Fonts.small());
        show(title, hit.title(), list);
        show(detail, hit.detail(), list);
        setToolTipText(hit.title() + ": " + hit.detail());
        LookColors.background(this, selected ? SemanticColor.SELECTION : SemanticColor.SURFACE);
        LookColors.foreground(title, selected ? SemanticColor.ON_SELECTION : SemanticColor.TEXT);
        LookColors.foreground(detail, selected ? SemanticColor.ON_SELECTION : SemanticColor.MUTED);
        return this;
    }

    private static void show(JLabel label, String text, JList<?> list) {
        int room = list.getWidth() - 2 * Look.px(INSET);
        label.setText(
                list.getWidth() == 0 ? text : ElidedText.middle(text, label.getFontMetrics(label.getFont()), room));
    }
}
