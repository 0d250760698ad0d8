package org.sami.ui.look;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.awt.Insets;
import javax.swing.BorderFactory;
import javax.swing.JLabel;
import javax.swing.JPanel;
import javax.swing.SwingUtilities;
import javax.swing.border.MatteBorder;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.sami.palette.SemanticColor;
import org.sami.palette.Theme;

@Isolated("the look is one for all windows of a process")
class LookColorsTest {
    private final JPanel panel = new JPanel();
    private final JLabel label = new JLabel("text");

    @AfterEach
    void back() {
        Look.apply(Theme.LIGHT, 100);
    }

    private void change(Theme theme, int percent) {
        Look.apply(theme, percent);
        SwingUtilities.updateComponentTreeUI(panel);
    }

    @Test
    void coloursAndBordersAreThoseOfEachLookThatComes() {
        panel.add(label);
        LookColors.foreground(label, SemanticColor.MUTED);
        LookColors.background(label, SemanticColor.SURFACE_RAISED);
        LookColors.border(
                panel, () -> BorderFactory.createMatteBorder(0, 0, Look.px(2), 0, SemanticColor.BORDER.get()));

        for (Theme theme : new Theme[] {Theme.DARK, Theme.SUN, Theme.LIGHT}) {
            change(theme, 150);

            assertThat(label.getForeground()).isEqualTo(SemanticColor.MUTED.in(theme));
            assertThat(label.getBackground()).isEqualTo(SemanticColor.SURFACE_RAISED.in(theme));
            MatteBorder line = (MatteBorder) panel.getBorder();
            assertThat(line.getMatteColor()).isEqualTo(SemanticColor.BORDER.in(theme));
            assertThat(line.getBorderInsets()).isEqualTo(new Insets(0, 0, 3, 0));
        }
    }

    @Test
    void theColourThatWasGivenLastIsKept() {
        panel.add(label);
        LookColors.foreground(label, SemanticColor.MUTED);
        LookColors.foreground(label, SemanticColor.CRITICAL);

        change(Theme.DARK, 100);

        Color critical = SemanticColor.CRITICAL.in(Theme.DARK);
        assertThat(label.getForeground()).isEqualTo(critical);
    }
}
