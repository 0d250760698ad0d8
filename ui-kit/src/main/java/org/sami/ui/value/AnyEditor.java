package org.sami.ui.value;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.TypeCheck;
import org.sami.spn.value.TypeNames;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** A value of any type: first its type is chosen, then it is given as one of that type. */
final class AnyEditor extends ValueEditor {
    private final Map<String, NamedType> declarations;
    private final Function<ValueField, ValueEditor> makes;
    private final List<ValueType> types = new ArrayList<>();
    private final JComboBox<String> typeBox = new JComboBox<>();
    private final JPanel panel =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 4 2, fillx, wrap 1", "[grow,fill]"));
    private ValueEditor current;
    private boolean editable = true;

    AnyEditor(ValueField field, Map<String, NamedType> declarations, Function<ValueField, ValueEditor> makes) {
        super(field);
        this.declarations = declarations;
        this.makes = makes;
        for (ValueType.Simple simple : ValueType.Simple.values()) {
            if (simple != ValueType.Simple.ANY) {
                types.add(simple);
            }
        }
        types.add(new ValueType.ListOf(ValueType.Simple.POINT));
        types.add(new ValueType.ListOf(ValueType.Simple.PROXY));
        types.add(new ValueType.ListOf(ValueType.Simple.TEXT));
        declarations.keySet().stream().sorted().map(ValueType.Named::new).forEach(types::add);
        types.forEach(type -> typeBox.addItem(TypeNames.of(type)));
        typeBox.setSelectedIndex(types.indexOf(ValueType.Simple.TEXT));
        typeBox.setName(field.componentName("type"));
        typeBox.getAccessibleContext().setAccessibleName("Type of " + field.label());
        panel.setOpaque(false);
        panel.setName(field.componentName(""));
        panel.add(typeBox, "growx 0, hmin 32");
        take(ValueType.Simple.TEXT);
        typeBox.addActionListener(event -> {
            take(types.get(typeBox.getSelectedIndex()));
            changed();
        });
    }

    private void take(ValueType type) {
        if (current != null) {
            panel.remove(current.component());
        }
        current = makes.apply(field().as(type));
        current.setEditable(editable);
        current.addListener(this::changed);
        panel.add(current.component());
        panel.revalidate();
    }

    @Override
    public JComponent component() {
        return panel;
    }

    @Override
    public JComponent focusTarget() {
        return current.focusTarget();
    }

    @Override
    public Entry entry() {
        return current.entry();
    }

    /** Shows a value as one of the first type that has it. */
    @Override
    protected void display(Value value) {
        ValueType type = typeOf(value)
                .orElseThrow(() -> new IllegalArgumentException("There is no type for " + ValueSummary.of(value)));
        typeBox.setSelectedIndex(types.indexOf(type));
        current.show(value);
    }

    private Optional<ValueType> typeOf(Value value) {
        return types.stream()
                .filter(type -> TypeCheck.accepts(type, value, declarations))
                .findFirst();
    }

    @Override
    protected void displayNothing() {
        current.clear();
    }

    @Override
    public void setEditable(boolean editable) {
        this.editable = editable;
        typeBox.setEnabled(editable);
        current.setEditable(editable);
    }
}
