package org.sami.ui.command;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.JDialog;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTable;
import javax.swing.KeyStroke;
import javax.swing.SwingConstants;
import javax.swing.table.DefaultTableModel;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;
import org.sami.ui.look.TabKey;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** All commands with their keys, made of the registry: what help shows. */
public final class CommandKeysPanel extends JPanel {
    private static final String TITLE = "Commands and keys";
    private static final int WIDTH = 640;
    private static final int HEIGHT = 560;
    private static final int ROW = 28;

    /**
     * Lists the commands: those with a key first.
     *
     * @param leave closes it; Escape does so
     */
    public CommandKeysPanel(CommandRegistry commands, Runnable leave) {
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
        table.getAccessibleContext().setAccessibleName(TITLE);
        TabKey.leaves(table);
        table.setRowHeight(Look.px(ROW));
        if (table.getTableHeader().getDefaultRenderer() instanceof JLabel head) {
            head.setHorizontalAlignment(SwingConstants.LEADING);
        }
        table.getColumnModel().getColumn(0).setPreferredWidth(Look.px(WIDTH * 2 / 3));
        table.getColumnModel().getColumn(1).setMinWidth(widestKey(table));
        add(new JScrollPane(table));
        getInputMap(WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(KeyStroke.getKeyStroke("ESCAPE"), "leave");
        getActionMap().put("leave", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent pressed) {
                leave.run();
            }
        });
        setPreferredSize(new Dimension(Look.px(WIDTH), Look.px(HEIGHT)));
    }

    /** So wide that every key is read whole: a part of one is no key. */
    private static int widestKey(JTable table) {
        int width = 0;
        for (int row = 0; row < table.getRowCount(); row++) {
            width = Math.max(
                    width,
                    table.prepareRenderer(table.getCellRenderer(row, 1), row, 1).getPreferredSize().width);
        }
        return width + table.getIntercellSpacing().width;
    }

    /** Opens it over a window, no larger than that: in its sheet, where the window has one. */
    public static void open(Window owner, CommandRegistry commands) {
        Optional<WindowSheet> sheet = WindowSheet.find(owner);
        if (sheet.isPresent()) {
            sheet.get()
                    .open(new Sheet(
                            "command-keys-window",
                            TITLE,
                            new CommandKeysPanel(commands, () -> sheet.get().close())));
            return;
        }
        JDialog dialog = new JDialog(owner, TITLE);
        dialog.setName("command-keys-window");
        dialog.setContentPane(new CommandKeysPanel(commands, dialog::dispose));
        dialog.pack();
        dialog.setSize(Math.min(dialog.getWidth(), owner.getWidth()), Math.min(dialog.getHeight(), owner.getHeight()));
        dialog.setLocationRelativeTo(owner);
        dialog.setVisible(true);
    }
}
