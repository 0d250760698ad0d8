package org.sami.dreamm.help.word;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.KeyboardFocusManager;
import java.awt.Rectangle;
import java.awt.Window;
import java.util.List;
import java.util.Objects;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.MenuElement;
import javax.swing.MenuSelectionManager;
import org.sami.dreamm.context.DreammContext;
import org.sami.lessons.course.Glossary;
import org.sami.lessons.course.Term;
import org.sami.palette.SemanticColor;
import org.sami.ui.command.Command;
import org.sami.ui.command.PopupWindow;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;
import org.sami.ui.window.WindowSettings;

/** The commands that explain words: those of what has the focus, by a key, and whether those under the pointer are explained. */
public final class WordCommands implements AutoCloseable {
    private static final String SETTING = "words-hover";
    private static final String OFF = "off";

    private final DreammContext context;
    private final Words words;
    private final WordHover hover;

    /** Explains words from now on, in all windows of the process. */
    public WordCommands(DreammContext context, GlossaryAccess access) {
        this.context = Objects.requireNonNull(context, "context");
        words = new Words(access, context.background());
        hover = new WordHover(words);
    }

    /** Adds the commands to the window's. */
    public void addTo(Window owner, WindowSettings settings) {
        hover.setOn(!settings.text(SETTING).equals(OFF));
        context.commands()
                .add(new Command("words-here", "Explain the words here", () -> explainHere(owner))
                        .withKey("ctrl F1")
                        .withIcon("help")
                        .always()); // Swing has that key for the tooltip of each component, which is on the card
        context.commands()
                .add(new Command("words-hover", "Explain words under the pointer, or not", () -> {
                            hover.setOn(!hover.isOn());
                            settings.keep(SETTING, hover.isOn() ? "" : OFF);
                            context.notices()
                                    .show(
                                            hover.isOn()
                                                    ? "Words under the pointer are explained"
                                                    : "Words under the pointer are not explained; Ctrl+F1 explains those of what has the focus");
                        })
                        .withKey("ctrl shift F1")
                        .withIcon("message"));
    }

    private void explainHere(Window owner) {
        hover.hide();
        Component focused = focused();
        ShownText spoken = ShownText.all(focused == null ? "" : ShownWords.of(focused), new Rectangle());
        words.find(spoken, (glossary, terms) -> {
            if (terms.isEmpty()) {
                context.notices()
                        .refused("No word of the course's glossary is here; select something, or go to a field");
            } else {
                PopupWindow.open(owner, "Words", close -> card(glossary, terms, close));
            }
        });
    }

    /** The item of an open menu, else what has the focus. */
    private static Component focused() {
        MenuElement[] path = MenuSelectionManager.defaultManager().getSelectedPath();
        return path.length > 0
                ? path[path.length - 1].getComponent()
                : KeyboardFocusManager.getCurrentKeyboardFocusManager().getPermanentFocusOwner();
    }

    private JComponent card(Glossary glossary, List<Term> terms, Runnable close) {
        WordCard card = new WordCard(words, glossary, terms, "", close);
        JLabel leave = new JLabel("Escape closes");
        leave.setName("word-leave");
        leave.setFont(Fonts.text());
        leave.setBorder(BorderFactory.createEmptyBorder(0, Look.px(12), Look.px(8), Look.px(12)));
        LookColors.foreground(leave, SemanticColor.MUTED);
        JPanel all = new JPanel(new BorderLayout());
        LookColors.background(all, SemanticColor.SURFACE_RAISED);
        LookColors.border(all, () -> BorderFactory.createLineBorder(SemanticColor.ACCENT.get(), Look.px(2)));
        card.setBorder(null);
        all.add(card);
        all.add(leave, BorderLayout.SOUTH);
        return all;
    }

    @Override
    public void close() {
        hover.close();
    }
}
