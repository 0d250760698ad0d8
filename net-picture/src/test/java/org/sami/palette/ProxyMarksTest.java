package org.sami.palette;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashSet;
import java.util.Set;
import org.junit.jupiter.api.Test;

class ProxyMarksTest {
    @Test
    void whoIsOnlyAskedAboutHasAMarkByName() {
        ProxyMarks marks = new ProxyMarks();
        marks.of("carl");
        marks.of("anna");

        assertThat(marks.of("anna").index()).isZero();
        assertThat(marks.of("carl").index()).isOne();
    }

    @Test
    void whoWasGivenAMarkKeepsItWhoeverComes() {
        ProxyMarks marks = new ProxyMarks();
        marks.of("carl");
        marks.give("dora");
        marks.give("bert");
        marks.of("anna");
        marks.give("dora");

        assertThat(marks.of("dora").index()).isZero();
        assertThat(marks.of("bert").index()).isOne();
        assertThat(marks.of("anna").index()).as("nobody gave it one").isEqualTo(2);
        assertThat(marks.of("carl").index()).isEqualTo(3);
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
