package org.sami.dreamm.issues;

import javax.swing.JButton;
import javax.swing.JPanel;
import javax.swing.JPopupMenu;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.CommandButton;
import org.sami.ui.look.Icons;
import org.sami.ui.value.WrappedText;

/** Begins deep checks and stops the one that runs; a label next to it shows its progress. On the event thread. */
final class DeepChecksBar extends JPanel {
    private static final String WORDS = "Search deeper";

    private final transient IssueCommands commands;
    private final WrappedText status = new WrappedText("");
    private final JButton begin = new JButton(WORDS);
    private final CommandButton stop;

    DeepChecksBar(IssueCommands commands) {
        super(new MigLayout("novisualpadding, insets 0, gap 8, hidemode 3", "[][]", "[]"));
        this.commands = commands;
        setOpaque(false);
        status.setColor(SemanticColor.MUTED);
        status.setName("deep-check-status");
        begin.setName("deep-checks");
        begin.setToolTipText("Search deeper: run the open plan to find what the drawing alone does not show");
        begin.getAccessibleContext().setAccessibleName(WORDS);
        begin.addActionListener(e -> {
            JPopupMenu menu = new JPopupMenu();
            menu.setName("deep-checks-menu");
            commands.deepCommands().forEach(menu::add);
            menu.show(begin, 0, begin.getHeight());
        });
        stop = new CommandButton(commands.stop());
        stop.getAccessibleContext().setAccessibleName(commands.stop().title());
        add(begin, "hmin 32");
        add(stop, "hmin 32");
    }

    /** Whether there is room for the icon alone; the tooltip says the rest. */
    void setNarrow(boolean narrow) {
        begin.setText(narrow ? "" : WORDS);
        stop.setHideActionText(narrow);
    }

    /** The result of the last search, or the progress of the running one; shown next to the bar. Not visible where there was none. */
    WrappedText status() {
        return status;
    }

    void refresh() {
        boolean runs = commands.deep().isRunning();
        String words = commands.deep().status();
        status.setText(words);
        status.setVisible(!words.isEmpty());
        begin.setIcon(Icons.normal("search"));
        begin.setVisible(!runs);
        stop.setVisible(runs);
    }
}
