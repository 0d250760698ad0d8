package org.sami.crw.sim.board;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.hull.settings.HullKind;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.crw.sim.hull.SensorSetting;
import org.sami.spn.value.GeoPoint;

class SimulatedBoardTest {
    private static final String AHEAD = "{\"m0\":{\"v\":0.5},\"m1\":{\"v\":0.5}}";
    private static final BoardSettings SETTINGS = BoardSettings.at(GeoPoint.of(45.4, 10.9), 1);

    private final List<String> lines = new ArrayList<>();

    /** Lets seconds pass in steps of 50 ms; a command ten times a second, or none where it is empty. */
    private void pass(SimulatedBoard board, long fromMs, long toMs, String command, boolean cable) {
        for (long ms = fromMs; ms < toMs; ms += 50) {
            if (cable) {
                board.powered(ms);
            }
            if (!command.isEmpty() && ms % 100 == 0) {
                board.take(command, ms);
            }
            board.pass(ms);
            lines.addAll(board.lines(ms));
        }
    }

    @Test
    void armsASecondAfterCommandsComeAndDrives() {
        SimulatedBoard board = new SimulatedBoard(SETTINGS);
        pass(board, 0, 900, AHEAD, true);
        assertThat(board.isArmed(900)).isFalse();
        assertThat(board.hull().speedMps()).isZero();

        pass(board, 900, 5000, AHEAD, true);
        assertThat(board.hull().speedMps()).isCloseTo(1.6, within(0.1));
    }

    @Test
    void silentCommanderStopsTheMotorsAndTheyStayArmed() {
        SimulatedBoard board = new SimulatedBoard(SETTINGS);
        pass(board, 0, 5000, AHEAD, true);
        pass(board, 5000, 12_000, "", true);

        assertThat(board.hull().speedMps()).isZero();
        assertThat(board.isArmed(12_000)).isTrue();
        pass(board, 12_000, 12_500, AHEAD, true);
        assertThat(board.hull().speedMps()).isPositive();
    }

    @Test
    void pulledCableDisarmsAndCommandsArmAgain() {
        SimulatedBoard board = new SimulatedBoard(SETTINGS);
        pass(board, 0, 5000, AHEAD, true);
        pass(board, 5000, 6000, "", false);
        assertThat(board.isArmed(6000)).isFalse();

        pass(board, 6000, 8000, AHEAD, true);
        assertThat(board.isArmed(8000)).isTrue();
    }

    @Test
    void saysMotorsTenTimesASecondAndBatteryOnce() {
        pass(new SimulatedBoard(SETTINGS), 0, 10_000, "", true);

        assertThat(lines)
                .filteredOn(line -> line.startsWith("{\"m0\":{\"v\":0.000,\"c\":0.00},\"m1\""))
                .hasSize(100);
        assertThat(lines)
                .filteredOn(line -> line.equals("{\"s4\":{\"type\":\"battery\",\"data\":\"16.800 0.000 0.000\"}}"))
                .hasSize(10);
    }

    @Test
    void measuresWhatTheBoardsSensorsMeasure() {
        Conditions water = new Conditions(
                0,
                0,
                Flow.NONE,
                Flow.NONE,
                List.of(
                        SensorSetting.parse("temperature"),
                        SensorSetting.parse("conductivity"),
                        SensorSetting.parse("oxygen"),
                        SensorSetting.parse("ph")));
        pass(new SimulatedBoard(SETTINGS.on(water)), 0, 1000, "", true);

        assertThat(lines)
                .anyMatch(line -> line.matches("\\{\"s1\":\\{\"type\":\"es2\",\"data\":\"[0-9.]+ [0-9.]+\"}}"))
                .anyMatch(line -> line.startsWith("{\"s2\":{\"type\":\"atlas_do\",\"data\":\""))
                .anyMatch(line -> line.startsWith("{\"s3\":{\"type\":\"atlas_ph\",\"data\":\""));
    }

    @Test
    void rudderHullTurnsToStarboardWithItsServoDownAndTakesNoReverse() {
        SimulatedBoard board = new SimulatedBoard(SETTINGS.with(HullKind.RUDDER));
        pass(board, 0, 4000, "{\"m0\":{\"v\":0.5},\"s0\":{\"p\":-0.5}}", true);
        assertThat(board.hull().turnRateRadPerS()).isPositive();

        pass(board, 4000, 14_000, "{\"m0\":{\"v\":-0.5},\"s0\":{\"p\":0}}", true);
        assertThat(board.hull().speedMps()).isZero();
    }

    @Test
    void whatTheParserHasNoRoomForIsAnError() {
        SimulatedBoard board = new SimulatedBoard(SETTINGS);
        board.take("{\"m0\":{\"v\":" + "0".repeat(250) + "}}", 0);
        board.take("{\"m0\":{\"v\":", 0);

        assertThat(board.lines(0))
                .contains(
                        "{\"error\":\"buffer overflow\",\"args\":\"263\"}",
                        "{\"error\":\"cannot parse\",\"args\":\"\"}");
    }
}
