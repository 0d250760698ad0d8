package org.sami.ui.value;

import java.util.Optional;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.Value;

/** One solution to look at: its figures and what each entry says (component {@code AllocationTable}, type {@code Allocation}). */
final class SolutionView extends ValueEditor {
    private final JPanel panel =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 8 2, fillx, wrap 2", "[][grow,fill]"));
    private final Function<Value, RobotWays> ways;
    private Optional<Value> shown = Optional.empty();

    /**
     * A view that shows nothing yet.
     *
     * @param ways on which the robots of a solution would go
     */
    SolutionView(ValueField field, Function<Value, RobotWays> ways) {
        super(field);
        this.ways = ways;
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        displayNothing();
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return panel;
    }

    @Override
    public Entry entry() {
        return shown.map(Entry::of).orElse(Entry.nothing("There is nothing to show yet"));
    }

    @Override
    protected void display(Value value) {
        shown = Optional.of(value);
        panel.removeAll();
        Figures.of(value).figures().forEach((label, text) -> SolutionLines.line(panel, label, text));
        SolutionLines.add(panel, value, ways.apply(value));
        panel.revalidate();
    }

    @Override
    protected void displayNothing() {
        shown = Optional.empty();
        panel.removeAll();
        panel.add(new JLabel("There is nothing to show yet"), "span 2");
        panel.revalidate();
    }

    @Override
    public void setEditable(boolean editable) {
        // it is only ever shown
    }
}
