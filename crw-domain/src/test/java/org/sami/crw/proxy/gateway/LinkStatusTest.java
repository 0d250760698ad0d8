package org.sami.crw.proxy.gateway;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;

class LinkStatusTest {
    private static LinkStatus radio(boolean used, double lost, long silentMs, double filled) {
        return new LinkStatus(
                "mavlink:serial:/dev/ttyUSB0:57600",
                used,
                lost,
                silentMs,
                Optional.empty(),
                Optional.of(180),
                Optional.empty(),
                230.4,
                OptionalDouble.of(filled));
    }

    @Test
    void radioInUseSaysLossSignalAndWhatIsAskedOfTheLink() {
        assertThat(radio(true, 0.004, 100, 0.04).words())
                .isEqualTo("in use, 0.4 % lost, radio 180 here and - there, 230 bytes/s asked, 4 % of the link");
        assertThat(radio(true, 0, 100, 1.2).words()).endsWith("120 % of the link: too many vehicles");
    }

    @Test
    void radioThatIsNotUsedSaysOnlyHowItIsHeard() {
        assertThat(radio(false, 0, 7_400, 0.04).words()).isEqualTo("ready, silent for 7 s, radio 180 here and - there");
    }

    @Test
    void silentLossyAndFullLinksAreNotGood() {
        assertThat(radio(true, 0.1, 1_000, 0.7).isGood()).isTrue();
        assertThat(radio(true, 0.2, 1_000, 0.7).isGood()).isFalse();
        assertThat(radio(true, 0, 5_001, 0.7).isGood()).isFalse();
        assertThat(radio(true, 0, 0, 1.01).isGood()).isFalse();
    }
}
