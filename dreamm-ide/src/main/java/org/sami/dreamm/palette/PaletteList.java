package org.sami.dreamm.palette;

import java.awt.Component;
import java.awt.Insets;
import java.awt.Point;
import java.awt.datatransfer.Transferable;
import java.awt.event.KeyAdapter;
import java.awt.event.KeyEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import javax.swing.BorderFactory;
import javax.swing.DefaultListCellRenderer;
import javax.swing.DefaultListModel;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.ListSelectionModel;
import javax.swing.TransferHandler;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.jspecify.annotations.Nullable;
import org.sami.dreamm.canvas.NetDropTransfer;
import org.sami.dreamm.context.DreammContext;
import org.sami.dreamm.help.Explained;
import org.sami.dreamm.help.HelpTopic;
import org.sami.dreamm.help.HelpTopics;
import org.sami.dreamm.help.word.ShownText;
import org.sami.dreamm.help.word.TermSource;
import org.sami.palette.SemanticColor;
import org.sami.spn.vocabulary.Direction;
import org.sami.ui.look.ElidedText;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;

/** A list of what can be added, by groups, with a field above it that narrows it by typing. Items can be dragged; Enter takes one. */
public final class PaletteList extends JPanel implements Explained, TermSource {
    private static final int ROWS = 8;

