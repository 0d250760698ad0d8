package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import javax.swing.SwingUtilities;
import javax.swing.text.BadLocationException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WrappedTextTest {
    @ParameterizedTest
    @ValueSource(
            strings = {
                "It goes for 3182 m at most",
                "A charge of 97 % is left",
                "At 1.5 m/s it takes 35 min",
                "22498 m² are left"
            })
    void aNumberAndItsUnitStandInOneLineAtAnyWidth(String text) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            WrappedText wrapped = new WrappedText(text);
            for (int width = 90; width < 400; width += 5) {
                wrapped.setSize(width, 1000);
                for (int at = 1; at < text.length(); at++) {
                    if (text.charAt(at) == ' ' && Character.isDigit(text.charAt(at - 1))) {
                        assertThat(line(wrapped, at + 1))
                                .as("line of what follows character %d at width %d", at, width)
                                .isEqualTo(line(wrapped, at - 1));
                    }
                }
            }
            assertThat(wrapped.getText()).isEqualTo(text);
        });
    }

    private static double line(WrappedText wrapped, int at) {
        try {
            return wrapped.modelToView2D(at).getY();
        } catch (BadLocationException e) {
            throw new AssertionError(e);
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"3 boats wait", "4 missions, 2 sensors", "no number at all"})
    void otherTextsAreAsTheyWere(String text) throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            WrappedText wrapped = new WrappedText(text);
            wrapped.selectAll();

            assertThat(wrapped.getDocument().getLength()).isEqualTo(text.length());
            assertThat(wrapped.getSelectedText()).isEqualTo(text);
        });
    }
}
