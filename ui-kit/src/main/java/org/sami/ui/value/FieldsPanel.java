package org.sami.ui.value;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.Value;

/** Several named values, one below the other, each with its label above: what a record or a question asks. A question may ask for none. */
public final class FieldsPanel {
    private final Map<String, ValueEditor> editors;
    private final List<Runnable> listeners = new ArrayList<>();
    private final JPanel panel =
            new JPanel(new MigLayout("novisualpadding, insets 0, gap 4 2, fillx, wrap 1", "[grow,fill]"));

    FieldsPanel(Map<String, ValueEditor> editors) {
        this.editors = Collections.unmodifiableMap(new LinkedHashMap<>(editors));
        panel.setOpaque(false);
        for (ValueEditor editor : editors.values()) {
            JLabel label = new JLabel(editor.field().label());
            label.setName(editor.field().componentName("label"));
            label.setLabelFor(editor.focusTarget());
            if (!editor.field().help().isEmpty()) {
                label.setToolTipText(editor.field().help());
            }
            panel.add(label, panel.getComponentCount() == 0 ? "" : "gaptop 6");
            panel.add(editor.component());
            editor.addListener(() -> listeners.forEach(Runnable::run));
        }
        if (editors.isEmpty()) {
            WrappedText nothing = new WrappedText("There is nothing to fill in: the answer says that it is done.");
            nothing.setName("value-nothing");
            nothing.setColor(SemanticColor.MUTED);
            panel.add(nothing, "wmin 60");
        }
    }

    /** What is put into a window. */
    public JComponent component() {
        return panel;
    }

    /** Where the keyboard's focus goes first: the first field that has no value, else the first; the panel where there is no field. */
    public JComponent focusTarget() {
        return editors.values().stream()
                .filter(editor -> editor.entry().value().isEmpty())
                .findFirst()
                .or(() -> editors.values().stream().findFirst())
                .map(ValueEditor::focusTarget)
                .orElse(panel);
    }

    /** The editors by the names of their values, in order. */
    public Map<String, ValueEditor> editors() {
        return editors;
    }

    /** The values by name; empty as long as one is missing. */
    public Optional<Map<String, Value>> values() {
        Map<String, Value> values = new LinkedHashMap<>();
        editors.forEach((name, editor) -> editor.entry().value().ifPresent(value -> values.put(name, value)));
        return values.size() == editors.size() ? Optional.of(values) : Optional.empty();
    }

    /** Why a value is missing, of the first one that is, with the name of its field. */
    public Optional<Entry.Missing> missing() {
        for (ValueEditor editor : editors.values()) {
            if (editor.entry() instanceof Entry.Missing missing) {
                return Optional.of(new Entry.Missing(editor.field().label() + ": " + missing.why(), missing.wrong()));
            }
        }
        return Optional.empty();
    }

    /** Whether the operator has changed something. */
    public boolean isTouched() {
        return editors.values().stream().anyMatch(ValueEditor::isTouched);
    }

    /** Whether values can be given, or are only shown. */
    public void setEditable(boolean editable) {
        editors.values().forEach(editor -> editor.setEditable(editable));
    }

    /** Adds a listener that is called after each change. */
    public void addListener(Runnable listener) {
        listeners.add(listener);
    }
}
