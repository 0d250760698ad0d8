package org.sami.mavlink.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;

class LinkChoiceTest {
    private static final MavlinkAddress ONE = AddressText.parse("mavlink:serial:/dev/ttyUSB0:57600");
    private static final MavlinkAddress OTHER = AddressText.parse("mavlink:serial:/dev/ttyUSB1:57600");

    private final LinkChoice choice = new LinkChoice();

    private void bothHeard(int number) {
        choice.heard(ONE, number, number * 100L);
        choice.heard(OTHER, number, number * 100L + 10);
    }

    @Test
    void ofTwoRadiosThatLoseAsLittleTheStrongerIsUsedOnceItIsClearlyStronger() {
        bothHeard(1);
        assertThat(choice.chosen()).contains(ONE);

        choice.strengths(Map.of(ONE, 60, OTHER, 90));
        bothHeard(2);
        assertThat(choice.chosen()).contains(ONE);

        choice.strengths(Map.of(ONE, 59, OTHER, 90));
        choice.heard(ONE, 3, 300);
        assertThat(choice.heard(OTHER, 3, 310)).isEmpty(); // it was changed by what came on the first
        assertThat(choice.chosen()).contains(OTHER);
    }

    @Test
    void strongRadioThatLosesMoreIsNotUsed() {
        for (int i = 1; i < 60; i++) {
            choice.heard(ONE, i, i * 100L);
            choice.heard(OTHER, i * 2, i * 100L + 10);
        }
        choice.strengths(Map.of(ONE, 50, OTHER, 200));
        choice.heard(ONE, 60, 6_000);

        assertThat(choice.chosen()).contains(ONE);
        assertThat(choice.links(6_000)).extracting(HeardLink::link).containsExactly(ONE, OTHER);
        assertThat(choice.links(6_000).get(1).lost()).isGreaterThan(0.4);
    }
}
