package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NearbyBoat;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.mavlink.testing.SmallBoat;

/** The table of docs/mavlink.md, row by row, on a simulated vehicle. */
@Timeout(900)
class MavlinkPageTest {
    private static final Pattern ROW =
            Pattern.compile("(?m)^\\| [^|]+ \\| `([a-z-]+)`([^|]*) \\| ([^|]+) \\| ([^|]+) \\|$");
    private static final Map<String, Integer> MODES =
            Map.of("MANUAL", 0, "HOLD", 4, "LOITER", 5, "AUTO", 10, "GUIDED", 15);
    private static final List<Waypoint> LIST =
            List.of(new Waypoint(45.71, 10.72, 1), new Waypoint(45.71, 10.73, 1), new Waypoint(45.72, 10.73, 2));
    private static final Pattern RETURN = Pattern.compile("return (\\d) and (\\d)");
    private static final Set<String> HANDING_OVER =
            Set.of("AskForCommand", "GrantCommand", "TakeCommand", "WithdrawKeys");
    private static final String AS_BEFORE = "as before";
    private static final double AHEAD_DEG = 6 / 111_319.0; // 6 m

    /** What each message is here. */
    private static final Map<String, Function<String, CommandMessage>> COMMANDS = Map.ofEntries(
            Map.entry("upload", id -> new UploadWaypoints(id, "other", LIST)),
            Map.entry("readback", ReadBack::new),
            Map.entry("start", id -> new StartWaypoints(id, "list", 0)),
            Map.entry("start at the last point", id -> new StartWaypoints(id, "list", 2)),
            Map.entry("start along a way home", id -> new StartWaypoints(id, "list", 0)),
            Map.entry("hold", HoldPosition::new),
            Map.entry("stop", StopMotors::new),
            Map.entry("fleet-stop", FleetStop::new),
            Map.entry("fleet-release", FleetRelease::new),
            Map.entry("velocity", id -> new SetVelocityMultiplier(id, 0.5)),
            Map.entry("lost-link", id -> new SetLostLinkAction(id, LostLinkAction.RETURN)),
            Map.entry("gains", id -> new SetGains(id, GainAxis.HEADING, new Gains(1, 0, 0))),
            Map.entry("ways-home", id -> new SetWaysHome(id, "list", List.of())),
            Map.entry("panorama", id -> new TakePanorama(id, 8)),
            Map.entry("panorama with a camera", id -> new TakePanorama(id, 8)));

    @TempDir
    private Path folder;

    private static List<MatchResult> rows() throws Exception {
        return ROW.matcher(Files.readString(Path.of("..", "docs", "mavlink.md")))
                .results()
                .toList();
    }

    /** All that a base may send, but for what decides who commands: {@link BaseSession} answers that. */
    @Test
    void eachKindOfCommandHasARow() throws Exception {
        Set<String> walked = COMMANDS.values().stream()
                .map(made -> made.apply("any").getClass().getSimpleName())
                .collect(Collectors.toSet());

        assertThat(kindsOfCommands())
                .containsExactlyInAnyOrderElementsOf(
                        Stream.concat(walked.stream(), HANDING_OVER.stream()).toList());
    }

    private static Set<String> kindsOfCommands() throws Exception {
        Path messages = Path.of("..", "boat-link", "src", "main", "java", "org", "sami", "boat", "link");
        try (Stream<Path> files = Files.list(messages)) {
            Set<String> kinds = new TreeSet<>();
            for (Path file :
                    files.filter(each -> each.toString().endsWith(".java")).toList()) {
                if (Files.readString(file).contains("extends CommandMessage ")) {
                    kinds.add(file.getFileName().toString().replace(".java", ""));
                }
            }
            return kinds;
        }
    }

    @Test
    void tableHasARowForEachMessageThatABaseSends() throws Exception {
        assertThat(rows().stream().map(row -> row.group(1) + row.group(2)))
                .containsAll(COMMANDS.keySet())
                .contains("teleop", "traffic");
    }

    @TestFactory
    Stream<DynamicTest> eachRowIsSo() throws Exception {
        return rows().stream()
                .map(row -> dynamicTest(
                        row.group(1) + row.group(2),
                        () -> walk(row.group(1) + row.group(2), row.group(3), row.group(4))));
    }

    private static String address(SmallBoat boat, String message) {
        boat.parameter("CAM1_TYPE", message.endsWith("with a camera") ? 1 : 0);
        return boat.address() + "/5";
    }

    /** Steers around a boat that lies ahead, and goes on along its mission once it has gone. */
    private static void givesWay(SmallBoat boat, LinkClient client) {
        assertThat(client.ask(new StartWaypoints("started", "list", 0))).isInstanceOf(Ack.class);
        Await.until("it gives way", () -> {
            Telemetry at = client.last(Telemetry.class).orElseThrow();
            client.say(new Traffic(
                    List.of(new NearbyBoat("anna", at.latDeg() + AHEAD_DEG, at.lonDeg(), 0, 0, BoatMode.STOPPED, 0))));
            return boat.mode() == MODES.get("GUIDED");
        });
        Await.until("it goes on", () -> {
            client.say(new Traffic(List.of()));
            return boat.mode() == MODES.get("AUTO") && boat.isArmed();
        });
    }

    private void walk(String message, String does, String then) throws Exception {
        try (SmallBoat boat = new SmallBoat(5, 45.7, 10.72, 1);
                LinkClient client = new LinkClient(folder.resolve(message.replace(' ', '-')), address(boat, message))) {
            assertThat(client.ask(new UploadWaypoints("u", "list", LIST))).isInstanceOf(Ack.class);
            if (message.equals("traffic")) {
                givesWay(boat, client);
                return;
            }
            int mode = boat.mode();
            boolean armed = boat.isArmed();

            if (message.equals("teleop")) {
                client.say(new Teleoperate(0.2, 0));
            } else {
                LinkMessage answer = client.ask(COMMANDS.get(message).apply("asked"));
                if (then.matches("NO[A-Z_]+")) {
                    assertThat(answer)
                            .isInstanceOfSatisfying(
                                    Nack.class,
                                    nack -> assertThat(nack.reason()).hasToString(then));
                    return;
                }
                assertThat(answer).isInstanceOfAny(Ack.class, HeldWaypoints.class);
            }
            if (message.equals("lost-link")) {
                Matcher set = RETURN.matcher(does);
                assertThat(set.find()).as(does).isTrue();
                assertThat(boat.parameter("FS_GCS_ENABLE")).isEqualTo(Double.parseDouble(set.group(1)));
                assertThat(boat.parameter("FS_ACTION")).isEqualTo(Double.parseDouble(set.group(2)));
            }
            if (then.equals(AS_BEFORE)) {
                assertThat(boat.mode()).isEqualTo(mode);
                assertThat(boat.isArmed()).isEqualTo(armed);
            } else {
                Await.until(
                        "it is " + then,
                        () -> boat.mode() == MODES.get(then.split(", ")[0])
                                && boat.isArmed() == then.endsWith(" armed"));
            }
        }
    }
}
