package org.sami.dreamm.tree;

import java.awt.BorderLayout;
import java.awt.event.ActionEvent;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import javax.swing.ScrollPaneConstants;
import org.sami.dreamm.context.DreammContext;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;

/** What a search, or the look for uses, has found: what is chosen is shown on the net. Escape leads back to the tree. */
final class HitList extends JPanel {
    private final transient DreammContext context;
    private final JLabel head = new JLabel();
    private final DefaultListModel<Hit> hits = new DefaultListModel<>();
    private final JList<Hit> list = new JList<>(hits) {
        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true; // names are shortened, not scrolled
        }
    };

    HitList(DreammContext context, Runnable leave) {
        super(new BorderLayout());
        this.context = context;
        head.setName("hits-head");
        list.setName("hits");
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new HitCell());
        list.getAccessibleContext().setAccessibleName("What was found");
        list.addListSelectionListener(e -> {
            if (!e.getValueIsAdjusting() && list.getSelectedValue() != null) {
                showHit(list.getSelectedValue());
            }
        });
        list.getInputMap().put(KeyStroke.getKeyStroke("ESCAPE"), "leave");
        list.getActionMap().put("leave", new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                leave.run();
            }
        });
        JScrollPane scroll = new JScrollPane(list);
        scroll.setBorder(BorderFactory.createEmptyBorder());
        scroll.setHorizontalScrollBarPolicy(ScrollPaneConstants.HORIZONTAL_SCROLLBAR_NEVER);
        add(head, BorderLayout.NORTH);
        add(scroll);
        style();
    }

    /** Shows what was found. */
    void showHits(String title, List<Hit> found) {
        head.setText(title);
        hits.clear();
        hits.addAll(found);
    }

    /** Puts the focus on the first one. */
    void focusFirst() {
        list.requestFocusInWindow();
        if (!hits.isEmpty() && list.isSelectionEmpty()) {
            list.setSelectedIndex(0);
        }
    }

    private void showHit(Hit hit) {
        if (!hit.plan().isEmpty()) {
            Consumer<Set<String>> show = elements -> {
                context.editor().open(hit.plan(), elements);
                context.editor().highlight(elements);
            };
            show.accept(hit.element().isEmpty() ? Set.of() : Set.of(hit.element()));
        }
    }

    @Override
    public void updateUI() {
        super.updateUI();
        if (list != null) {
            style();
        }
    }

    private void style() {
        LookColors.background(this, SemanticColor.SURFACE);
        LookColors.background(list, SemanticColor.SURFACE);
        head.setFont(Fonts.small());
        LookColors.foreground(head, SemanticColor.MUTED);
        int inset = Look.px(Spacing.INSET);
        head.setBorder(BorderFactory.createEmptyBorder(Look.px(Spacing.TIGHT), inset, Look.px(Spacing.TIGHT), inset));
    }
}
