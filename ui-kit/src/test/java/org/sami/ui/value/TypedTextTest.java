package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;

/** What is typed and what is written of it, without a window. */
class TypedTextTest {
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            90           | 90000   | 1 min 30 s
            1.5 h        | 5400000 | 1 h 30 min
            1 h 5s       | 3605000 | 1 h 5 s
            1:30         | 90000   | 1 min 30 s
            2:00:00.5    | 7200500 | 2 h 500 ms
            250 ms       | 250     | 250 ms
            1,5 min      | 90000   | 1 min 30 s
            1 d          | 86400000| 24 h
            0            | 0       | 0 s
            """)
    void durationsAreReadInTheirUnits(String typed, long millis, String written) {
        DurationText form = new DurationText();

        assertThat(form.read(typed)).isEqualTo(Entry.of(new DurationValue(millis)));
        assertThat(form.write(new DurationValue(millis))).isEqualTo(written);
        assertThat(form.read(written)).isEqualTo(Entry.of(new DurationValue(millis)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            5 weeks | "weeks" is no unit of time; units are ms, s, min, h and d
            soon    | "soon" is not a duration; one is 1 min 30 s
            -5 s    | "-5 s" is not a duration; one is 1 min 30 s
            9999999 h | A duration of more than a year is too long
            """)
    void whatIsNoDurationIsTold(String typed, String reason) {
        assertThat(new DurationText().read(typed)).isEqualTo(Entry.wrong(reason));
    }

    @Test
    void numbersAreWrittenAsTheyAreRead() {
        NumberText metres = new NumberText(false, "m");

        for (double value : new double[] {0, -0.0, 1, -2.5, 1e-9, 123456789.123, 1e20, Double.MIN_VALUE}) {
            assertThat(metres.read(metres.write(new RealValue(value))).value())
                    .contains(new RealValue(value == 0 ? 0 : value));
        }
        assertThat(metres.read("1e3 m")).isEqualTo(Entry.of(new RealValue(1000)));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            ''                   | false | Enter a whole number in boats, such as 10
            2.5                  | true  | Enter a whole number, such as 3
            99999999999999999999 | true  | The number is too large
            1 2                  | true  | "1 2" is not a whole number in boats; one is 10
            """)
    void whatIsNoWholeNumberIsTold(String typed, boolean wrong, String reason) {
        assertThat(new NumberText(true, "boats").read(typed)).isEqualTo(new Entry.Missing(reason, wrong));
    }

    @Test
    void aWholeNumberMayHaveAFractionOfNothing() {
        assertThat(new NumberText(true, "").read("3.0")).isEqualTo(Entry.of(new IntegerValue(3)));
    }

    @ParameterizedTest
    @CsvSource({
        "numberToCreate,Number to create",
        "event-1.startLocation,Start location",
        "@bay,Bay",
        "rudderP,Rudder P",
        "boatID,Boat ID"
    })
    void namesBecomeWords(String name, String words) {
        assertThat(ValueField.words(name)).isEqualTo(words);
    }
}
