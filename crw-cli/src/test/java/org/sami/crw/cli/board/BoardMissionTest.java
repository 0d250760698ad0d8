package org.sami.crw.cli.board;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.boat.hull.board.BoardState;
import org.sami.boat.hull.host.HullBoat;
import org.sami.boat.hull.settings.HullKind;
import org.sami.boat.hull.settings.HullSettings;
import org.sami.boat.hull.stream.TcpPort;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.server.tcp.TcpServerListener;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.ProcessClock;
import org.sami.crw.cli.CommandResult;
import org.sami.crw.sim.board.BoardFaults;
import org.sami.crw.sim.board.BoardOnTcp;
import org.sami.crw.sim.board.BoardSettings;
import org.sami.crw.sim.hull.Conditions;
import org.sami.crw.sim.hull.Flow;
import org.sami.spn.value.GeoPoint;

/** A mission of five boats, each driven through its control board over TCP, in real time; one cable is pulled and put back on the way. */
@Tag("long")
@Timeout(900)
class BoardMissionTest {
    private static final InetSocketAddress ANY_PORT = new InetSocketAddress(InetAddress.getLoopbackAddress(), 0);
    private static final List<String> NAMES = List.of("anna", "bert", "cleo", "dora", "emil");
    private static final Conditions WATER = new Conditions(0.5, 3, Flow.parse("0.1@90"), Flow.NONE, List.of());

    private final SteadyClock clock = new SteadyClock(ProcessClock::ms);
    private final List<BoardOnTcp> boards = new ArrayList<>();
    private final List<HullBoat> boats = new ArrayList<>();
    private final List<String> news = new CopyOnWriteArrayList<>();

    private void launch(int number) throws Exception {
        HullKind kind = number == 4 ? HullKind.RUDDER : HullKind.DIFFERENTIAL;
        GeoPoint at = GeoPoint.of(45.7, 10.72 + number * 0.00015);
        launch(number, BoardSettings.at(at, number + 1).with(kind).on(WATER));
    }

    private void launch(int number, BoardSettings settings) throws Exception {
        BoardFaults cable = new BoardFaults(0.02, 0.02, 0, 0);
        BoardOnTcp board = new BoardOnTcp(settings.failing(cable), ANY_PORT, ANY_PORT, clock, text -> {});
        boards.add(board);
        String name = NAMES.get(number);
        HullBoat boat = new HullBoat(
                name,
                HullSettings.of(settings.kind())
                        .safeMaximum(0.8)
                        .motorsChecked(true)
                        .build(),
                new TcpPort("127.0.0.1", board.boardAddress().getPort()),
                new TcpPort("127.0.0.1", board.gpsAddress().getPort()),
                false,
                clock,
                text -> news.add(name + ": " + text));
        boats.add(boat);
        boat.openBoard();
        boat.openGps();
        boat.awaitPosition();
        boat.serve(ANY_PORT, LostLinkAction.HOLD, Optional.empty(), TcpServerListener.NONE);
    }

    @AfterEach
    void ends() throws Exception {
        for (HullBoat boat : boats) {
            boat.close();
        }
        for (BoardOnTcp board : boards) {
            board.close();
        }
    }

    private double speedMps(int number) {
        try {
            return Math.abs(boards.get(number).speedMps());
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException(e);
        }
    }

    @Test
    void fiveBoatsVisitAllLocationsThoughACableIsPulledAndPutBack() throws Exception {
        for (int number = 0; number < NAMES.size(); number++) {
            launch(number);
        }
        String addresses = boats.stream()
                .map(boat -> "127.0.0.1:" + boat.address().getPort())
                .collect(Collectors.joining(","));

        CompletableFuture<CommandResult> run = CompletableFuture.supplyAsync(() -> CommandResult.crw(
                "run",
                "clv",
                "--connect",
                addresses,
                "--area",
                "60",
                "--locations",
                "10",
                "--answer-after",
                "0.2",
                "--for",
                "240",
                "--json"));
        Await.until("a boat is under way", 120, () -> run.isDone() || fastest() >= 0);
        assertThat(run.isDone()).as("the run has ended before").isFalse();
        int pulled = fastest();
        boards.get(pulled).pullCable();
        Await.until("it only drifts", () -> speedMps(pulled) < 0.15); // the current has 0.1 m/s
        assertThat(boats.get(pulled).vehicle().boardState()).isEqualTo(BoardState.GONE);
        boards.get(pulled).putBackCable();
        Await.until("its board is back", () -> boats.get(pulled).vehicle().boardState() == BoardState.CONNECTED);

        CommandResult ran = run.join();
        JsonNode report = new ObjectMapper().readTree(ran.out());
        assertThat(ran.exitCode()).as(ran.err()).isZero();
        assertThat(report.path("outcome").asText()).isEqualTo("ended");
        assertThat(report.path("locationsVisited").asInt()).isEqualTo(10);
        assertThat(news)
                .anyMatch(text -> text.startsWith(NAMES.get(pulled) + ": board ") && text.contains(" is gone ("))
                .anyMatch(text -> text.startsWith(NAMES.get(pulled) + ": board ") && text.endsWith(" is back"));
    }

    @Test
    void boatWithoutACompassFindsItsHeadingByItsCourse() throws Exception {
        launch(0, BoardSettings.at(GeoPoint.of(45.7, 10.72), 1).on(WATER).withoutCompass());
        String address = "127.0.0.1:" + boats.get(0).address().getPort();

        CommandResult ran = CommandResult.crw(
                "run",
                "clv",
                "--connect",
                address,
                "--area",
                "30",
                "--locations",
                "2",
                "--answer-after",
                "0.2",
                "--for",
                "180",
                "--json");

        assertThat(ran.exitCode()).as(ran.err()).isZero();
        JsonNode report = new ObjectMapper().readTree(ran.out());
        assertThat(report.path("outcome").asText()).isEqualTo("ended");
        assertThat(report.path("locationsVisited").asInt()).isEqualTo(2);
        assertThat(news).contains("anna: no compass: heading from course over ground");
    }

    /** A boat that drives; -1 while none does. */
    private int fastest() {
        for (int number = 0; number < boats.size(); number++) {
            if (speedMps(number) > 0.8) {
                return number;
            }
        }
        return -1;
    }
}
