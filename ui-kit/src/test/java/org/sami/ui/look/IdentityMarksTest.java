package org.sami.ui.look;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class IdentityMarksTest {
    @Test
    void keepsTheMarkOfEachProxyInOrderOfAppearance() {
        IdentityMarks marks = new IdentityMarks();

        assertThat(marks.of("anna").index()).isZero();
        assertThat(marks.of("bert").index()).isOne();
        assertThat(marks.of("anna").index()).isZero();
    }

    @Test
    void noTwoOfSixtyProxiesLookTheSame() {
        Set<Object> seen = new HashSet<>();
        for (int i = 0; i < 60; i++) {
            IdentityMark mark = new IdentityMark(i);
            seen.add(mark.color() + " " + mark.shape());
            assertThat(Contrast.of(mark.ink(), mark.color())).isGreaterThanOrEqualTo(4.5);
        }

        assertThat(seen).hasSize(60);
        assertThat(new IdentityMark(12).color()).isEqualTo(new IdentityMark(0).color());
        assertThat(new IdentityMark(12).shape()).isNotEqualTo(new IdentityMark(0).shape());
    }
}
