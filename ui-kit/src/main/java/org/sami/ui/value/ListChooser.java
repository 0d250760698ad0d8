package org.sami.ui.value;

import java.awt.Dimension;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import javax.swing.ButtonGroup;
import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JScrollPane;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;
import org.sami.ui.look.Look;
import org.sami.ui.look.Spacing;

/**
 * A list of choices, one below the other: of which one is chosen, or several with the description of each (components {@code ChoiceList},
 * {@code ProxyList}, {@code TaskList}, {@code VariableList}, {@code PlanList}). With the widget {@code FilterBar} only the rows of a
 * longer list are seen that contain something.
 */
final class ListChooser extends ValueChooser {
    private static final int MOST_HEIGHT = 320;
    private static final int FEW = 6; // so many are seen at a glance: a filter would take the height of two of them

    private final Offer offer;
    private final boolean asList;
    private final List<ChoiceRowView> rows = new ArrayList<>();
    private final ButtonGroup group = new ButtonGroup();
    private final FieldMessage message;
    private final JLabel count = new JLabel(" ");
    private final JTextField filter = new JTextField();
    private final JPanel several =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 8", "[][][grow,right]", "[]"));
    private final JPanel panel = new JPanel(new MigLayout(
            "novisualpadding, insets 0, gap 4 4, fillx, hidemode 3, wrap 1", "[grow,fill]", "[][][grow,fill][]"));

    /**
     * A list with nothing chosen.
     *
     * @param asList whether the value is the list of the chosen ones; false = the one that is chosen
     */
    ListChooser(ValueField field, Offer offer, boolean asList, boolean filtered) {
        super(field);
        this.offer = offer;
        this.asList = asList;
        message = new FieldMessage(field);
        ScrolledColumn column = new ScrolledColumn(
                new MigLayout("novisualpadding, insets 0, gap 0 0, fillx, hidemode 3, wrap 1", "[grow,fill]"),
                MOST_HEIGHT);
        for (int i = 0; i < offer.rows().size(); i++) {
            ChoiceRowView view = new ChoiceRowView(field, offer.rows().get(i), i, offer.single(), this::changed);
            rows.add(view);
            if (offer.single()) {
                group.add(view.button());
            } else {
                moveWithArrows(view.button(), i);
            }
            column.add(view, "hmin " + Spacing.HIT_TARGET_FIELD);
        }
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        if (filtered && offer.rows().size() > FEW) {
            addFilter();
        }
        if (!offer.single()) {
            addAllAndNone();
        }
        if (rows.isEmpty()) {
            JLabel none = new JLabel("There is nothing to choose from");
            none.setName(field.componentName("none"));
            panel.add(none);
        } else {
            JScrollPane pane = column.scrolled();
            pane.getAccessibleContext().setAccessibleName(field.label());
            panel.add(pane, "growx, hmin 44");
        }
        panel.add(message);
        refresh();
    }

    private void addFilter() {
        filter.setName(field().componentName("filter"));
        filter.putClientProperty("JTextField.placeholderText", "Show only what contains …");
        filter.putClientProperty("JTextField.showClearButton", true);
        filter.getAccessibleContext().setAccessibleName("Show only what contains");
        filter.getDocument().addDocumentListener(new TextChanges(this::applyFilter));
        panel.add(filter, "hmin " + Look.hitTarget());
    }

    private void addAllAndNone() {
        several.setOpaque(false);
        several.add(button("All", "all", () -> chooseAll(true)));
        several.add(button("None", "none-chosen", () -> chooseAll(false)));
        count.setName(field().componentName("count"));
        several.add(count);
        panel.add(several);
    }

    private JButton button(String words, String part, Runnable action) {
        JButton button = new JButton(words) {
            @Override
            public Dimension getPreferredSize() {
                Dimension size = super.getPreferredSize();
                return new Dimension(size.width, Math.max(size.height, Look.px(Look.hitTarget())));
            }

            @Override
            public Dimension getMinimumSize() {
                return getPreferredSize();
            }
        };
        button.setName(field().componentName(part));
        button.setToolTipText(words.equals("All") ? "Choose all that are shown" : "Choose none");
        button.addActionListener(event -> action.run());
        return button;
    }

    private void moveWithArrows(JComponent button, int index) {
        Keys.bind(button, KeyEvent.VK_DOWN, 0, "next-option", () -> focusFrom(index, 1));
        Keys.bind(button, KeyEvent.VK_UP, 0, "previous-option", () -> focusFrom(index, -1));
    }

    private void focusFrom(int index, int step) {
        for (int i = index + step; i >= 0 && i < rows.size(); i += step) {
            if (rows.get(i).isVisible()) {
                rows.get(i).button().requestFocusInWindow();
                rows.get(i).scrollRectToVisible(rows.get(i).getBounds());
                return;
            }
        }
    }

    private void applyFilter() {
        rows.forEach(view -> view.setVisible(view.row().contains(filter.getText())));
        panel.revalidate();
        panel.repaint();
    }

    private void chooseAll(boolean all) {
        rows.forEach(view -> view.button()
                .setSelected(all && (view.isVisible() || view.button().isSelected())));
        changed();
    }

    @Override
    public int options() {
        return rows.size();
    }

    @Override
    public List<Integer> chosen() {
        return IntStream.range(0, rows.size())
                .filter(i -> rows.get(i).button().isSelected())
                .boxed()
                .toList();
    }

    @Override
    public void choose(int option) {
        if (rows.get(option).button().isEnabled()) {
            rows.get(option)
                    .button()
                    .setSelected(offer.single() || !rows.get(option).button().isSelected());
            changed();
        }
    }

    @Override
    void leaveMessage() {
        panel.remove(message);
    }

    @Override
    void mark(int option) {
        rows.get(option).button().setSelected(true);
    }

    @Override
    void showDetail(int option, String detail) {
        rows.get(option).showDetail(detail);
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        List<Integer> chosen = chosen();
        return rows.isEmpty()
                ? panel
                : rows.get(chosen.isEmpty() ? 0 : chosen.get(0)).button();
    }

    @Override
    public Entry entry() {
        List<Integer> chosen = chosen();
        String wrong = offer.wrong(chosen.size());
        if (!wrong.isEmpty()) {
            return new Entry.Missing(wrong, !chosen.isEmpty());
        }
        List<Value> values = chosen.stream().map(i -> rows.get(i).row().value()).toList();
        return Entry.of(asList ? new ListValue(values) : values.get(0));
    }

    /** Chooses those that a value names; names that are not offered are ignored. */
    @Override
    protected void display(Value value) {
        List<Value> wanted = asList ? ((ListValue) value).items() : List.of(value);
        group.clearSelection();
        rows.forEach(
                view -> view.button().setSelected(wanted.contains(view.row().value())));
    }

    @Override
    protected void displayNothing() {
        group.clearSelection();
        rows.forEach(view -> view.button().setSelected(false));
    }

    @Override
    public void setEditable(boolean editable) {
        rows.forEach(view -> view.button().setEnabled(editable));
        several.setVisible(editable);
        message.setVisible(editable);
    }

    @Override
    protected void refresh() {
        message.show(entry());
        count.setText(chosen().size() + " of " + rows.size() + " chosen");
    }
}
