package org.sami.ui.look;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.FontMetrics;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ElidedTextTest {
    private static final String NAME = "Proxy Station Keep Request Of Three Boats";
    private static final FontMetrics METRICS = metrics();

    private static FontMetrics metrics() {
        JLabel label = new JLabel();
        return label.getFontMetrics(label.getFont());
    }

    @Test
    void textThatFitsStaysWhole() {
        assertThat(ElidedText.middle(NAME, METRICS, METRICS.stringWidth(NAME))).isEqualTo(NAME);
    }

    @ParameterizedTest
    @ValueSource(ints = {40, 90, 140, 200})
    void longTextKeepsItsBeginningAndItsEnd(int width) {
        String shown = ElidedText.middle(NAME, METRICS, width);

        assertThat(METRICS.stringWidth(shown)).isLessThanOrEqualTo(width);
        assertThat(shown).startsWith("P").contains("…").endsWith("s");
    }

    @Test
    void oneLetterStaysWhereThereIsNoRoomAtAll() {
        assertThat(ElidedText.middle(NAME, METRICS, 0)).isEqualTo("P…");
    }
}