    private final transient DreammContext context;
    private final transient PaletteGroups groups;
    private final transient Consumer<PaletteItem> taken;
    private final JTextField search = new JTextField();
    private final DefaultListModel<Object> rows = new DefaultListModel<>();
    private final JList<Object> list = new JList<>(rows) {
        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true; // names are shortened, not scrolled
        }
    };

    private final transient List<Runnable> markListeners = new ArrayList<>();
    private transient Optional<PaletteItem> marked = Optional.empty();
    private boolean isFilling;

    /**
     * A list.
     *
     * @param name of its components, such as {@code palette}
     * @param offered which items are of use here
     * @param taken is given an item that was chosen with Enter or a double click
     */
    public PaletteList(
            DreammContext context, String name, Predicate<PaletteItem> offered, Consumer<PaletteItem> taken) {
        super(new MigLayout("novisualpadding, insets 0, gap 0 4, wrap 1, fill", "[grow, fill]", "[][grow, fill]"));
        this.context = context;
        this.groups = new PaletteGroups(context, offered);
        this.taken = item -> PaletteEdits.locked(context, item)
                .ifPresentOrElse(context.notices()::refused, () -> taken.accept(item));
        setOpaque(false);
        search.setName(name + "-search");
        search.putClientProperty("JTextField.placeholderText", "Type to find an event");
        search.putClientProperty("JTextField.showClearButton", true);
        search.setToolTipText("Type to narrow the list; Down goes into it, Enter adds what is marked");
        search.getAccessibleContext().setAccessibleName("Find what to add");
        list.setName(name + "-list");
        list.getAccessibleContext().setAccessibleName("What can be added");
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new RowRenderer());
        list.setVisibleRowCount(ROWS);
        JScrollPane scrolled =
                new JScrollPane(list, JScrollPane.VERTICAL_SCROLLBAR_AS_NEEDED, JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        LookColors.border(scrolled, () -> BorderFactory.createLineBorder(SemanticColor.BORDER.get()));
        add(search, "hmin " + Spacing.HIT_TARGET);
        add(scrolled, "wmin 0");
        listen();
        fill();
    }

    private void listen() {
        search.getDocument().addDocumentListener(new DocumentListener() {
            @Override
            public void insertUpdate(DocumentEvent e) {
                fill();
            }

            @Override
            public void removeUpdate(DocumentEvent e) {
                fill();
            }

            @Override
            public void changedUpdate(DocumentEvent e) {
                fill();
            }
        });
        KeyAdapter keys = new KeyAdapter() {
            @Override
            public void keyPressed(KeyEvent e) {
                key(e);
            }
        };
        search.addKeyListener(keys);
        list.addKeyListener(keys);
        list.addListSelectionListener(e -> mark());
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                if (e.getClickCount() == 2) {
                    selected().ifPresent(taken);
                }
            }
        });
        list.setTransferHandler(new TransferHandler() {
            @Override
            public int getSourceActions(JComponent c) {
                return COPY;
            }

            @Override
            protected @Nullable Transferable createTransferable(JComponent c) {
                return selected()
                        .map(item -> new NetDropTransfer(new PaletteDrop(context, item)))
                        .orElse(null);
            }
        });
    }

    private void key(KeyEvent e) {
        switch (e.getKeyCode()) {
            case KeyEvent.VK_ENTER -> selected().ifPresent(taken);
            case KeyEvent.VK_DOWN -> step(1);
            case KeyEvent.VK_UP -> step(-1);
            case KeyEvent.VK_ESCAPE -> search.setText("");
            default -> {
                return;
            }
        }
        e.consume();
    }

    /** Marks the next item, passing over headings. */
    private void step(int by) {
        for (int i = list.getSelectedIndex() + by; i >= 0 && i < rows.size(); i += by) {
            if (rows.get(i) instanceof PaletteItem) {
                list.setSelectedIndex(i);
                list.ensureIndexIsVisible(i);
                return;
            }
        }
    }

    /** Offers what there is now; what was marked stays marked. */
    public void fill() {
        Optional<PaletteItem> before = selected();
        List<Object> next = new ArrayList<>();
        for (PaletteGroup group : groups.matching(search.getText())) {
            next.add(group);
            next.addAll(group.items());
        }
        isFilling = true; // what is marked in between concerns nobody
        rows.clear();
        rows.addAll(next);
        before.ifPresent(item -> list.setSelectedValue(item, true));
        if (list.isSelectionEmpty() && !search.getText().isBlank()) {
            list.setSelectedIndex(-1);
            step(1);
        }
        isFilling = false;
        mark();
    }

    private void mark() {
        if (!isFilling && !selected().equals(marked)) {
            marked = selected();
            markListeners.forEach(Runnable::run);
        }
    }

    /** The item that is marked. */
    Optional<PaletteItem> selected() {
        return list.getSelectedValue() instanceof PaletteItem item ? Optional.of(item) : Optional.empty();
    }

    @Override
    public Optional<HelpTopic> help() {
        return selected()
                .map(item -> item instanceof PaletteItem.Event event
                        ? new HelpTopics(
                                        context.vocabulary(),
                                        context.additions().library())
                                .event(event.type())
                        : new HelpTopic(item.label(), "Can be added to the plan", item.help(), List.of()));
    }

    @Override
    public Optional<ShownText> wordsAt(Component inner, Point at) {
        int row = inner == list ? list.locationToIndex(at) : -1;
        return row >= 0 && list.getCellBounds(row, row).contains(at) && rows.get(row) instanceof PaletteItem item
                ? Optional.of(ShownText.all(words(item), list.getCellBounds(row, row)))
                : Optional.empty();
    }

    @Override
    public Optional<String> words() {
        return selected().map(PaletteList::words);
    }

    private static String words(PaletteItem item) {
        String kind = item instanceof PaletteItem.Event event
                ? event.type().direction() == Direction.OUTPUT ? "output event: " : "input event: "
                : "";
        return kind + item.label();
    }

    /** Calls a listener when another item is marked. */
    void whenSelected(Runnable listener) {
        markListeners.add(listener);
    }

    /** Lets items be dragged; not where there is no display. */
    void enableDrag() {
        list.setDragEnabled(true);
    }

    /** Where typing goes. */
    public JTextField searchField() {
        return search;
    }

    private static final class RowRenderer extends DefaultListCellRenderer {
        @Override
        public Component getListCellRendererComponent(
                JList<?> owner, Object row, int index, boolean isSelected, boolean hasFocus) {
            boolean heading = row instanceof PaletteGroup;
            String text =
                    row instanceof PaletteItem item ? item.mark() + "  " + item.label() : ((PaletteGroup) row).name();
            JLabel label =
                    (JLabel) super.getListCellRendererComponent(owner, text, index, isSelected && !heading, hasFocus);
            label.setFont(heading ? Fonts.strong() : Fonts.text());
            label.setBorder(BorderFactory.createEmptyBorder(
                    Look.px(heading && index > 0 ? Spacing.NORMAL : Spacing.TIGHT / 2),
                    Look.px(heading ? Spacing.TIGHT : Spacing.INSET),
                    Look.px(Spacing.TIGHT / 2),
                    Look.px(Spacing.TIGHT)));
            if (heading) {
                LookColors.foreground(label, SemanticColor.MUTED);
            }
            Insets insets = label.getInsets();
            int room = owner.getWidth() - insets.left - insets.right;
            String shown =
                    owner.getWidth() == 0 ? text : ElidedText.middle(text, label.getFontMetrics(label.getFont()), room);
            label.setText(shown);
            String help = row instanceof PaletteItem item ? item.help() : "";
            String tip = shown.equals(text) ? help : text + (help.isEmpty() ? "" : ": " + help);
            label.setToolTipText(tip.isEmpty() ? null : tip);
            return label;
        }
    }
}
