package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.ServerTestBench.Client;

/** A boat that takes back what its earlier start had executed. */
class RestoreTest {
    private static final List<Waypoint> PATH = List.of(new Waypoint(45.01, 10, 1));

    private final ServerTestBench bench = new ServerTestBench();

    private void had(CommandMessage command) {
        bench.server.restore("test", command, new Ack(command.commandId()));
    }

    @Test
    void boatThatWasUnderWayHoldsItsListAndDoesNotMove() {
        had(new UploadWaypoints("u", "l", PATH));
        had(new StartWaypoints("s", "l", 0));
        Client client = bench.commander();
        bench.run(1, client);

        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
        assertThat(((HeldWaypoints) client.command(new ReadBack("r"))).waypoints())
                .isEqualTo(PATH);
        assertThat(client.command(new StartWaypoints("s", "l", 0))).isInstanceOf(Ack.class);
        assertThat(bench.server.mode())
                .as("a repeated id is answered, not executed")
                .isEqualTo(BoatMode.STOPPED);
        assertThat(bench.log).isEmpty();
    }

    @Test
    void boatBegunAwayFromItsHomeReturnsToTheHomeThatItHad() {
        ServerTestBench begunAgain = new ServerTestBench(config -> config.home(45.02, 10.03));
        Client client = begunAgain.commander();

        Waypoint home = client.all(SettingsReport.class).get(0).home().orElseThrow();
        assertThat(home.latDeg()).isEqualTo(45.02);
        assertThat(home.lonDeg()).isEqualTo(10.03);
    }

    @Test
    void fleetStopStaysLatchedUntilReleased() {
        had(new FleetStop("f"));
        had(new HoldPosition("h"));
        assertThat(bench.server.mode()).isEqualTo(BoatMode.FLEET_STOP);

        had(new FleetRelease("g"));
        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }

    @Test
    void refusedCommandStaysRefused() {
        bench.server.restore("test", new UploadWaypoints("u", "l", PATH), new Nack("u", NackReason.TOO_LONG, ""));
        Client client = bench.commander();

        assertThat(client.command(new UploadWaypoints("u", "l", PATH))).isInstanceOf(Nack.class);
        assertThat(((HeldWaypoints) client.command(new ReadBack("r"))).listId()).isEmpty();
    }

    @Test
    void gainsAndMultiplierAreThoseThatWereSet() {
        had(new SetGains("g", GainAxis.HEADING, 2.4, 0.1, 0.2));
        had(new SetVelocityMultiplier("v", 0.25));
        had(new SetVelocityMultiplier("w", 0.5));

        SettingsReport inForce = bench.commander().all(SettingsReport.class).get(0);
        assertThat(inForce.gains(GainAxis.HEADING)).isEqualTo(new Gains(2.4, 0.1, 0.2));
        assertThat(inForce.gains(GainAxis.SPEED)).isEqualTo(new Gains(0.3, 0.05, 0));
        assertThat(inForce.velocityMultiplier()).isEqualTo(0.5);
    }

    @Test
    void lostLinkActionIsTheOneThatWasSet() {
        had(new SetLostLinkAction("a", LostLinkAction.DRIFT));
        Client client = bench.commander();
        client.command(new HoldPosition("h"));
        client.session.closed(bench.nowMs);

        assertThat(bench.server.mode()).isEqualTo(BoatMode.STOPPED);
    }
}
