package org.sami.mavlink.vehicle;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;

class LinkChoiceTest {
    private static final MavlinkAddress ONE = AddressText.parse("mavlink:serial:/dev/ttyUSB0:57600");
    private static final MavlinkAddress OTHER = AddressText.parse("mavlink:serial:/dev/ttyUSB1:57600");

    private final LinkChoice choice = new LinkChoice();

    private static RadioSignals radios(int one, int other) {
        return new RadioSignals(Map.of(ONE, OptionalInt.of(one), OTHER, OptionalInt.of(other)));
    }

    private void bothHeard(int number) {
        choice.heard(ONE, number, number * 100L);
        choice.heard(OTHER, number, number * 100L + 10);
    }

    @Test
    void ofTwoRadiosThatLoseAsLittleTheStrongerIsUsedOnceItIsClearlyStronger() {
        bothHeard(1);
        assertThat(choice.chosen()).contains(ONE);

        choice.radios(radios(60, 90));
        bothHeard(2);
        assertThat(choice.chosen()).contains(ONE);

        choice.radios(radios(59, 90));
        choice.heard(ONE, 3, 300);
        assertThat(choice.heard(OTHER, 3, 310)).isEmpty(); // it was changed by what came on the first
        assertThat(choice.chosen()).contains(OTHER);
    }

    @ParameterizedTest
    @ValueSource(strings = {"mavlink:udp:14550?baud=57600", "mavlink:udp:14550"})
    void networkWithARadioInItIsUsedAfterOneWithout(String behindRouter) {
        MavlinkAddress routed = AddressText.parse(behindRouter);
        MavlinkAddress network = AddressText.parse("mavlink:udp:14551");
        if (routed.speedBaud().isEmpty()) {
            choice.radios(new RadioSignals(Map.of(routed, OptionalInt.empty()))); // it reports itself
        }
        choice.heard(routed, 1, 100);
        choice.heard(network, 1, 110);

        assertThat(choice.links(120))
                .containsExactly(new HeardLink(routed, 0, 100, true), new HeardLink(network, 0, 110, false));
        choice.heard(routed, 2, 2_000);
        choice.heard(network, 2, 2_010);
        choice.heard(network, 3, 5_000);
        assertThat(choice.chosen()).contains(network);
        choice.heard(routed, 3, 5_010);
        assertThat(choice.chosen()).as("the radio does not get it back").contains(network);
    }

    @Test
    void strongRadioThatLosesMoreIsNotUsed() {
        for (int i = 1; i < 60; i++) {
            choice.heard(ONE, i, i * 100L);
            choice.heard(OTHER, i * 2, i * 100L + 10);
        }
        choice.radios(radios(50, 200));
        choice.heard(ONE, 60, 6_000);

        assertThat(choice.chosen()).contains(ONE);
        assertThat(choice.links(6_000)).extracting(HeardLink::link).containsExactly(ONE, OTHER);
        assertThat(choice.links(6_000).get(1).lost()).isGreaterThan(0.4);
    }

    private static final MavlinkAddress NETWORK = AddressText.parse("mavlink:udp:14551");

    private void bothHeardFor(int fromMs, int toMs, int firstNumber) {
        for (int ms = fromMs, number = firstNumber; ms < toMs; ms += 100, number++) {
            choice.heard(NETWORK, number % 256, ms);
            choice.heard(ONE, number % 256, ms + 10);
        }
    }

    @ParameterizedTest
    @ValueSource(booleans = {false, true})
    void vehicleReturnsToTheNetworkSomeTimeAfterAHiccup(boolean radioReportsItself) {
        if (radioReportsItself) {
            choice.radios(new RadioSignals(Map.of(ONE, OptionalInt.of(180))));
        }
        bothHeardFor(0, 2_000, 0);
        assertThat(choice.chosen()).contains(NETWORK);
        for (int ms = 2_000, number = 20; ms < 6_000; ms += 100, number++) {
            choice.heard(ONE, number, ms + 10);
        }
        assertThat(choice.chosen()).as("the network is silent").contains(ONE);

        bothHeardFor(6_000, 14_000, 60);
        assertThat(choice.chosen()).as("it may be silent again soon").contains(ONE);
        bothHeardFor(14_000, 17_000, 140);
        assertThat(choice.chosen()).contains(NETWORK);
        assertThat(choice.links(17_000)).extracting(HeardLink::link).containsExactly(NETWORK, ONE);
    }

    @Test
    void networkThatLosesMoreThanTheRadioDoesNotGetTheVehicleBack() {
        bothHeardFor(0, 2_000, 0);
        for (int ms = 2_000, number = 20; ms < 30_000; ms += 100, number++) {
            if (ms < 6_000 || number % 10 != 0) {
                choice.heard(ONE, number % 256, ms + 10);
            }
            if (ms >= 6_000 && number % 6 != 0) { // a sixth is lost
                choice.heard(NETWORK, number % 256, ms);
            }
        }

        assertThat(choice.chosen()).contains(ONE);
    }
}
