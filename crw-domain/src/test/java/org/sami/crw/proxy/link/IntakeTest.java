package org.sami.crw.proxy.link;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Frame;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.Telemetry;

class IntakeTest {
    private final Intake intake = new Intake();
    private long sequence;

    private boolean takes(LinkMessage message, long nowMs) {
        return intake.takes(new Frame(sequence++, "", message), nowMs);
    }

    private static SensorReport reading(String channel, int values) {
        return new SensorReport("sonde", channel, Collections.nCopies(values, 1.5), "m", 45, 10, 0);
    }

    private static Telemetry pose(BoatMode mode) {
        return new Telemetry(45, 10, 0, 1, 90, mode, 0);
    }

    @Test
    void boatWithTenPosesASecondAndTenChannelsAtTenHertzIsTakenWholeForAnHour() {
        for (long ms = 0; ms < 3_600_000; ms += 100) {
            assertThat(takes(pose(BoatMode.PATH), ms)).isTrue();
            for (int channel = 0; channel < 10; channel++) {
                assertThat(takes(reading("c" + channel, 1), ms)).isTrue();
            }
            assertThat(intake.news(ms)).isEmpty();
        }
    }

    @Test
    void whatABoatSaysAtOnceAfterTenSecondsOfSilenceIsTakenWhole() {
        for (int i = 0; i < 1000; i++) {
            assertThat(takes(reading("c" + i % 10, 1), 10_000)).isTrue();
        }
        for (int i = 0; i < 100; i++) {
            assertThat(takes(pose(BoatMode.PATH), 10_000)).isTrue();
        }
    }

    @Test
    void answersAreTakenHoweverManyComeAndWhateverElseDoes() {
        for (int i = 0; i < 10_000; i++) {
            takes(reading("c" + i, 64), 5);
            assertThat(takes(new Ack("c"), 5)).isTrue();
        }
    }

    @Test
    void lastOfManyBatteryReportsComesThroughAndTheOthersAreCounted() {
        int taken = 0;
        for (int i = 0; i < 1000; i++) {
            taken += takes(new BatteryReport(90, BatteryLevel.NOMINAL), 0) ? 1 : 0;
        }
        BatteryReport last = new BatteryReport(5, BatteryLevel.CRITICAL);
        taken += takes(last, 0) ? 1 : 0;
        assertThat(intake.due(100)).isEmpty();

        List<Frame> due = intake.due(500);
        assertThat(due).singleElement().extracting(Frame::message).isSameAs(last);
        assertThat(intake.due(60_000)).isEmpty();
        assertThat(intake.news(500).orElseThrow().total() + taken + 1).isEqualTo(1001);
    }

    @Test
    void whatWasKeptOfALinkThatIsGoneIsForgotten() {
        for (int i = 0; i < 1000; i++) {
            takes(pose(BoatMode.PATH), 0);
        }
        intake.linkEnded();

        assertThat(intake.due(10_000)).isEmpty();
    }

    @Test
    void channelsBeyondTheBoundAreLeftOutAndTheFirstOnesGoOn() {
        for (int i = 0; i < 100; i++) {
            assertThat(takes(reading("c" + i, 1), 0)).isEqualTo(i < Intake.MOST_CHANNELS);
        }
        assertThat(takes(reading("c3", 1), 0)).isTrue();
        assertThat(intake.news(0).orElseThrow().words("anna"))
                .isEqualTo("anna sends more than this base takes; left out so far: "
                        + "36 readings of channels beyond the first 64");
    }

    @Test
    void longProfilesCountByTheirValues() {
        int taken = 0;
        for (long ms = 0; ms < 100_000; ms++) {
            taken += takes(reading("profile", 64), ms) ? 1 : 0;
        }
        assertThat(taken).isBetween(1600, 1800);
    }

    @Test
    void floodIsToldAtOnceThenOnceASecondAndIsOverAfterTenSecondsWithAllThatWasLeftOut() {
        int told = 0;
        for (long ms = 0; ms < 5000; ms++) {
            takes(reading("c", 64), ms);
            Optional<LeftOut> news = intake.news(ms);
            told += news.isPresent() ? 1 : 0;
            news.ifPresent(one -> assertThat(one.active()).isTrue());
        }
        assertThat(told).isBetween(4, 6);
        assertThat(intake.news(6000)).isPresent();
        assertThat(intake.news(14_000)).isEmpty();
        LeftOut over = intake.news(15_000).orElseThrow();
        assertThat(over.active()).isFalse();
        assertThat(over.words("anna")).startsWith("anna no longer sends more than this base takes; left out were ");
        assertThat(intake.news(60_000)).isEmpty();

        for (int i = 0; i < 4000; i++) {
            takes(reading("c", 1), 60_000);
        }
        LeftOut again = intake.news(60_000).orElseThrow();
        assertThat(again.total()).as("counted anew").isEqualTo(4000 - 2000);
    }
}
