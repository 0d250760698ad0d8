package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Font;
import java.awt.Insets;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Supplier;
import javax.swing.BorderFactory;
import javax.swing.JComponent;
import javax.swing.JPanel;
import javax.swing.RepaintManager;
import javax.swing.SwingUtilities;
import javax.swing.text.BadLocationException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.palette.Theme;
import org.sami.ui.look.Fonts;
import org.sami.ui.look.Look;

@Isolated("the look is one for all windows of a process")
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

    @Test
    void theBorderThatItIsGivenStaysWithAnotherLook() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            WrappedText wrapped = new WrappedText("What the plan does");
            wrapped.setBorder(BorderFactory.createEmptyBorder(8, 12, 8, 12));

            wrapped.updateUI();

            assertThat(wrapped.getInsets()).isEqualTo(new Insets(8, 12, 8, 12));
        });
    }

    @Test
    void aTextThatALayoutHasMadeTooNarrowForItsLinesAsksForMoreHeightAfterwards() throws Exception {
        Set<JComponent> asking = new HashSet<>();
        RepaintManager usual = RepaintManager.currentManager(null);
        WrappedText[] wrapped = new WrappedText[1];
        try {
            SwingUtilities.invokeAndWait(() -> {
                JPanel panel = new JPanel(null);
                wrapped[0] = new WrappedText("Nothing waits for you. The most urgent question appears here.");
                panel.add(wrapped[0]);
                wrapped[0].setSize(1000, 1000);
                int line = wrapped[0].getPreferredSize().height;
                RepaintManager.setCurrentManager(new RepaintManager() {
                    @Override
                    public synchronized void addInvalidComponent(JComponent one) {
                        asking.add(one);
                    }
                });

                wrapped[0].setBounds(0, 0, 900, line);
                wrapped[0].setBounds(0, 0, 200, line);

                asking.clear(); // what is asked while a layout is under way is lost
            });
            SwingUtilities.invokeAndWait(() -> assertThat(asking).contains(wrapped[0]));
        } finally {
            RepaintManager.setCurrentManager(usual);
        }
    }

    @Test
    void itsSizeIsThatOfANewOneAfterEachChange() throws Exception {
        SwingUtilities.invokeAndWait(() -> {
            WrappedText wrapped = new WrappedText("boat1 does not answer");
            Look.apply(Theme.LIGHT, 100);
            for (int width : new int[] {300, 90, 200}) {
                for (String text :
                        List.of("boat1 does not answer", "It goes for 3182 m at most, and then it comes home")) {
                    for (Supplier<Font> letters : List.<Supplier<Font>>of(Fonts::text, Fonts::title)) {
                        wrapped.setSize(width, 1000);
                        wrapped.setText(text);
                        wrapped.setFont(letters.get());
                        WrappedText fresh = new WrappedText("");
                        fresh.setText(text);
                        fresh.setFont(letters.get());
                        fresh.setSize(width, 1000);

                        assertThat(wrapped.getPreferredSize()).isEqualTo(fresh.getPreferredSize());
                        assertThat(wrapped.getPreferredSize()).isEqualTo(fresh.getPreferredSize());
                    }
                }
            }
            int before = wrapped.getPreferredSize().height;
            try {
                Look.apply(Theme.LIGHT, 200);
                SwingUtilities.updateComponentTreeUI(wrapped);
                assertThat(wrapped.getPreferredSize().height).isGreaterThan(before);
            } finally {
                Look.apply(Theme.LIGHT, 100);
            }
        });
    }
}
