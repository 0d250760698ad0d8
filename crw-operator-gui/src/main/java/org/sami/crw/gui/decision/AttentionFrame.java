package org.sami.crw.gui.decision;

import java.util.Optional;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.border.Border;
import org.sami.crw.markup.Attention;
import org.sami.palette.SemanticColor;
import org.sami.ui.look.Look;
import org.sami.ui.look.LookColors;

/** The frame that draws attention to a component: lit, or lit every other half second. On the event thread. */
final class AttentionFrame {
    private static final int BLINK_MS = 500;
    private static final int WIDTH = 4;

    private final JComponent around;

    AttentionFrame(JComponent around) {
        this.around = around;
    }

    /** Shows it as it is now; called a few times a second. */
    void show(Optional<Attention> asked) {
        Optional<Attention> attention = asked.filter(one -> one.target() == Attention.Target.COMPONENT);
        boolean lit = attention.isPresent()
                && (attention.get().type() == Attention.Type.HIGHLIGHT
                        || System.nanoTime() / 1_000_000 / BLINK_MS % 2 == 0);
        LookColors.border(around, () -> frame(lit));
    }

    private static Border frame(boolean lit) {
        int width = Look.px(WIDTH);
        return lit
                ? BorderFactory.createLineBorder(SemanticColor.WARNING_FILL.get(), width)
                : BorderFactory.createEmptyBorder(width, width, width, width);
    }
}
