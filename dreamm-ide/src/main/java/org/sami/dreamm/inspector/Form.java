package org.sami.dreamm.inspector;

import java.awt.event.FocusAdapter;
import java.awt.event.FocusEvent;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.DefaultListCellRenderer;
import javax.swing.JButton;
import javax.swing.JCheckBox;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JList;
import javax.swing.JPanel;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Spacing;
import org.sami.ui.look.StrongLabel;
import org.sami.ui.value.WrappedText;

/** Rows of labelled fields. A field gives what it holds when it is left or Enter is pressed; a choice at once. */
class Form extends JPanel {
    Form() {
        super(new MigLayout(
                "novisualpadding, insets 0, gap 8 4, fillx, wrap 2, hidemode 3", "[64:80:80, left][grow, fill]"));
        setOpaque(false);
    }

    final void heading(String text) {
        JLabel label = new StrongLabel(text);
        add(label, "span 2, growx, gaptop 6, wmin 0");
    }

    /** A part with a heading that profiles hide or lock as a whole, by its name. */
    final Form section(String name, String heading) {
        Form section = new Form();
        section.setName(name);
        section.heading(heading);
        wide(section);
        return section;
    }

    final WrappedText note(String text, SemanticColor color) {
        WrappedText note = new WrappedText(text);
        note.setColor(color);
        add(note, "span 2, growx, wmin 0");
        return note;
    }

    final void wide(JComponent component) {
        add(component, "span 2, growx, wmin 0");
    }

    final <C extends JComponent> C row(String label, String name, String tip, C field) {
        JLabel caption = new JLabel(label);
        caption.setToolTipText(tip.isEmpty() ? label : tip);
        caption.setLabelFor(field);
        field.setName(name);
        if (!tip.isEmpty()) {
            field.setToolTipText(tip);
        }
        field.getAccessibleContext().setAccessibleName(label);
        add(caption, "wmin 0");
        add(field, "wmin 0, hmin " + Spacing.HIT_TARGET);
        return field;
    }

    final JTextField text(String label, String name, String tip, String value, Consumer<String> given) {
        JTextField field = row(label, name, tip, new JTextField(value));
        field.setCaretPosition(0); // a long text is read from its beginning
        giveWhenLeft(field, value, given);
        return field;
    }

    static void giveWhenLeft(JTextField field, String value, Consumer<String> given) {
        Runnable give = () -> {
            if (!field.getText().equals(value)) {
                given.accept(field.getText());
            }
        };
        field.addActionListener(e -> give.run());
        field.putClientProperty(Pending.KEY, give);
        field.addFocusListener(new FocusAdapter() {
            @Override
            public void focusLost(FocusEvent e) {
                give.run();
            }
        });
    }

    final JCheckBox flag(String label, String name, String tip, boolean value, Consumer<Boolean> given) {
        JCheckBox box = new JCheckBox(label, value);
        box.setName(name);
        box.setToolTipText(tip);
        box.setOpaque(false);
        box.addActionListener(e -> given.accept(box.isSelected()));
        add(box, "span 2, growx, wmin 0");
        return box;
    }

    /** A choice; what is chosen now may be none of the options, where several elements differ. */
    final <T> JComboBox<T> choice(
            String label,
            String name,
            String tip,
            List<T> options,
            Optional<T> now,
            Function<T, String> words,
            Consumer<T> given) {
        return row(label, name, tip, combo(options, now, words, given));
    }

    static <T> JComboBox<T> combo(List<T> options, Optional<T> now, Function<T, String> words, Consumer<T> given) {
        return combo(options, now, words, words, given);
    }

    /** A choice whose open list says more than what is shown of the chosen one. */
    static <T> JComboBox<T> combo(
            List<T> options, Optional<T> now, Function<T, String> words, Function<T, String> brief, Consumer<T> given) {
        JComboBox<T> box = new JComboBox<>();
        List<T> all = new ArrayList<>(options);
        now.filter(n -> !all.contains(n)).ifPresent(all::add);
        all.forEach(box::addItem);
        box.setSelectedItem(now.orElse(null));
        box.setRenderer(new DefaultListCellRenderer() {
            @Override
            @SuppressWarnings("unchecked")
            public java.awt.Component getListCellRendererComponent(
                    JList<?> list, Object value, int index, boolean selected, boolean focus) {
                String text = value == null ? "(various)" : (index < 0 ? brief : words).apply((T) value);
                return super.getListCellRendererComponent(list, text, index, selected, focus);
            }
        });
        box.addActionListener(e -> {
            int chosen = box.getSelectedIndex();
            if (chosen >= 0 && !Optional.of(box.getItemAt(chosen)).equals(now)) {
                given.accept(box.getItemAt(chosen));
            }
        });
        return box;
    }

    static JButton button(String text, String name, String tip, Runnable pressed) {
        JButton button = new JButton(text);
        button.setName(name);
        button.setToolTipText(tip);
        button.getAccessibleContext().setAccessibleName(tip);
        if (text.length() == 1) {
            button.putClientProperty("JButton.buttonType", "toolBarButton");
        }
        button.addActionListener(e -> pressed.run());
        return button;
    }
}
