package org.sami.ui.command;

import java.awt.BorderLayout;
import java.awt.Component;
import javax.swing.Action;
import javax.swing.BorderFactory;
import javax.swing.Icon;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.ListCellRenderer;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.SemanticColor;
import org.sami.ui.look.Spacing;

/** A command in a list: icon, title, why it cannot be run now, key. */
final class CommandCell extends JPanel implements ListCellRenderer<Command> {
    private final JLabel title = new JLabel();
    private final JLabel side = new JLabel();

    CommandCell() {
        super(new BorderLayout(Look.px(Spacing.WIDE), 0));
        setBorder(BorderFactory.createEmptyBorder(0, Look.px(Spacing.NORMAL), 0, Look.px(Spacing.NORMAL)));
        title.setIconTextGap(Look.px(Spacing.NORMAL));
        side.setFont(Fonts.small());
        add(title);
        add(side, BorderLayout.EAST);
    }

    @Override
    public Component getListCellRendererComponent(
            JList<? extends Command> list, Command command, int index, boolean selected, boolean focused) {
        SemanticColor words = selected ? SemanticColor.ON_SELECTION : SemanticColor.TEXT;
        setBackground((selected ? SemanticColor.SELECTION : SemanticColor.SURFACE).get());
        title.setText(command.title());
        title.setIcon((Icon) command.getValue(Action.SMALL_ICON));
        title.setForeground((command.isEnabled() ? words : selected ? words : SemanticColor.DISABLED).get());
        side.setText(command.whyNot().orElse(command.keyText()));
        side.setForeground((selected ? SemanticColor.ON_SELECTION : SemanticColor.MUTED).get());
        return this;
    }
}
