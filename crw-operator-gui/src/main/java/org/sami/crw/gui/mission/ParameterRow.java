package org.sami.crw.gui.mission;

import java.util.Optional;
import javax.swing.JCheckBox;
import javax.swing.JLabel;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.Value;
import org.sami.ui.look.LookColors;
import org.sami.ui.value.Entry;
import org.sami.ui.value.ValueEditor;

/**
 * One value of a plan's start: given now, or left to what the plan does about it. Whoever changes the value gives it. What was given the
 * last time is given again, as the ticked box says.
 */
final class ParameterRow extends JPanel {
    private final String name;
    private final ValueEditor editor;
    private final JCheckBox given;

    /**
     * A row.
     *
     * @param otherwise what happens where no value is given, in words
     * @param last the value of the last time
     * @param changed is run after each change
     */
    ParameterRow(String name, ValueEditor editor, String otherwise, Optional<Value> last, Runnable changed) {
        super(new MigLayout("insets 0, gap 4 2, fillx, wrap 1", "[grow,fill]"));
        this.name = name;
        this.editor = editor;
        setName(editor.field().componentName("row"));
        given = new JCheckBox(editor.field().label() + " (" + name + ")", last.isPresent());
        given.setName(editor.field().componentName("given"));
        given.setToolTipText("Ticked: this value is given at the start. Otherwise: " + otherwise);
        last.ifPresent(editor::show);
        JLabel instead = new JLabel(otherwise);
        LookColors.foreground(instead, SemanticColor.MUTED);
        add(given, "split 2, growx 0, hmin 40");
        add(instead, "wmin 0");
        add(editor.component(), "gapleft 24, hidemode 3");
        editor.component().setVisible(given.isSelected());
        instead.setVisible(!given.isSelected());
        given.addActionListener(e -> {
            editor.component().setVisible(given.isSelected());
            instead.setVisible(!given.isSelected());
            revalidate();
            if (given.isSelected()) {
                editor.focusTarget().requestFocusInWindow();
            }
            changed.run();
        });
        editor.addListener(changed);
    }

    /** The parameter's name. */
    String parameter() {
        return name;
    }

    /** The value that is given; empty where none is. */
    Optional<Value> value() {
        return given.isSelected() ? editor.entry().value() : Optional.empty();
    }

    /** Why the mission cannot start with what is entered here. */
    Optional<String> wrong() {
        return given.isSelected() && editor.entry() instanceof Entry.Missing missing
                ? Optional.of(editor.field().label() + ": " + missing.why())
                : Optional.empty();
    }
}
