package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.crw.fleet.RobotKind;
import org.sami.mavlink.testing.SmallCopter;

/** The table of copters in docs/mavlink.md, row by row, on a simulated copter. */
@Timeout(900)
class CopterPageTest {
    private static final Pattern TABLE = Pattern.compile("(?s)\n### Copters\n.*?\n\\|---\\|---\\|---\\|\n(.*?)\n\n");
    private static final Map<String, Integer> MODES =
            Map.of("AUTO", SmallCopter.AUTO, "BRAKE", SmallCopter.BRAKE, "GUIDED", SmallCopter.GUIDED);
    private static final String AS_BEFORE = "as before";

    private static final Waypoint UP = new Waypoint(45.7, 10.72, 8, 20);
    private static final Waypoint FAR = new Waypoint(45.8, 10.72, 8, 20);
    private static final Waypoint GROUND = new Waypoint(45.7, 10.7206, 8, 0);

    @TempDir
    private Path folder;

    /** A row; what it says about what a copter does, and about its mode and arming afterwards. */
    private record Row(String asked, String does, String then) {}

    /** Asks a copter for what a row is about. */
    @FunctionalInterface
    private interface Walk {
        void on(Flight flight, Row row) throws Exception;
    }

    /** A copter and its base. */
    private record Flight(SmallCopter copter, LinkClient client) {
        void accepts(CommandMessage command) {
            assertThat(client.ask(command)).isInstanceOf(Ack.class);
        }

        void refuses(CommandMessage command) {
            assertThat(client.ask(command)).isInstanceOf(Nack.class);
        }

        void fly(Waypoint... waypoints) {
            accepts(new UploadWaypoints("upload", "list", List.of(waypoints)));
            accepts(new StartWaypoints("start", "list", 0));
        }

        void flyUp() {
            fly(UP, FAR);
            Await.until("it is in the air", () -> copter.heightM() > 5);
        }
    }

    /** For each row a walk for each state in its last column. */
    private static final Map<String, List<Walk>> WALKS = Map.of(
            "fly along a path", List.of((flight, row) -> flight.fly(UP, FAR)),
            "*Go here*, *Return home*", List.of(CopterPageTest::goesHere),
            "land", List.of(CopterPageTest::lands),
            "stop, fleet stop, keep the place",
                    List.of(CopterPageTest::stopsInTheAir, CopterPageTest::stopsOnTheGround),
            "by hand", List.of(CopterPageTest::isSteered),
            "lost link", List.of(CopterPageTest::hasLostLinkActions),
            "pictures all round", List.of((flight, row) -> flight.refuses(new TakePanorama("look", 8))),
            "gains",
                    List.of((flight, row) ->
                            flight.refuses(new SetGains("gains", GainAxis.HEADING, new Gains(1, 0, 0)))),
            "fence and no-go areas of a session of copters", List.of(CopterPageTest::getsItsFence));

    private static void goesHere(Flight flight, Row row) {
        int metres = number(row.does(), "takes off to (\\d+) m");
        flight.fly(new Waypoint(GROUND.latDeg(), GROUND.lonDeg(), 8, metres)); // as the base sends it
        Await.until("it has its altitude", () -> Math.abs(flight.copter().heightM() - metres) < 1);
    }

    private static void lands(Flight flight, Row row) {
        flight.refuses(new UploadWaypoints("other", "other", List.of(UP, GROUND, UP)));
        flight.fly(UP, GROUND);
        Await.until("it has taken off", () -> flight.copter().heightM() > 5);
        Await.until("it has landed", () -> flight.copter().heightM() == 0);
    }

    private static void stopsInTheAir(Flight flight, Row row) {
        flight.flyUp();
        flight.accepts(new FleetStop("stop"));
        assertThat(flight.copter().fell()).isFalse();
    }

    private static void stopsOnTheGround(Flight flight, Row row) {
        flight.copter().armedByPilot();
        flight.accepts(new FleetStop("stop"));
    }

