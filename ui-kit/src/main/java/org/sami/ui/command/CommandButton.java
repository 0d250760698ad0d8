package org.sami.ui.command;

import java.awt.Dimension;
import javax.swing.JButton;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** A button for a command: named by its id, as large as a wet finger needs. */
public final class CommandButton extends JButton {
    /** A button with icon and title. */
    public CommandButton(Command command) {
        super(command);
        setName(command.id());
        setVisible(!command.isHidden());
        setIconTextGap(Look.px(Spacing.TIGHT));
    }

    /** A button with the icon alone; the tooltip says what it does. */
    public static CommandButton iconOnly(Command command) {
        CommandButton button = new CommandButton(command);
        button.setHideActionText(true);
        button.getAccessibleContext().setAccessibleName(command.title());
        button.putClientProperty("JButton.buttonType", "toolBarButton");
        return button;
    }

    @Override
    public Dimension getPreferredSize() {
        Dimension size = super.getPreferredSize();
        int least = Look.px(Spacing.HIT_TARGET_FIELD);
        return new Dimension(Math.max(least, size.width), Math.max(least, size.height));
    }

    @Override
    public Dimension getMinimumSize() {
        return getPreferredSize();
    }
}
