package org.sami.ui.table;

import java.awt.BorderLayout;
import java.util.List;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.command.Command;
import org.sami.ui.command.CommandButton;
import org.sami.ui.command.CommandRow;
import org.sami.ui.look.FoldingPanel;

/**
 * A table with buttons: below it with their titles, or, where the panel is so low that rows would have no room, next to it as icons. Their
 * components are named by the commands, the icons with the suffix {@code -icon}.
 */
public final class TableTools extends FoldingPanel {
    private static final int LOW = 170;

    private final CommandRow below = new CommandRow();
    private final JPanel beside = new JPanel(new MigLayout("novisualpadding, insets 2, gap 0 2, wrap 1", "[]"));

    /** A table with the buttons of commands, the most important last. */
    public TableTools(JComponent table, List<Command> commands) {
        super(new BorderLayout());
        for (int i = commands.size() - 1; i >= 0; i--) {
            CommandButton icon = CommandButton.iconOnly(commands.get(i));
            icon.setName(commands.get(i).id() + "-icon");
            beside.add(icon);
        }
        commands.forEach(command -> below.right(new CommandButton(command)));
        beside.setVisible(false);
        add(table);
        add(below, BorderLayout.SOUTH);
        add(beside, BorderLayout.EAST);
        foldBelowHeight(LOW, low -> {
            beside.setVisible(low);
            below.setVisible(!low);
        });
    }
}
