package org.sami.dreamm.learn.view;

import java.awt.Component;
import java.util.function.Function;
import javax.swing.Icon;
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
import org.sami.ui.look.Spacing;

/** A line of a list, and below it what is said of it. */
final class EntryCell<T> extends JPanel implements ListCellRenderer<T> {
    private static final int ICON = 24;

    private final transient Function<T, Entry> entry;
    private final JLabel title = new JLabel();
    private final JLabel detail = new JLabel();

    /**
     * What a line shows.
     *
     * @param strong whether its title is a head of those below
     */
    record Entry(String title, String detail, Icon icon, boolean strong) {}

    EntryCell(Function<T, Entry> entry) {
        super(new MigLayout(
                "insets 5 " + Spacing.INSET + " 5 " + Spacing.INSET + ", wrap, gap 0, hidemode 3", "[grow, fill]"));
        this.entry = entry;
        add(title, "wmin 0");
        add(detail, "wmin 0, gapleft " + ICON);
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends T> list, T value, int index, boolean selected, boolean focused) {
        Entry shown = entry.apply(value);
        title.setFont(shown.strong() ? Fonts.strong() : Fonts.text());
        title.setIcon(shown.icon());
        title.setIconTextGap(Look.px(Spacing.NORMAL));
        detail.setFont(Fonts.small());
        detail.setVisible(!shown.detail().isEmpty());
        show(title, shown.title(), list);
        show(detail, shown.detail(), list);
        getAccessibleContext().setAccessibleName(shown.title() + ". " + shown.detail());
        LookColors.background(this, selected ? SemanticColor.SELECTION : SemanticColor.SURFACE);
        LookColors.foreground(title, selected ? SemanticColor.ON_SELECTION : SemanticColor.TEXT);
        LookColors.foreground(detail, selected ? SemanticColor.ON_SELECTION : SemanticColor.MUTED);
        return this;
    }

    private static void show(JLabel label, String text, JList<?> list) {
        int room = list.getWidth() - Look.px(2 * Spacing.INSET + ICON + Spacing.NORMAL);
        label.setText(
                list.getWidth() == 0 ? text : ElidedText.middle(text, label.getFontMetrics(label.getFont()), room));
    }
}
