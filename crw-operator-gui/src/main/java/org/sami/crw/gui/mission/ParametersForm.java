package org.sami.crw.gui.mission;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JTextField;
import javax.swing.event.DocumentEvent;
import javax.swing.event.DocumentListener;
import net.miginfocom.swing.MigLayout;
import org.sami.crw.sim.run.Parameters;
import org.sami.ui.look.SemanticColor;

/** What a plan asks at its start, as text; it says what does not fit before it is started. What is left empty is asked later. */
final class ParametersForm extends JPanel {
    private final Parameters parameters;
    private final Map<String, JTextField> fields = new LinkedHashMap<>();
    private final JLabel wrong = new JLabel(" ");
    private final JButton start = new JButton("Start mission");

    /**
     * A form.
     *
     * @param last the texts of the last time, by name
     * @param started is given the texts, which can be read
     */
    ParametersForm(Parameters parameters, Map<String, String> last, Consumer<Map<String, String>> started) {
        super(new MigLayout("wrap 3", "[][grow, 320::][]", ""));
        this.parameters = parameters;
        setName("mission-values");
        for (Parameters.Description each : parameters.describe()) {
            if (each.editable()) {
                JTextField field = new JTextField(last.getOrDefault(each.name(), ""), 30);
                field.setName("mission-value-" + each.name().replaceAll("[^A-Za-z0-9]+", "-"));
                field.putClientProperty(
                        "JTextField.placeholderText",
                        each.preset().map(Object::toString).orElse("asked as the mission goes"));
                field.getDocument().addDocumentListener(new Check());
                JLabel label = new JLabel(each.name());
                label.setLabelFor(field);
                JLabel type = new JLabel(each.type());
                type.setForeground(SemanticColor.MUTED.get());
                fields.put(each.name(), field);
                add(label);
                add(field, "growx");
                add(type);
            }
        }
        if (fields.isEmpty()) {
            add(new JLabel("This plan asks nothing at its start."), "span");
        }
        wrong.setForeground(SemanticColor.CRITICAL.get());
        wrong.setName("mission-values-wrong");
        start.setName("mission-values-start");
        start.addActionListener(e -> started.accept(texts()));
        add(wrong, "span 2, growx, wmin 0");
        add(start, "hmin 40");
        check();
    }

    JButton startButton() {
        return start;
    }

    private Map<String, String> texts() {
        Map<String, String> texts = new LinkedHashMap<>();
        fields.forEach((name, field) -> texts.put(name, field.getText().strip()));
        return texts;
    }

    private void check() {
        Map<String, String> given = texts();
        given.values().removeIf(String::isEmpty);
        Optional<String> fault = Optional.empty();
        try {
            parameters.read(given);
        } catch (IllegalArgumentException unfit) {
            fault = Optional.of(unfit.getMessage());
        }
        wrong.setText(fault.map(text -> "▲ " + text).orElse(" "));
        start.setEnabled(fault.isEmpty());
        start.setToolTipText(fault.orElse("Start the mission with these values (Enter)"));
    }

    private final class Check implements DocumentListener {
        @Override
        public void insertUpdate(DocumentEvent e) {
            check();
        }

        @Override
        public void removeUpdate(DocumentEvent e) {
            check();
        }

        @Override
        public void changedUpdate(DocumentEvent e) {
            check();
        }
    }
}
