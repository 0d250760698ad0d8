package org.sami.ui.value;

import java.awt.event.MouseAdapter;
import java.awt.event.MouseEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import javax.swing.ButtonGroup;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JToggleButton;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.Value;
import org.sami.ui.look.Spacing;

/**
 * Solutions to compare, such as allocations or paths: a table of their figures, a button for each, and what each has in particular, one
 * after another, on tabs or one below another (components {@code OptionPager}, {@code OptionTabs}, {@code OptionStack}).
 */
final class SolutionChooser extends ValueChooser {
    private final List<Value> options;
    private final List<JToggleButton> buttons = new ArrayList<>();
    private final ButtonGroup group = new ButtonGroup();
    private final SolutionDetails details;
    private final FieldMessage message;
    private OptionalInt pointedAt = OptionalInt.empty();
    private Runnable lookedAt = () -> {};
    private final JPanel panel =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 4 4, fillx, hidemode 3, wrap 1", "[grow,fill]"));

    SolutionChooser(ValueField field, Offer offer, SolutionDetails details) {
        super(field);
        this.options = offer.values();
        this.details = details;
        details.onShown(() -> lookedAt.run());
        message = new FieldMessage(field);
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        panel.add(table(options.stream().map(Figures::of).toList()));
        panel.add(details.component(), "growy, pushy");
        panel.add(message);
        refresh();
    }

    private JComponent table(List<Figures> figures) {
        JPanel table =
                new JPanel(new MigLayout("novisualpadding, insets 0, gap 8 2, wrap " + (figures.size() + 1), "[]"));
        table.setOpaque(false);
        table.setName(field().componentName("figures"));
        table.add(new NoteLabel(figures.isEmpty() ? "There is nothing to choose from" : ""));
        for (int i = 0; i < figures.size(); i++) {
            table.add(button(i), "growx, hmin " + Spacing.HIT_TARGET_FIELD + ", wmin 56");
        }
        for (String label : Figures.compared(figures)) {
            table.add(new NoteLabel(label));
            figures.forEach(each -> table.add(new JLabel(each.figures().getOrDefault(label, "–")), "alignx right"));
        }
        return table;
    }

    private JToggleButton button(int option) {
        JToggleButton button = new ChoiceButton(String.valueOf(option + 1));
        button.setName(field().componentName("option-" + (option + 1)));
        button.setToolTipText("Choose option " + (option + 1) + " (key " + (option + 1) + ")");
        button.getAccessibleContext().setAccessibleName("Option " + (option + 1));
        button.addActionListener(event -> {
            details.show(option);
            changed();
        });
        button.addMouseListener(new MouseAdapter() {
            @Override
            public void mouseEntered(MouseEvent event) {
                point(OptionalInt.of(option));
            }

            @Override
            public void mouseExited(MouseEvent event) {
                point(OptionalInt.empty());
            }
        });
        group.add(button);
        buttons.add(button);
        return button;
    }

    /** The pointer is on the button of an option, or leaves it: meanwhile a map shows that option. */
    private void point(OptionalInt option) {
        pointedAt = option;
        lookedAt.run();
    }

    @Override
    OptionalInt looked() {
        return options.isEmpty() ? OptionalInt.empty() : OptionalInt.of(pointedAt.orElse(details.shown()));
    }

    @Override
    void look(int option) {
        details.show(option);
    }

    @Override
    void onLooked(Runnable listener) {
        lookedAt = listener;
    }

    @Override
    public int options() {
        return options.size();
    }

    @Override
    public List<Integer> chosen() {
        List<Integer> chosen = new ArrayList<>();
        for (int i = 0; i < buttons.size(); i++) {
            if (buttons.get(i).isSelected()) {
                chosen.add(i);
            }
        }
        return chosen;
    }

    @Override
    public void choose(int option) {
        if (buttons.get(option).isEnabled()) {
            buttons.get(option).setSelected(true);
            details.show(option);
            changed();
        }
    }

    @Override
    void leaveMessage() {
        panel.remove(message);
    }

    @Override
    void mark(int option) {
        buttons.get(option).setSelected(true);
        details.show(option);
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return buttons.isEmpty() ? panel : buttons.get(chosen().isEmpty() ? 0 : chosen().get(0));
    }

    @Override
    public Entry entry() {
        List<Integer> chosen = chosen();
        return chosen.isEmpty()
                ? Entry.nothing(options.size() == 1 ? "Choose option 1" : "Choose one of " + options.size())
                : Entry.of(options.get(chosen.get(0)));
    }

    @Override
    protected void display(Value value) {
        int option = options.indexOf(value);
        group.clearSelection();
        if (option >= 0) {
            buttons.get(option).setSelected(true);
            details.show(option);
        }
    }

    @Override
    protected void displayNothing() {
        group.clearSelection();
    }

    /** A large map shows the option that is looked at, and the small ones would say the same. */
    @Override
    public void useOwnMap(boolean shown) {
        details.showPictures(shown);
    }

    @Override
    public void setEditable(boolean editable) {
        buttons.forEach(button -> button.setEnabled(editable));
        message.setVisible(editable);
    }

    @Override
    protected void refresh() {
        message.show(entry());
    }
}
