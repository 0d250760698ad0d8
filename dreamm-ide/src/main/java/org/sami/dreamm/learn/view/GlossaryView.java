package org.sami.dreamm.learn.view;

import java.awt.Dimension;
import java.awt.event.ActionEvent;
import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.Optional;
import javax.swing.AbstractAction;
import javax.swing.BorderFactory;
import javax.swing.DefaultListModel;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import javax.swing.KeyStroke;
import javax.swing.ListSelectionModel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.learn.GlossarySearch;
import org.sami.dreamm.learn.GlossarySearch.Found;
import org.sami.dreamm.learn.LessonModel;
import org.sami.dreamm.learn.view.EntryCell.Entry;
import org.sami.lessons.course.Term;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.TextChanges;
import org.sami.ui.value.WrappedText;

/** The glossary: a field that looks for terms and in lessons, what was found, and what the chosen one says. Enter goes to where it is explained. */
final class GlossaryView extends JPanel {
    private static final int WIDTH = 520;
    private static final int HEIGHT = 560;
    private static final int ICON = 16;

    private final transient LessonModel model;
    private final transient GlossarySearch search;
    private final transient Runnable close;
    private final JTextField words = new JTextField();
    private final DefaultListModel<Found> hits = new DefaultListModel<>();
    private final JList<Found> list = new JList<>(hits) {
        @Override
        public boolean getScrollableTracksViewportWidth() {
            return true; // titles are shortened, not scrolled
        }
    };
    private final WrappedText title = WrappedText.heading("");
    private final WrappedText text = new WrappedText("");
    private final JButton go = new JButton();

    /**
     * The glossary of a course.
     *
     * @param term that is chosen at first; empty text for none
     * @param close closes the sheet
     */
    GlossaryView(LessonModel model, String term, Runnable close) {
        super(new MigLayout(
                "insets 0 " + Spacing.INSET + " " + Spacing.INSET + " " + Spacing.INSET + ", fill, wrap",
                "[grow, fill]",
                "[][grow, fill][]"));
        this.model = model;
        this.close = close;
        search = new GlossarySearch(model.course());
        words.setName("learn-glossary-words");
        words.getAccessibleContext().setAccessibleName("Look for a term, or for words in the lessons");
        words.putClientProperty("JTextField.placeholderText", "Look for a term, or for words in the lessons");
        words.getDocument().addDocumentListener(new TextChanges(this::look));
        list.setName("learn-glossary-list");
        list.setSelectionMode(ListSelectionModel.SINGLE_SELECTION);
        list.setCellRenderer(new EntryCell<>(GlossaryView::entry));
        list.getAccessibleContext().setAccessibleName("What was found");
        LookColors.background(list, SemanticColor.SURFACE);
        list.addListSelectionListener(e -> showChosen());
        list.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseClicked(MouseEvent e) {
                if (e.getClickCount() == 2) {
                    goThere();
                }
            }
        });
        key(words, "DOWN", () -> select(list.getSelectedIndex() + 1));
        key(words, "UP", () -> select(list.getSelectedIndex() - 1));
        key(words, "ENTER", this::goThere);
        key(list, "ENTER", this::goThere);
        JScrollPane scroll = new JScrollPane(list);
        scroll.setHorizontalScrollBarPolicy(JScrollPane.HORIZONTAL_SCROLLBAR_NEVER);
        LookColors.border(scroll, () -> BorderFactory.createLineBorder(SemanticColor.BORDER.get(), Look.px(1)));
        add(words, "hmin " + Spacing.HIT_TARGET);
        add(scroll, "hmin 0");
        add(said(), "growx");
        setPreferredSize(new Dimension(Look.px(WIDTH), Look.px(HEIGHT)));
        begin(term);
    }

    private JComponent said() {
        JPanel said = new JPanel(new ColumnLayout(Spacing.TIGHT));
        said.setOpaque(false);
        title.setName("learn-glossary-title");
        text.setName("learn-glossary-text");
        go.setName("learn-glossary-go");
        go.setIcon(Icons.normal("go-to"));
        go.addActionListener(e -> goThere());
        said.add(title);
        said.add(text);
        said.add(go);
        return said;
    }

    private static void key(JComponent on, String stroke, Runnable run) {
        on.getInputMap().put(KeyStroke.getKeyStroke(stroke), "glossary-" + stroke);
        on.getActionMap().put("glossary-" + stroke, new AbstractAction() {
            @Override
            public void actionPerformed(ActionEvent e) {
                run.run();
            }
        });
    }

    private static Entry entry(Found found) {
        return new Entry(found.title(), found.text(), Icons.of("note", ICON, SemanticColor.MUTED), false);
    }

    private void begin(String term) {
        look();
        Optional<Term> known = model.course().term(term);
        known.ifPresent(found -> {
            int at = hits.indexOf(search.found(found));
            select(at);
        });
    }

    private void look() {
        hits.clear();
        hits.addAll(search.find(words.getText()));
        select(0);
    }

    private void select(int index) {
        if (!hits.isEmpty()) {
            int at = Math.max(0, Math.min(hits.size() - 1, index));
            list.setSelectedIndex(at);
            list.ensureIndexIsVisible(at);
        }
        showChosen();
    }

    private void showChosen() {
        Found chosen = list.getSelectedValue();
        title.setText(chosen == null ? "Nothing is called so" : chosen.title());
        text.setText(chosen == null ? "Neither a term nor a step of a lesson has these words." : chosen.text());
        boolean can = chosen != null && chosen.step().isPresent();
        go.setEnabled(can);
        go.setText(chosen == null ? "Go there" : "Explained in " + chosen.where());
        revalidate();
    }

    private void goThere() {
        Found chosen = list.getSelectedValue();
        if (chosen != null && chosen.step().isPresent()) {
            close.run();
            model.go(chosen.step().get());
        }
    }
}
