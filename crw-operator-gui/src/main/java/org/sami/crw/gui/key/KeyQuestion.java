package org.sami.crw.gui.key;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.JPasswordField;
import javax.swing.JTextField;
import net.miginfocom.swing.MigLayout;
import org.sami.ui.value.WrappedText;

/** A question about keys, asked in place: what will happen, fields, the answer, and a button that leaves all as it is. */
final class KeyQuestion extends JPanel {
    private final Map<String, JTextField> fields = new LinkedHashMap<>();
    private final Runnable left;
    private final JButton leave = new JButton("Leave it");

    KeyQuestion(String words, Runnable left) {
        super(new MigLayout("novisualpadding, insets 0, gap 8, fillx, wrap 2", "[][grow,fill]"));
        setName("keys-question");
        setOpaque(false);
        this.left = left;
        WrappedText text = new WrappedText(words);
        text.setName("keys-question-words");
        add(text, "span, growx, wmin 60");
    }

    KeyQuestion withText(String name, String words, String offered) {
        return field(name, words, new JTextField(offered, 40));
    }

    KeyQuestion withPassword(String name, String words) {
        return field(name, words, new JPasswordField(40));
    }

    private KeyQuestion field(String name, String words, JTextField field) {
        field.setName("keys-" + name);
        field.getAccessibleContext().setAccessibleName(words);
        JLabel label = new JLabel(words);
        label.setLabelFor(field);
        fields.put(name, field);
        add(label);
        add(field, "hmin 40, wmin 60");
        return this;
    }

    /** The answer, also by Enter in a field. */
    KeyQuestion withAnswer(String words, Consumer<KeyQuestion> answer) {
        JButton does = new JButton(words);
        does.setName("keys-answer");
        does.addActionListener(e -> answer.accept(this));
        fields.values().forEach(field -> field.addActionListener(e -> does.doClick(0)));
        leave.setName("keys-leave");
        leave.addActionListener(e -> left.run());
        add(leave, "skip 1, split 2, grow 0, hmin 40");
        add(does, "gapleft push, grow 0, hmin 40");
        return this;
    }

    void focusFirst() {
        fields.values().stream()
                .findFirst()
                .ifPresentOrElse(JTextField::requestFocusInWindow, leave::requestFocusInWindow);
    }

    String text(String name) {
        return field(name).getText().strip();
    }

    private JTextField field(String name) {
        return Optional.ofNullable(fields.get(name)).orElseThrow(() -> new IllegalArgumentException(name));
    }

    /** The file that is named; empty where the text cannot be one. */
    Optional<Path> path(String name) {
        try {
            return text(name).isEmpty() ? Optional.empty() : Optional.of(Path.of(text(name)));
        } catch (InvalidPathException unfit) {
            return Optional.empty();
        }
    }

    /** What was typed, which the field forgets. */
    char[] password(String name) {
        JPasswordField field = (JPasswordField) field(name);
        char[] typed = field.getPassword();
        field.setText("");
        return typed;
    }
}
