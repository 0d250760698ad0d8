package org.sami.ui.table;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class TooltipLinesTest {

    @Test
    void aShortTextIsOneLine() {
        assertThat(TooltipLines.of("The operator chooses boats.")).isEqualTo("The operator chooses boats.");
        assertThat(TooltipLines.of("")).isEmpty();
    }

    @Test
    void aLongTextHasLinesOfWholeWordsAndLosesNone() {
        String text = "A boat goes to its place and looks from time to time how far it has drifted. "
                .repeat(5)
                .strip();

        String lines = TooltipLines.of(text);

        assertThat(lines.lines())
                .hasSizeGreaterThan(4)
                .allSatisfy(line -> assertThat(line.length()).isBetween(40, 80));
        assertThat(lines.replace('\n', ' ')).isEqualTo(text);
    }

    @Test
    void aWordThatIsLongerHasALineOfItsOwn() {
        assertThat(TooltipLines.of("see " + "x".repeat(100) + " there").lines())
                .containsExactly("see", "x".repeat(100), "there");
    }
}
