package org.sami.ui.value;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Function;
import javax.swing.JComponent;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** A list whose elements are each given with an editor of their own. */
final class RepeatedEditor extends PartsEditor<ValueEditor> {
    private final Function<ValueField, ValueEditor> makes;

    RepeatedEditor(ValueField field, Function<ValueField, ValueEditor> makes) {
        super(field, "Add one");
        this.makes = makes;
        refresh();
    }

    @Override
    ValueEditor makePart(int number) {
        ValueType element = ((ValueType.ListOf) field().type()).element();
        ValueEditor editor = makes.apply(field().part(String.valueOf(number), "Number " + number, element));
        editor.addListener(this::changed);
        return editor;
    }

    @Override
    JComponent componentOf(ValueEditor part) {
        return part.component();
    }

    @Override
    JComponent focusOf(ValueEditor part) {
        return part.focusTarget();
    }

    @Override
    void setPartEditable(ValueEditor part, boolean editable) {
        part.setEditable(editable);
    }

    @Override
    public Entry entry() {
        List<Value> values = new ArrayList<>();
        for (ValueEditor part : parts()) {
            if (part.entry() instanceof Entry.Missing missing) {
                return new Entry.Missing("Number " + (values.size() + 1) + ": " + missing.why(), missing.wrong());
            }
            values.add(part.entry().value().orElseThrow());
        }
        return Entry.of(new ListValue(values));
    }

    @Override
    protected void display(Value value) {
        removeAllParts();
        ((ListValue) value).items().forEach(item -> append().show(item));
    }

    @Override
    protected void displayNothing() {
        removeAllParts();
    }
}
