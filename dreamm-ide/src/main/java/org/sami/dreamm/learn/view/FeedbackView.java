package org.sami.dreamm.learn.view;

import java.util.List;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Icons;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.look.Spacing;
import org.sami.ui.value.WrappedText;

/** What is said of an answer or a plan: a head with a sign, sentences, and buttons that lead on. */
final class FeedbackView extends JPanel {
    /** How an answer went. */
    enum Mood {
        /** It is right. */
        RIGHT(SemanticColor.OK, "check"),
        /** It is wrong. */
        WRONG(SemanticColor.CRITICAL, "close"),
        /** Something else is said. */
        NOTE(SemanticColor.ACCENT, "message");

        private final SemanticColor color;
        private final String icon;

        Mood(SemanticColor color, String icon) {
            this.color = color;
            this.icon = icon;
        }
    }

    /**
     * What is said.
     *
     * @param words a paragraph each
     * @param buttons below them
     */
    FeedbackView(String name, Mood mood, String head, List<String> words, List<? extends JComponent> buttons) {
        super(new ColumnLayout(Spacing.TIGHT + 2));
        setName(name);
        LookColors.background(this, SemanticColor.SURFACE_RAISED);
        LookColors.border(
                this,
                () -> BorderFactory.createCompoundBorder(
                        BorderFactory.createMatteBorder(0, Look.px(4), 0, 0, mood.color.get()),
                        BorderFactory.createEmptyBorder(Look.px(8), Look.px(10), Look.px(8), Look.px(8))));
        JLabel title = new JLabel(head, Icons.of(mood.icon, 18, mood.color), JLabel.LEADING);
        title.setName(name + "-head");
        title.setFont(org.sami.ui.look.Fonts.strong());
        LookColors.foreground(title, mood.color);
        add(title);
        for (int i = 0; i < words.size(); i++) {
            WrappedText text = new WrappedText(words.get(i));
            text.setName(name + "-words-" + (i + 1));
            add(text);
        }
        buttons.forEach(this::add);
        getAccessibleContext().setAccessibleName(head);
        getAccessibleContext().setAccessibleDescription(String.join(" ", words));
    }
}
