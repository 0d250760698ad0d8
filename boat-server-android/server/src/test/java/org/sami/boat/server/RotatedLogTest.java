package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.WithdrawKeys;
import org.sami.boat.server.ServerTestBench.Client;
import org.sami.boat.server.log.CommandLogFile;
import org.sami.boat.server.log.LogEntries;
import org.sami.boat.server.log.LogFiles;
import org.sami.boat.server.log.LogPlace;
import org.sami.boat.server.log.LogsWithoutThread;

/** A boat that restarts from the newest file of its log behaves as one that restarts from all that it has written. */
class RotatedLogTest {
    private static final List<Waypoint> PATH = List.of(new Waypoint(45.01, 10, 1), new Waypoint(45.01, 10.01, 1));
    private static final List<Waypoint> TURNS = List.of(new Waypoint(45.02, 10.02, 1));

    @TempDir
    private Path folder;

    private final ServerTestBench before = new ServerTestBench();
    private final Client base = before.commander();
    private final List<CommandMessage> commands = new ArrayList<>();
    private final List<LinkMessage> answers = new ArrayList<>();

    private void did(CommandMessage command) {
        commands.add(command);
        answers.add(base.command(command));
    }

    private LogPlace place(String name, long bytes) {
        return new LogPlace(folder.resolve(name), bytes);
    }

    private ServerTestBench restarted(LogPlace place) throws IOException {
        ServerTestBench next = new ServerTestBench();
        LogsWithoutThread.open(place, "b2", LogEntries.restoring(next.server)).close();
        return next;
    }

    private void write(LogPlace place) throws IOException {
        try (CommandLogFile log = LogsWithoutThread.open(place, "b1", entry -> {})) {
            for (int i = 0; i < commands.size(); i++) {
                log.answered(i, "test", commands.get(i), answers.get(i));
            }
        }
    }

    private void compare() throws IOException {
        LogPlace whole = place("whole.log", 1 << 30);
        LogPlace rotated = place("rotated.log", CommandLogFile.LEAST_BYTES);
        write(whole);
        write(rotated);
        LogFiles files = new LogFiles(rotated.file());
        int newest = files.byNumber().lastKey();
        assertThat(newest).as("newest file").isPositive();
        for (Path old : files.byNumber().headMap(newest).values()) {
            Files.delete(old);
        }
        ServerTestBench expected = restarted(whole);
        ServerTestBench actual = restarted(rotated);

        assertThat(actual.server.mode()).isEqualTo(expected.server.mode());
        Client one = actual.commander();
        Client other = expected.commander();
        assertThat(settings(one)).isEqualTo(settings(other));
        HeldWaypoints held = (HeldWaypoints) one.command(new ReadBack("r"));
        HeldWaypoints heldBefore = (HeldWaypoints) other.command(new ReadBack("r"));
        assertThat(held.listId()).isEqualTo(heldBefore.listId());
        assertThat(held.waypoints()).isEqualTo(heldBefore.waypoints());
        for (CommandMessage command : commands) {
            assertThat(words(one.command(command))).as(command.commandId()).isEqualTo(words(other.command(command)));
        }
        one.command(new FleetRelease("release"));
        other.command(new FleetRelease("release"));
        assertThat(wayHome(actual, one)).isEqualTo(wayHome(expected, other));
    }

    private static String settings(Client client) {
        SettingsReport report = client.all(SettingsReport.class).get(0);
        return report.gains(GainAxis.HEADING) + " " + report.gains(GainAxis.SPEED) + " " + report.velocityMultiplier()
                + " " + report.lostLinkAction() + " " + report.stoppedBy();
    }

    private static String words(LinkMessage answer) {
        return answer instanceof Nack nack ? nack.reason() + " " + nack.detail() : answer.type();
    }

    /** How the motors turn when the link is lost. */
    private static List<Double> wayHome(ServerTestBench bench, Client client) {
        client.command(new SetLostLinkAction("return", LostLinkAction.RETURN));
        client.command(new HoldPosition("hold"));
        bench.vehicle.eastM = 300;
        client.session.closed(bench.nowMs);
        List<Double> motors = new ArrayList<>();
        for (int i = 0; i < 20; i++) {
            bench.run(0.1);
            motors.add(bench.vehicle.thrust());
            motors.add(bench.vehicle.rudder());
        }
        return motors;
    }

    private void manyOthers(int count) {
        for (int i = 0; i < count; i++) {
            did(new StartWaypoints("other" + i, i % 2 == 0 ? "l" : "unknown", 0));
        }
    }

    @Test
    void allThatIsSetAndHeldIsCarried() throws IOException {
        did(new SetGains("g1", GainAxis.HEADING, 2, 0.1, 0.2));
        did(new SetGains("g2", GainAxis.SPEED, 3, 0, 0));
        did(new SetVelocityMultiplier("v", 0.5));
        did(new SetLostLinkAction("a", LostLinkAction.DRIFT));
        did(new UploadWaypoints("u", "l", PATH));
        did(new SetWaysHome("w", "l", List.of(List.of(TURNS), List.of(TURNS))));
        did(new UploadWaypoints("u2", "l2", PATH));
        manyOthers(150);
        compare();
    }

    @Test
    void latchedStopAndWhoLatchedItAreCarried() throws IOException {
        did(new UploadWaypoints("u", "l", PATH));
        did(new FleetStop("f"));
        manyOthers(150);
        compare();
    }

    @Test
    void releasedStopStaysReleased() throws IOException {
        did(new FleetStop("f"));
        did(new FleetRelease("g"));
        manyOthers(150);
        compare();
    }

    @Test
    void moreCommandsThanABoatRemembersAreForgottenInTheSameOrder() throws IOException {
        did(new UploadWaypoints("u", "l", PATH));
        manyOthers(4200);
        compare();
    }

    @Test
    void withdrawnKeysInALogKeepNoBoatFromItsStart() {
        WithdrawKeys command =
                new WithdrawKeys("k", List.of("9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08"));
        before.server.restore("test", command, new Ack("k"));

        assertThat(base.command(new HoldPosition("h"))).isInstanceOf(Ack.class);
    }
}