    private static void isSteered(Flight flight, Row row) {
        flight.client().say(new Teleoperate(1, 0));
        flight.client().untilAlarm("vehicle 6 is not flown by hand from here");
    }

    private static void hasLostLinkActions(Flight flight, Row row) {
        Map<LostLinkAction, String> words = Map.of(
                LostLinkAction.RETURN, "return (\\d)",
                LostLinkAction.HOLD, "keep the place (\\d)",
                LostLinkAction.DRIFT, "drift (\\d)",
                LostLinkAction.CONTINUE, "go on (\\d)");
        words.forEach((action, pattern) -> {
            flight.accepts(new SetLostLinkAction(action.name(), action));
            assertThat(flight.copter().parameter("FS_GCS_ENABLE")).isEqualTo(number(row.does(), pattern));
        });
    }

    private static void getsItsFence(Flight flight, Row row) {
        flight.client().keepTo(Optional.of(SquareArea.of(45.69, 10.71, 0.02)), List.of(), RobotKind.COPTER);
        Await.until(
                "it is in force",
                () -> flight.copter().parameter("FENCE_ENABLE") == number(row.does(), "`FENCE_ENABLE` (\\d)"));
        assertThat(flight.copter().parameter("FENCE_ACTION")).isEqualTo(number(row.does(), "`FENCE_ACTION` (\\d)"));
    }

    private static int number(String text, String pattern) {
        Matcher found = Pattern.compile(pattern).matcher(text);
        assertThat(found.find()).as(pattern + " in " + text).isTrue();
        return Integer.parseInt(found.group(1));
    }

    private static List<Row> rows() throws Exception {
        Matcher table = TABLE.matcher(Files.readString(Path.of("..", "docs", "mavlink.md")));
        assertThat(table.find()).isTrue();
        List<Row> rows = new ArrayList<>();
        for (String line : table.group(1).split("\n", -1)) {
            String[] cells = line.split(" *\\| *", -1);
            assertThat(cells).as(line).hasSize(5); // outside of its first and last bar is nothing
            rows.add(new Row(cells[1], cells[2], cells[3]));
        }
        return rows;
    }

    @Test
    void eachRowIsWalked() throws Exception {
        assertThat(rows().stream().map(Row::asked)).containsExactlyInAnyOrderElementsOf(WALKS.keySet());
    }

    @TestFactory
    Stream<DynamicTest> eachRowIsSo() throws Exception {
        return rows().stream().map(row -> dynamicTest(row.asked(), () -> walk(row)));
    }

    private void walk(Row row) throws Exception {
        List<Walk> walks = WALKS.get(row.asked());
        String[] states = row.then().split(", or ", -1);
        assertThat(walks).as(row.then()).hasSize(states.length);
        for (int each = 0; each < states.length; each++) {
            Path own = folder.resolve(Integer.toString(row.asked().hashCode())).resolve(Integer.toString(each));
            try (SmallCopter copter = new SmallCopter(6, 45.7, 10.72, 10);
                    LinkClient client = new LinkClient(own, copter.address() + "/6")) {
                int mode = copter.mode();
                boolean armed = copter.isArmed();

                walks.get(each).on(new Flight(copter, client), row);

                if (states[each].equals(AS_BEFORE)) {
                    assertThat(copter.mode()).isEqualTo(mode);
                    assertThat(copter.isArmed()).isEqualTo(armed);
                } else {
                    awaitState(copter, states[each]);
                }
            }
        }
    }

    /** Such as {@code AUTO, armed}, or {@code disarmed} in any mode. */
    private static void awaitState(SmallCopter copter, String state) {
        List<String> words = List.of(state.split(", ", -1));
        Await.until("it is " + state, () -> words.stream().allMatch(word -> isSo(copter, word)));
    }

    private static boolean isSo(SmallCopter copter, String word) {
        return switch (word) {
            case "armed" -> copter.isArmed();
            case "disarmed" -> !copter.isArmed();
            default -> copter.mode() == MODES.get(word);
        };
    }
}
