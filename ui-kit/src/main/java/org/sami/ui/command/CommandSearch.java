package org.sami.ui.command;

import java.awt.BorderLayout;
import java.awt.Dimension;
import java.awt.Window;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.ScrollPaneConstants;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.sheet.Sheet;
import org.sami.ui.sheet.WindowSheet;

/** Finds commands by typing: a field and the list of those that match. Enter runs the chosen one, Escape leaves. On the event thread. */
public final class CommandSearch extends JPanel {
    private static final int WIDTH = 640;
    private static final int ROWS = 11;
    private static final int SCROLL_BAR = 16;

    private final CommandRegistry commands;
    private final Runnable leave;
    private final JTextField field = new JTextField();
    private final DefaultListModel<Command> found = new DefaultListModel<>();
    private final JList<Command> list = new JList<>(found) {
        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true; // nothing scrolls sideways
        }
    };

    /**
     * A search that has everything listed.
     *
     * @param leave closes what it is shown in; called before a command is run
     */
    public CommandSearch(CommandRegistry commands, Runnable leave) {
        super(new BorderLayout(0, Look.px(Spacing.NORMAL)));
        this.commands = commands;
        this.leave = leave;
        int inset = Look.px(Spacing.INSET);
        setName("command-search");
        LookColors.background(this, SemanticColor.SURFACE);
        LookColors.border(
                this,
                () -> BorderFactory.createCompoundBorder(
                        BorderFactory.createLineBorder(SemanticColor.ACCENT.get(), Look.px(2)),
                        BorderFactory.createEmptyBorder(inset, inset, inset, inset)));
        field.setName("command-search-text");
        field.setFont(Fonts.heading());
        field.setPreferredSize(new Dimension(Look.px(WIDTH), Look.px(Spacing.HIT_TARGET_FIELD)));
        field.putClientProperty("JTextField.placeholderText", "Type what you want to do");
        field.getAccessibleContext().setAccessibleName("Command search");
        list.setName("command-search-found");
        list.getAccessibleContext().setAccessibleName("Commands that match");
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new CommandCell(Look.px(WIDTH) - 2 * inset - Look.px(SCROLL_BAR)));
        list.setFocusable(false);
        JScrollPane scroll = new JScrollPane(list);
        scroll.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        scroll.setBorder(null);
        add(field, BorderLayout.NORTH);
        add(scroll);
        setPreferredSize(new Dimension(Look.px(WIDTH), Look.px(Spacing.HIT_TARGET * ROWS + 80)));
        field.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                search();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                search();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                search();
            }
        });
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseReleased(MouseEvent e) {
                runChosen();
            }
        });
        bind("DOWN", () -> choose(list.getSelectedIndex() + 1));
        bind("UP", () -> choose(list.getSelectedIndex() - 1));
        bind("ENTER", this::runChosen);
        bind("ESCAPE", leave);
        search();
    }

    /** Opens it over a window, in its sheet where the window has one; it closes when it loses the focus. */
    public static void open(Window owner, CommandRegistry commands) {
        Optional<WindowSheet> sheet = WindowSheet.find(owner);
        if (sheet.isPresent()) {
            CommandSearch search = new CommandSearch(commands, () -> sheet.get().close());
            sheet.get().open(new Sheet("command-search-sheet", "", search).passing(true));
        } else {
            PopupWindow.open(owner, "Command search", close -> new CommandSearch(commands, close));
        }
    }

    /** The command that Enter would run. */
    public Optional<Command> chosen() {
        return Optional.ofNullable(list.getSelectedValue());
    }

    /** What was typed. */
    public void type(String text) {
        field.setText(text);
    }

    private void bind(String key, Runnable action) {

        KeyStroke stroke = KeyStroke.getKeyStroke(key);
        getInputMap(JComponent.WHEN_ANCESTOR_OF_FOCUSED_COMPONENT).put(stroke, key);
        field.getInputMap().put(stroke, key);
        AbstractAction run = new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                action.run();
            }
        };
        getActionMap().put(key, run);
        field.getActionMap().put(key, run);
    }

    private void search() {
        commands.refresh();
        found.clear();
        found.addAll(CommandMatches.of(field.getText(), commands.all()));
        choose(0);
    }

    private void choose(int index) {
        if (!found.isEmpty()) {
            int next = Math.floorMod(index, found.size());
            list.setSelectedIndex(next);
            list.ensureIndexIsVisible(next);
        }
    }

    private void runChosen() {
        chosen().filter(Command::isEnabled).ifPresent(command -> {
            leave.run();
            command.run();
        });
    }
}
