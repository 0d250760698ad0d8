package org.sami.ui.value;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.Value;

/** Which robot does which task, one row a task; a task may be nobody's (component {@code AllocationTable}, type map of task and proxy). */
final class AssignmentTable extends ValueEditor {
    private static final int MOST_HEIGHT = 320;
    private static final String NOBODY = "Nobody";

    private final List<ChoiceRow> robots;
    private final Map<Value, JComboBox<String>> boxes = new LinkedHashMap<>();
    private final ScrolledColumn column = new ScrolledColumn(
            new MigLayout("novisualpadding, insets 4, gap 8 2, fillx, wrap 2", "[][grow,fill]"), MOST_HEIGHT);
    private final JPanel panel =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 4 2, fillx, hidemode 3, wrap 1", "[grow,fill]"));
    private final FieldMessage message;
    private boolean editable = true;

    AssignmentTable(ValueField field, List<ChoiceRow> tasks, List<ChoiceRow> robots) {
        super(field);
        this.robots = robots;
        message = new FieldMessage(field);
        tasks.forEach(this::addRow);
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        panel.add(column.scrolled(), "hmin 44");
        panel.add(message);
        refresh();
    }

    private void addRow(ChoiceRow task) {
        List<String> names = new ArrayList<>(List.of(NOBODY));
        robots.forEach(robot -> names.add(robot.title()));
        JComboBox<String> box = new JComboBox<>(names.toArray(String[]::new));
        box.setName(field().componentName("task-" + (boxes.size() + 1)));
        box.getAccessibleContext().setAccessibleName("Who does " + task.title());
        box.setToolTipText(task.detail().isEmpty() ? null : task.detail());
        box.setEnabled(editable);
        box.addActionListener(event -> changed());
        JLabel label = new JLabel(task.title());
        label.setLabelFor(box);
        column.add(label);
        column.add(box, "hmin 32");
        boxes.put(task.value(), box);
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return boxes.isEmpty() ? panel : boxes.values().iterator().next();
    }

    @Override
    public Entry entry() {
        Map<Value, Value> map = new LinkedHashMap<>();
        boxes.forEach((task, box) -> {
            if (box.getSelectedIndex() > 0) {
                map.put(task, robots.get(box.getSelectedIndex() - 1).value());
            }
        });
        return boxes.isEmpty() ? Entry.nothing("There is no task to allocate") : Entry.of(new MapValue(map));
    }

    /** Shows an allocation; tasks in it that were not known get a row, robots that are not known are left out. */
    @Override
    protected void display(Value value) {
        Map<Value, Value> shown = ((MapValue) value).entries();
        shown.keySet().stream()
                .filter(task -> !boxes.containsKey(task))
                .toList()
                .forEach(task -> addRow(new ChoiceRow(task, ValueSummary.of(task), "")));
        boxes.forEach((task, box) -> box.setSelectedIndex(
                Optional.ofNullable(shown.get(task)).map(this::indexOf).orElse(0)));
    }

    private int indexOf(Value robot) {
        for (int i = 0; i < robots.size(); i++) {
            if (robots.get(i).value().equals(robot)) {
                return i + 1;
            }
        }
        return 0;
    }

    @Override
    protected void displayNothing() {
        boxes.values().forEach(box -> box.setSelectedIndex(0));
    }

    @Override
    public void setEditable(boolean editable) {
        this.editable = editable;
        boxes.values().forEach(box -> box.setEnabled(editable));
        message.setVisible(editable);
    }

    @Override
    protected void refresh() {
        message.show(entry());
    }
}
