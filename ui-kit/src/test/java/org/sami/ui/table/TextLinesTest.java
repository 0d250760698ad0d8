package org.sami.ui.table;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.FontMetrics;
import java.util.concurrent.atomic.AtomicInteger;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.sami.ui.look.Fonts;

class TextLinesTest {
    private final JLabel label = new JLabel();
    private final FontMetrics metrics = label.getFontMetrics(Fonts.text());

    private int widthOf(String text) {
        return metrics.stringWidth(text);
    }

    @Test
    void aLongWordIsBrokenBehindItsHyphens() {
        assertThat(TextLines.of("W-VARIABLE-UNREAD", metrics, widthOf("W-VARIABLE-UNREA"), 4))
                .containsExactly("W-VARIABLE-", "UNREAD");
    }

    @Test
    void aMinusIsNotTakenForAHyphen() {
        assertThat(TextLines.of("from 12 to -5", metrics, widthOf("from 12 to -"), 4))
                .containsExactly("from 12 to", "-5");
    }

    @Test
    void aWordWithoutHyphensIsBrokenWhereTheLineIsFull() {
        assertThat(TextLines.of("VARIABLEUNREAD", metrics, widthOf("VARIABLE"), 4))
                .containsExactly("VARIABLE", "UNREAD");
    }

    @Test
    void namesThatDifferAtTheirEndsAreToldApartWhereTheyDoNotFit() {
        int room = widthOf("127.0.0.1:60");

        String first = TextLines.withEnd("127.0.0.1:60111", metrics, room);
        String second = TextLines.withEnd("127.0.0.1:60112", metrics, room);

        assertThat(first).startsWith("12").contains("…").endsWith(":60111");
        assertThat(second).endsWith(":60112");
        assertThat(widthOf(first)).isLessThanOrEqualTo(room);
        assertThat(TextLines.withEnd("127.0.0.1", metrics, room)).isEqualTo("127.0.0.1");
        assertThat(TextLines.withEnd("127.0.0.1", metrics, 1)).isEqualTo("…");
    }

    @Test
    void aSingleLineIsCutWhereItIsFull() {
        assertThat(TextLines.of("one twothree", metrics, widthOf("one two…"), 1))
                .containsExactly("one two…");
        assertThat(TextLines.of("one\ntwo", metrics, widthOf("one two"), 1)).containsExactly("one…");
    }

    @Test
    void whereThereWouldBeMoreLinesTheLastOneEndsInDots() {
        assertThat(TextLines.of("one two three", metrics, widthOf("two…"), 2)).containsExactly("one", "two…");
    }

    /** Tables cut their words at each layout: a letter at a time, that was a tenth of what a busy window works. */
    @Test
    void aLongTextIsCutAfterFewMeasurings() {
        AtomicInteger measured = new AtomicInteger();
        FontMetrics counting = new FontMetrics(Fonts.text()) {
            @Override
            public int stringWidth(String text) {
                measured.incrementAndGet();
                return metrics.stringWidth(text);
            }
        };
        String text = "Wavelength".repeat(40);

        String shortened =
                TextLines.of(text, counting, widthOf("WavelengthWave…"), 1).get(0);

        assertThat(shortened).isEqualTo("WavelengthWave…");
        assertThat(TextLines.withEnd(text, counting, widthOf(shortened))).hasSizeBetween(10, 16);
        assertThat(measured).hasValueLessThan(30);
    }
}
