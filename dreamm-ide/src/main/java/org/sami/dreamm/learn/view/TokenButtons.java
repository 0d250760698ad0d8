package org.sami.dreamm.learn.view;

import java.util.List;
import java.util.function.Consumer;
import javax.swing.JButton;
import javax.swing.JPanel;
import net.miginfocom.swing.MigLayout;
import org.sami.dreamm.learn.TokenDraft;
import org.sami.palette.ProxyMarks;
import org.sami.spn.protocol.Token;
import org.sami.ui.look.MarkIcon;
import org.sami.ui.look.Spacing;

/** The tokens that can be put into the place at which the picture's cursor stands; their keys are the digits. */
final class TokenButtons extends JPanel {
    TokenButtons(List<Token> tokens, ProxyMarks marks, Consumer<Token> put, Runnable clear) {
        super(new MigLayout("insets 0, gap " + Spacing.TIGHT + ", wrap 4"));
        setOpaque(false);
        setName("learn-tokens");
        for (int i = 0; i < tokens.size(); i++) {
            Token token = tokens.get(i);
            JButton button = button("learn-token-" + (i + 1), (i + 1) + "  " + TokenDraft.name(token));
            button.setToolTipText(
                    token.equals(Token.GENERIC)
                            ? "Put a generic token into the chosen place (" + (i + 1) + ")"
                            : "Put it into the chosen place, or take it out (" + (i + 1) + ")");
            if (token instanceof Token.Proxy robot) {
                button.setIcon(new MarkIcon(marks.of(robot.proxy())));
            }
            button.addActionListener(e -> put.accept(token));
            add(button, "hmin " + Spacing.HIT_TARGET);
        }
        JButton empty = button("learn-token-clear", "Empty the place");
        empty.setToolTipText("Take all tokens out of the chosen place (Delete)");
        empty.addActionListener(e -> clear.run());
        add(empty, "hmin " + Spacing.HIT_TARGET);
    }

    private static JButton button(String name, String words) {
        JButton button = new JButton(words);
        button.setName(name);
        return button;
    }

    /** Whether the buttons can be used. */
    void setUsable(boolean usable) {
        for (var each : getComponents()) {
            each.setEnabled(usable);
        }
    }
}
