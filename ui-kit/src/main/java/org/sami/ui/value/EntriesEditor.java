package org.sami.ui.value;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** A map, each entry with an editor for its key and one for its value. */
final class EntriesEditor extends PartsEditor<EntriesEditor.Pair> {
    /** One entry while it is edited. */
    record Pair(ValueEditor key, ValueEditor value, JComponent component) {}

    private final Function<ValueField, ValueEditor> makesKey;
    private final Function<ValueField, ValueEditor> makesValue;

    EntriesEditor(
            ValueField field,
            Function<ValueField, ValueEditor> makesKey,
            Function<ValueField, ValueEditor> makesValue) {
        super(field, "Add an entry");
        this.makesKey = makesKey;
        this.makesValue = makesValue;
        refresh();
    }

    @Override
    Pair makePart(int number) {
        ValueType.MapOf type = (ValueType.MapOf) field().type();
        ValueEditor key = makesKey.apply(field().part(number + ".key", "For", type.key()));
        ValueEditor value = makesValue.apply(field().part(number + ".value", "Value", type.value()));
        key.addListener(this::changed);
        value.addListener(this::changed);
        JPanel both =
                new JPanel(new MigLayout("novisualpadding, insets 0 0 8 0, gap 4 2, fillx, wrap 1", "[grow,fill]"));
        both.setOpaque(false);
        both.add(label(key));
        both.add(key.component());
        both.add(label(value));
        both.add(value.component());
        return new Pair(key, value, both);
    }

    private static JLabel label(ValueEditor editor) {
        JLabel label = new JLabel(editor.field().label());
        label.setName(editor.field().componentName("label"));
        label.setLabelFor(editor.focusTarget());
        return label;
    }

    @Override
    JComponent componentOf(Pair part) {
        return part.component();
    }

    @Override
    JComponent focusOf(Pair part) {
        return part.key().focusTarget();
    }

    @Override
    void setPartEditable(Pair part, boolean editable) {
        part.key().setEditable(editable);
        part.value().setEditable(editable);
    }

    @Override
    public Entry entry() {
        Map<Value, Value> entries = new LinkedHashMap<>();
        int number = 0;
        for (Pair part : parts()) {
            number++;
            if (part.key().entry() instanceof Entry.Missing missing) {
                return new Entry.Missing("Entry " + number + ": " + missing.why(), missing.wrong());
            }
            if (part.value().entry() instanceof Entry.Missing missing) {
                return new Entry.Missing("Entry " + number + ": " + missing.why(), missing.wrong());
            }
            Value key = part.key().entry().value().orElseThrow();
            if (entries.put(key, part.value().entry().value().orElseThrow()) != null) {
                return Entry.wrong("Entry " + number + ": there is another entry for " + ValueSummary.of(key));
            }
        }
        return Entry.of(new MapValue(entries));
    }

    @Override
    protected void display(Value value) {
        removeAllParts();
        ((MapValue) value).entries().forEach((key, one) -> {
            Pair pair = append();
            pair.key().show(key);
            pair.value().show(one);
        });
    }

    @Override
    protected void displayNothing() {
        removeAllParts();
    }
}
