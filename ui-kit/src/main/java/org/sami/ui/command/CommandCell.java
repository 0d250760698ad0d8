package org.sami.ui.command;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Dimension;
import java.util.List;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTextArea;
import javax.swing.ListCellRenderer;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;

/** A command in a list: icon, title and key, and below them why it cannot be run now. */
final class CommandCell extends JPanel implements ListCellRenderer<Command> {
    private final JLabel title = new JLabel();
    private final JLabel key = new JLabel();
    private final JTextArea reason = new JTextArea();
    private final int width;

    /**
     * A cell.
     *
     * @param width of the list in pixels: a reason goes on in further lines
     */
    CommandCell(int width) {
        super(new BorderLayout(Look.px(Spacing.WIDE), 0));
        int gap = Look.px(Spacing.NORMAL);
        this.width = width - 2 * gap;
        setBorder(BorderFactory.createEmptyBorder(0, gap, 0, gap));
        title.setIconTextGap(Spacing.NORMAL); // labels scale it
        key.setFont(Fonts.small());
        reason.setLineWrap(true);
        reason.setWrapStyleWord(true);
        reason.setOpaque(false);
        reason.setFont(Fonts.small());
        reason.setBorder(BorderFactory.createEmptyBorder(0, 0, Look.px(Spacing.TIGHT), 0));
        add(title);
        add(key, BorderLayout.EAST);
        add(reason, BorderLayout.SOUTH);
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends Command> list, Command command, int index, boolean selected, boolean focused) {
        SemanticColor words = selected ? SemanticColor.ON_SELECTION : SemanticColor.TEXT;
        LookColors.background(this, selected ? SemanticColor.SELECTION : SemanticColor.SURFACE);
        title.setText(command.title());
        title.setIcon((Icon) command.getValue(Action.SMALL_ICON));
        LookColors.foreground(title, command.isEnabled() ? words : selected ? words : SemanticColor.DISABLED);
        key.setText(command.keyText());
        reason.setText(command.whyNot().orElse(""));
        reason.setVisible(command.whyNot().isPresent());
        reason.setSize(width, Short.MAX_VALUE); // so it knows how high it is
        for (JComponent side : List.of(key, reason)) {
            LookColors.foreground(side, selected ? SemanticColor.ON_SELECTION : SemanticColor.MUTED);
        }
        return this;
    }

    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        return new Dimension(size.width, Math.max(size.height, Look.px(Spacing.HIT_TARGET)));
    }
}
