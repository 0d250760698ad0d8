package org.sami.ui.command;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Window;
import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.table.DefaultTableModel;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/** All commands with their keys, made of the registry: what help shows. */
public final class CommandKeysPanel extends JPanel {
    private static final int WIDTH = 640;
    private static final int HEIGHT = 560;

    /** Lists the commands: those with a key first. */
    public CommandKeysPanel(CommandRegistry commands) {
        super(new BorderLayout());
        setName("command-keys");
        int inset = Look.px(Spacing.INSET);
        setBorder(BorderFactory.createEmptyBorder(inset, inset, inset, inset));
        DefaultTableModel rows = new DefaultTableModel(new Object[] {"Command", "Key"}, 0) {
            @Override
            public boolean isCellEditable(int row, int column) {
                return false;
            }
        };
        for (boolean keyed : List.of(true, false)) {
            commands.all().stream()
                    .filter(command -> !command.keyText().isEmpty() == keyed)
                    .forEach(command -> rows.addRow(new Object[] {command.title(), command.keyText()}));
        }
        JTable table = new JTable(rows);
        table.setName("command-keys-table");
        table.getColumnModel().getColumn(0).setPreferredWidth(Look.px(WIDTH * 2 / 3));
        add(new JScrollPane(table));
        setPreferredSize(new Dimension(Look.px(WIDTH), Look.px(HEIGHT)));
    }

    /** Opens it beside a window. */
    public static void open(Window owner, CommandRegistry commands) {
        JDialog dialog = new JDialog(owner, "Commands and keys");
        dialog.setName("command-keys-window");
        dialog.setContentPane(new CommandKeysPanel(commands));
        dialog.pack();
        dialog.setLocationRelativeTo(owner);
        dialog.setVisible(true);
    }
}
