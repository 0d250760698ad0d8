package org.sami.boat.hull.board;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.hull.position.PositionFilter;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.boat.server.vehicle.Sensor;

/** A board on streams that vanish, come back, fall silent and send garbage; threads and times are the real ones. */
@Timeout(900)
class BoardVehicleTest {
    private static final String MOTORS = "{\"m0\":{\"v\":0.1,\"c\":0.2},\"m1\":{\"v\":0.1,\"c\":0.2}}";
    private static final String ZERO = "{\"m0\":{\"v\":0.000},\"m1\":{\"v\":0.000}}";
    private static final String HALF = "{\"m0\":{\"v\":0.500},\"m1\":{\"v\":0.500}}";

    private final TestBoard board = new TestBoard();
    private final List<String> news = new CopyOnWriteArrayList<>();
    private final AtomicBoolean reporting = new AtomicBoolean(true);
    private final BoardVehicle vehicle = new BoardVehicle(
            HullSettings.of(HullKind.DIFFERENTIAL).safeMaximum(1).build(),
            new PositionFilter(),
            board,
            new SteadyClock(ProcessClock::ms),
            new BoardListener() {
                @Override
                public void stateChanged(BoardState state, String why) {
                    news.add(state + " " + why);
                }

                @Override
                public void boardError(String error, String arguments) {
                    news.add("error " + error);
                }
            });
    private final Thread reports = new Thread(this::report, "test-board-reports");
    private volatile double effort;
    private volatile boolean ended;

    /** The board reports and the boat server commands, ten times a second. */
    private void report() {
        while (!ended) {
            if (reporting.get()) {
                board.say(MOTORS);
            }
            vehicle.setMotors(effort, effort);
            LockSupport.parkNanos(100_000_000);
        }
    }

    @BeforeEach
    void begins() {
        vehicle.start();
        reports.start();
        Await.until("the board reports", () -> vehicle.boardState() == BoardState.CONNECTED);
    }

    @AfterEach
    void ends() throws Exception {
        ended = true;
        reports.join();
        vehicle.close();
    }

    private void awaitCommand(String command) {
        Await.until("commanded is " + command, () -> board.lastCommand().equals(command));
    }

    @Test
    void stopIsCommandedAsZeroAgainAndAgain() {
        awaitCommand(ZERO);
        int before = board.commands.size();

        Await.until("ten commands more", () -> board.commands.size() > before + 10);
        assertThat(board.commands.subList(before, before + 10)).containsOnly(ZERO);
    }

    @Test
    void pulledCableIsToldAndTheBoatGoesOnWhenItIsPutBack() throws Exception {
        effort = 0.5;
        awaitCommand(HALF);
        board.pull();
        Await.until("the loss is told", () -> vehicle.boardState() == BoardState.GONE);
        board.commands.clear();
        reporting.set(false);
        board.putBack();
        awaitCommand(ZERO);
        assertThat(board.commands).doesNotContain(HALF); // until the board reports
        reporting.set(true);

        awaitCommand(HALF);
        Await.until("it is told", () -> news.get(news.size() - 1).equals("CONNECTED "));
    }

    @Test
    void silentBoardIsCommandedZeroAndIsOpenedAnew() {
        effort = 0.5;
        awaitCommand(HALF);
        reporting.set(false);
        awaitCommand(ZERO);
        Await.until("its port is opened anew", () -> vehicle.boardState() == BoardState.GONE);
        Await.until("both states are told", () -> news.contains("GONE it was silent for 5 s"));
        assertThat(news).anyMatch(each -> each.startsWith("SILENT "));

        reporting.set(true);
        awaitCommand(HALF);
    }

    @Test
    void megabyteWithoutALineEndLeavesTheBoardAtWork() {
        byte[] megabyte = new byte[1_000_000];
        Arrays.fill(megabyte, (byte) '{');
        board.send(megabyte);
        board.say("");
        board.say("{\"s4\":{\"type\":\"battery\",\"data\":\"15.000 1 1\"}}");

        Await.until("the next line counts", () -> vehicle.batteryVolts() == 15.0);
        effort = 0.5;
        awaitCommand(HALF);
    }

    @Test
    void fortyLinesAtOnceAreAllRead() {
        StringBuilder lines = new StringBuilder();
        for (int i = 1; i <= 40; i++) {
            lines.append("{\"s1\":{\"type\":\"winch\",\"data\":\"").append(i).append("\"}}\r\n");
        }
        board.send(lines.toString().getBytes(StandardCharsets.US_ASCII));
        Sensor winch = vehicle.sensors().stream()
                .filter(sensor -> sensor.name().equals("winch"))
                .findFirst()
                .orElseThrow();

        Await.until("the last one", () -> winch.read().contains(40.0));
    }

    @Test
    void errorOfTheBoardIsTold() {
        board.say("{\"error\":\"overflow\",\"args\":\"\"}");

        Await.until("it is told", () -> news.contains("error overflow"));
    }

    @Test
    void closedVehicleLeavesTheMotorsAtZeroAndNoThread() throws Exception {
        effort = 0.5;
        awaitCommand(HALF);
        ended = true;
        reports.join();
        vehicle.close();

        assertThat(board.lastCommand()).isEqualTo(ZERO);
        Await.until("its threads have ended", () -> Await.threads("test board") == 0);
    }
}
