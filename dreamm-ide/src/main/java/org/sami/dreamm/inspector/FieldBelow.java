package org.sami.dreamm.inspector;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import javax.swing.JComboBox;
import javax.swing.JComponent;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.profile.ProfileGuard;
import org.sami.palette.SemanticColor;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.ValueField;
import org.sami.ui.value.WrappedText;

/** The part below a field's choice: an editor or a choice of its value, or a remark. */
final class FieldBelow extends JPanel {
    private static final String CHOOSE = "– choose –";

    private final transient FieldAt at;

    FieldBelow(FieldAt at) {
        super(new MigLayout("novisualpadding, insets 0, gap 0 4, fillx, wrap 1", "[grow, fill]"));
        this.at = at;
        setOpaque(false);
    }

    /** Puts an editor below the choice that it belongs to, in place of what stood there: keys choose each source that they pass. */
    void edit(Optional<Value> value, Consumer<Value> given) {
        removeAll();
        add(ProfileGuard.mark(editor(value, given), "event-field-value"), "wmin 0, gapbottom " + Spacing.TIGHT);
        revalidate();
        repaint();
    }

    private JComponent editor(Optional<Value> value, Consumer<Value> given) {
        boolean isText = value.map(TextValue.class::isInstance).orElse(true);
        return at.words().isEmpty() || !isText
                ? new ValueRow(at.context().values().editor(ValueField.of(at.field())), value, given)
                : choice(value.map(text -> ((TextValue) text).value()).orElse(""), given);
    }

    /** A choice among the words of the domain; another text that is there already stays one of them. */
    private JComponent choice(String now, Consumer<Value> given) {
        List<String> words = now.isEmpty()
                ? Stream.concat(Stream.of(""), at.words().stream()).toList()
                : at.words();
        JComboBox<String> box = Form.combo(words, Optional.of(now), word -> word.isEmpty() ? CHOOSE : word, word -> {
            if (!word.isEmpty()) {
                given.accept(new TextValue(word));
            }
        });
        box.setName(at.name() + "-value");
        box.setToolTipText(at.field().help());
        box.getAccessibleContext().setAccessibleName(ValueField.words(at.field().name()));
        return box;
    }

    void say(String text, SemanticColor color) {
        WrappedText line = new WrappedText(text);
        line.setColor(color);
        add(line, "wmin 0");
    }
}
