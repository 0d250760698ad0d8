package org.sami.spn.value;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class TextNumbersTest {
    @Test
    void numbersAreReadWithBlanksAround() {
        assertThat(TextNumbers.real(" 0.25 ")).hasValue(0.25);
        assertThat(TextNumbers.whole(" -3", -5, 5)).hasValue(-3);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "two", "NaN", "Infinity", "1,5"})
    void whatIsNoFiniteNumberIsNone(String text) {
        assertThat(TextNumbers.real(text)).isEmpty();
        assertThat(TextNumbers.whole(text, Long.MIN_VALUE, Long.MAX_VALUE)).isEmpty();
    }

    @Test
    void aNumberBeyondItsLimitsIsNone() {
        assertThat(TextNumbers.real("85.1", -85, 85)).isEmpty();
        assertThat(TextNumbers.real("-85", -85, 85)).hasValue(-85);
        assertThat(TextNumbers.whole("6", 1, 5)).isEmpty();
        assertThat(TextNumbers.whole("99999999999999999999", 1, Long.MAX_VALUE)).isEmpty();
    }
}
