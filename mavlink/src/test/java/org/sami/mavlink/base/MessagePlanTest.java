package org.sami.mavlink.base;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.mavlink.address.AddressText;
import org.sami.mavlink.address.MavlinkAddress;

class MessagePlanTest {
    private static final MavlinkAddress RADIO = AddressText.parse("mavlink:serial:/dev/ttyUSB0:57600");
    private static final MavlinkAddress NETWORK = AddressText.parse("mavlink:udp:14550");

    private static double positionEveryS(MessagePlan plan) {
        return plan.messages().stream()
                .filter(message -> message.number() == 33)
                .findFirst()
                .orElseThrow()
                .everyS();
    }

    @ParameterizedTest
    @CsvSource({"1, false", "5, false", "25, false", "25, true", "100, false"})
    void reportsNeverFillMoreOfASlowLinkThanTheirPart(int vehicles, boolean signed) {
        MessagePlan plan = MessagePlan.of(RADIO, vehicles, signed);

        assertThat(plan.filledPart().orElseThrow()).isLessThanOrEqualTo(MessagePlan.FILLED_PART + 1e-9);
    }

    @Test
    void twentyFiveVehiclesOnOneRadioReportLessOftenThanOne() {
        assertThat(positionEveryS(MessagePlan.of(RADIO, 1, false))).isEqualTo(0.25);
        assertThat(positionEveryS(MessagePlan.of(RADIO, 25, false))).isBetween(0.4, 1.5);
        assertThat(MessagePlan.of(RADIO, 25, false).filledPart().orElseThrow())
                .isCloseTo(MessagePlan.FILLED_PART, within(0.01));
    }

    @Test
    void changedMissionIsNoticedWithinTwoSecondsAlsoWithTwentyFiveVehicles() {
        assertThat(MessagePlan.of(RADIO, 25, false).messages())
                .filteredOn(message -> message.name().equals("MISSION_CURRENT"))
                .singleElement()
                .extracting(AskedMessage::everyS)
                .isEqualTo(1.8);
    }

    @Test
    void networksCarryAll() {
        MessagePlan plan = MessagePlan.of(NETWORK, 25, false);

        assertThat(positionEveryS(plan)).isEqualTo(0.25);
        assertThat(plan.filledPart()).isEmpty();
    }

    @Test
    void networkBehindWhichThereIsARadioIsFilledAsThatIs() {
        MavlinkAddress routed = AddressText.parse("mavlink:udp:14550?baud=57600");

        assertThat(MessagePlan.of(routed, 25, false)).isEqualTo(MessagePlan.of(RADIO, 25, false));
    }

    @Test
    void moreVehiclesThanHeartbeatsFitAreSaid() {
        assertThat(MessagePlan.of(RADIO, 400, false).filledPart().orElseThrow()).isGreaterThan(1);
    }
}
