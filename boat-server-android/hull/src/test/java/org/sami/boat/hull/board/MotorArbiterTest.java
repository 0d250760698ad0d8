package org.sami.boat.hull.board;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;

class MotorArbiterTest {
    private final MotorArbiter link = new MotorArbiter(
            HullSettings.of(HullKind.DIFFERENTIAL).safeMaximum(1).build());

    private void reports(long nowMs) {
        link.opened(nowMs);
        link.heard(nowMs);
        link.change(nowMs);
    }

    @Test
    void boardThatReportsIsCommandedWhatTheServerCommands() {
        reports(0);
        link.command(0.5, 0.25, 0);

        assertThat(link.motors(100).first()).isEqualTo(0.5);
        assertThat(link.motors(100).second()).isEqualTo(0.25);
    }

    @Test
    void silentBoardIsCommandedZeroUntilItIsBackAndThenGoesOn() {
        reports(0);
        link.command(0.5, 0.5, 0);
        link.command(0.5, 0.5, 1100);

        assertThat(link.change(1100)).contains(BoardState.SILENT);
        assertThat(link.motors(1100).areNone()).isTrue();

        link.heard(1200);
        assertThat(link.change(1200)).contains(BoardState.CONNECTED);
        assertThat(link.motors(1200).first()).isEqualTo(0.5);
    }

    @Test
    void lostPortIsToldOnce() {
        reports(0);
        link.lost();

        assertThat(link.change(50)).contains(BoardState.GONE);
        assertThat(link.change(100)).isEmpty();
        assertThat(link.motors(100).areNone()).isTrue();
    }

    @Test
    void portThatOpensAndIsDroppedAtOnceIsGoneAllTheTime() {
        reports(0);
        link.lost();
        assertThat(link.change(50)).contains(BoardState.GONE);
        link.opened(1000);

        assertThat(link.change(1100)).isEmpty();
        assertThat(link.motors(1100).areNone()).isTrue();
        assertThat(link.change(2100)).contains(BoardState.SILENT);
    }

    @Test
    void serverThatHangsStopsTheMotors() {
        reports(0);
        link.command(0.5, 0.5, 0);
        link.heard(1001);

        assertThat(link.motors(1001).areNone()).isTrue();
    }

    @Test
    void testOfAMotorDrivesOnlyWhileTheServerRests() {
        reports(0);
        link.command(0, 0, 0);

        assertThat(link.test(0.3, 0, 0, 2000)).isTrue();
        assertThat(link.motors(100).first()).isEqualTo(0.3);

        link.command(0.6, 0.6, 200);
        assertThat(link.motors(200).first()).isEqualTo(0.6);
        assertThat(link.test(0.3, 0, 300, 2000)).isFalse();
    }

    @Test
    void testOfAMotorEndsByItself() {
        reports(0);
        link.test(0.3, 0, 0, 500);
        link.command(0, 0, 400);

        assertThat(link.motors(500).areNone()).isTrue();
    }

    @Test
    void rudderIsTestedWithoutThrust() {
        MotorArbiter rudder =
                new MotorArbiter(HullSettings.of(HullKind.RUDDER).trim(0.1).build());
        rudder.opened(0);
        rudder.heard(0);
        rudder.change(0);
        rudder.test(1, -1, 0, 2000);

        assertThat(rudder.motors(100).first()).isZero();
        assertThat(rudder.motors(100).second()).isEqualTo(-1);
    }
}
