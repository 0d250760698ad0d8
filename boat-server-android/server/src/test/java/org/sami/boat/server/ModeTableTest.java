package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.boat.server.BoatsInModes.PATH;
import static org.sami.boat.server.BoatsInModes.boatIn;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.server.ServerTestBench.Client;
import org.sami.boat.server.vehicle.CameraShot;

/** The table of docs/link.md, section Modes, says what a boat does at each event in each mode. */
class ModeTableTest {
    private static final String ABSENT = "–";

    /** Lets an event happen; gives back the refusal, if it is refused. */
    private interface Happening {
        Optional<NackReason> happen(ServerTestBench bench, Client client);
    }

    private record Row(ModeEvent event, Happening happening) {}

    private static Happening command(CommandMessage command) {
        return (bench, client) -> {
            LinkMessage answer = client.command(command);
            return answer instanceof Nack nack ? Optional.of(nack.reason()) : Optional.empty();
        };
    }

    private static Happening state(LinkMessage message) {
        return (bench, client) -> {
            client.say(message);
            return Optional.empty();
        };
    }

    private static Happening linkLost(LostLinkAction action) {
        return (bench, client) -> {
            client.command(new SetLostLinkAction("a", action));
            client.session.closed(bench.nowMs);
            return Optional.empty();
        };
    }

    private static Happening at(double northM, double seconds) {
        return (bench, client) -> {
            bench.vehicle.northM = northM;
            bench.run(seconds, client);
            return Optional.empty();
        };
    }

    private static Map<String, Row> rowsOfEvents() {
        Map<String, Row> all = new LinkedHashMap<>();
        all.put("`upload`", new Row(ModeEvent.UPLOAD, command(new UploadWaypoints("e", "l2", PATH))));
        all.put("`start`", new Row(ModeEvent.START, command(new StartWaypoints("e", "l1", 0))));
        all.put(
                "`start` at the end of the list",
                new Row(ModeEvent.START_AT_END, command(new StartWaypoints("e", "l1", 1))));
        all.put("`hold`", new Row(ModeEvent.HOLD_POSITION, command(new HoldPosition("e"))));
        all.put("`panorama`", new Row(ModeEvent.PANORAMA, command(new TakePanorama("e", 4))));
        all.put("`teleop`", new Row(ModeEvent.TELEOPERATE, state(new Teleoperate(0.7, 0))));
        all.put("`stop`", new Row(ModeEvent.STOP_MOTORS, command(new StopMotors("e"))));
        all.put("`fleet-stop`", new Row(ModeEvent.FLEET_STOP, command(new FleetStop("e"))));
        all.put("`fleet-release`", new Row(ModeEvent.FLEET_RELEASE, command(new FleetRelease("e"))));
        for (LostLinkAction action : LostLinkAction.values()) {
            all.put("link lost, action `" + action + "`", new Row(ModeEvent.linkLost(action), linkLost(action)));
        }
        all.put("last waypoint reached", new Row(ModeEvent.PATH_DONE, at(1112, 0.1)));
        all.put("home reached", new Row(ModeEvent.HOME_REACHED, at(0, 0.1)));
        all.put("no `teleop` for 2 s", new Row(ModeEvent.HAND_SILENT, at(46, 2)));
        return all;
    }

    /** The rows of the page: the event, then what a boat does in each mode. */
    private static List<String[]> page() throws IOException {
        String page = Files.readString(Path.of("..", "..", "docs", "link.md"));
        List<String[]> rows = new ArrayList<>();
        for (String line : page.substring(page.indexOf("\n## Modes\n"), page.indexOf("\n## When the link is lost\n"))
                .lines()
                .filter(line -> line.startsWith("| "))
                .toList()) {
            String[] cells = line.substring(2, line.length() - 2).split(" \\| ");
            rows.add(cells);
        }
        return rows;
    }

    static List<Arguments> everyCell() throws IOException {
        List<Arguments> cells = new ArrayList<>();
        List<String[]> rows = page();
        List<String> heads = List.of(rows.get(0));
        for (String[] row : rows.subList(1, rows.size())) {
            for (BoatMode mode : BoatMode.values()) {
                cells.add(Arguments.of(row[0], mode, row[heads.indexOf("`" + mode + "`")]));
            }
        }
        return cells;
    }

    @ParameterizedTest
    @MethodSource("everyCell")
    void tableIsThatOfThePage(String event, BoatMode mode, String action) {
        ModeEvent row = rowsOfEvents().get(event).event();

        assertThat(ModeTable.action(mode, row))
                .as(row + " in mode " + mode)
                .isEqualTo(
                        action.equals(ABSENT) ? ModeAction.NONE : ModeAction.valueOf(action.toUpperCase(Locale.ROOT)));
    }

    @Test
    void pageHasEveryEventAndMode() throws IOException {
        List<String[]> rows = page();

        assertThat(rows.get(0)[0]).isEqualTo("event");
        assertThat(Arrays.copyOfRange(rows.get(0), 1, rows.get(0).length))
                .containsExactly(Arrays.stream(BoatMode.values())
                        .map(mode -> "`" + mode + "`")
                        .toArray(String[]::new));
        assertThat(rowsOfEvents().values().stream().map(Row::event)).containsExactly(ModeEvent.values());
        assertThat(rows.stream().skip(1).map(row -> row[0]))
                .containsExactlyElementsOf(rowsOfEvents().keySet());
    }

    @ParameterizedTest
    @MethodSource("everyCell")
    void boatDoesWhatThePageSays(String event, BoatMode mode, String action) {
        ServerTestBench bench = new ServerTestBench();
        bench.vehicle.camera = CameraShot::withoutFile;
        Client client = boatIn(mode, bench);
        bench.vehicle.northM = 46; // drifted, but not out of its radius
        assertThat(bench.server.mode()).isEqualTo(mode);

        Optional<NackReason> refusal = rowsOfEvents().get(event).happening().happen(bench, client);

        BoatMode after = bench.server.mode();
        assertThat(after).isEqualTo(modeAfter(action, mode));
        boolean isState = event.startsWith("`teleop`");
        assertThat(refusal)
                .isEqualTo(
                        action.equals("deny") && !isState ? Optional.of(NackReason.FLEET_STOPPED) : Optional.empty());
        if (after == BoatMode.HOLD && mode == BoatMode.HOLD && !event.equals("`panorama`")) {
            bench.vehicle.northM = 43;
            bench.run(0.1);
            assertThat(bench.vehicle.thrust() > 0)
                    .as("drives back to 50 m north, where it kept station, and not to 46 m")
                    .isEqualTo(!action.equals("hold"));
        }
        if (after == BoatMode.STOPPED || after == BoatMode.FLEET_STOP) {
            bench.run(0.1);
            assertThat(bench.vehicle.isResting()).isTrue();
        }
    }

    private static BoatMode modeAfter(String action, BoatMode before) {
        return switch (action) {
            case "keep", "deny", ABSENT -> before;
            case "path" -> BoatMode.PATH;
            case "hold" -> BoatMode.HOLD;
            case "home" -> BoatMode.RETURN;
            case "hand" -> BoatMode.TELEOPERATION;
            case "stop" -> BoatMode.STOPPED;
            case "lock" -> BoatMode.FLEET_STOP;
            default -> throw new AssertionError("the page knows no action " + action);
        };
    }
}
