package org.sami.crw.sim.experiment.statistics;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Means and tests of published data: W. S. Gosset's hours of sleep ("Student", The probable error of a mean, Biometrika 6, 1908). */
class StudentTestTest {
    private static final Sample DRUG_1 = sample(0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0);
    private static final Sample DRUG_2 = sample(1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4);

    private static Sample sample(double... values) {
        return new Sample(Arrays.stream(values).boxed().toList());
    }

    @Test
    void meansAndStandardErrorsAreThoseOfThePaper() {
        assertThat(DRUG_1.mean()).hasValueCloseTo(0.75, within(1e-9));
        assertThat(DRUG_2.mean()).hasValueCloseTo(2.33, within(1e-9));
        assertThat(DRUG_1.variance()).hasValueCloseTo(3.200556, within(1e-6));
        assertThat(DRUG_1.standardError()).hasValueCloseTo(0.565734, within(1e-6));
    }

    @Test
    void pairedTestIsGossets() {
        StudentTest test = StudentTest.paired(DRUG_1, DRUG_2).orElseThrow();

        assertThat(test.t()).isCloseTo(-4.0621, within(1e-4));
        assertThat(test.degreesOfFreedom()).isEqualTo(9);
        assertThat(test.p()).isCloseTo(0.002833, within(1e-6));
        assertThat(test.isSignificant()).isTrue();
    }

    @Test
    void twoSampleTestOfTheSameDataFindsNoDifference() {
        StudentTest test = StudentTest.twoSample(DRUG_1, DRUG_2).orElseThrow();

        assertThat(test.t()).isCloseTo(-1.8608, within(1e-4));
        assertThat(test.degreesOfFreedom()).isCloseTo(17.776, within(1e-3));
        assertThat(test.p()).isCloseTo(0.07939, within(1e-5));
        assertThat(test.isSignificant()).isFalse();
    }

    @Test
    void samplesWithoutScatterDifferOrDoNot() {
        Sample three = sample(3, 3, 3);

        assertThat(StudentTest.paired(three, sample(2, 2, 2)).orElseThrow().p()).isZero();
        assertThat(StudentTest.twoSample(three, sample(2, 2)).orElseThrow().t()).isInfinite();
        assertThat(StudentTest.paired(three, three).orElseThrow().p()).isEqualTo(1);
    }

    @Test
    void oneValueIsNotEnoughForATest() {
        assertThat(StudentTest.paired(sample(1), sample(2))).isEmpty();
        assertThat(StudentTest.twoSample(sample(1), sample(2, 3))).isEmpty();
        assertThat(new Sample(List.of()).mean()).isEmpty();
        assertThat(sample(1).standardError()).isEmpty();
        assertThatThrownBy(() -> StudentTest.paired(sample(1, 2), sample(1)))
                .isInstanceOf(IllegalArgumentException.class);
    }

    @Test
    void quantilesAreInterpolated() {
        Sample four = sample(4, 1, 3, 2);

        assertThat(four.quantile(0)).hasValue(1);
        assertThat(four.quantile(0.25)).hasValueCloseTo(1.75, within(1e-9));
        assertThat(four.quantile(0.5)).hasValueCloseTo(2.5, within(1e-9));
        assertThat(four.quantile(1)).hasValue(4);
    }
}
