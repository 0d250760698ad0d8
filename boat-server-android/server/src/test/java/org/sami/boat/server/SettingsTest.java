package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.link.BoatCapabilities;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.GainAxis;
import org.sami.boat.link.Gains;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Role;
import org.sami.boat.link.SetGains;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.ServerTestBench.Client;

/** What can be set on a boat: it does it, says what is in force, and refuses what makes no sense. */
class SettingsTest {
    private final ServerTestBench bench = new ServerTestBench();

    private static SettingsReport newest(Client client) {
        List<SettingsReport> reports = client.all(SettingsReport.class);
        return reports.get(reports.size() - 1);
    }

    @Test
    void whoIsWelcomeLearnsWhatIsInForce() {
        Client client = bench.commander();

        assertThat(newest(client).gains(GainAxis.HEADING)).isEqualTo(new Gains(1.2, 0, 0));
        assertThat(newest(client).velocityMultiplier()).isEqualTo(1);
        assertThat(newest(client).lostLinkAction()).isEqualTo(LostLinkAction.HOLD);
    }

    @Test
    void howTheControlBoardIsIsToldAtTheWelcomeAndToEverybodyWhenItChanges() {
        bench.vehicle.board = Optional.of(BoardCondition.WORKING);
        Client client = bench.commander();
        Client observer = bench.client(Role.OBSERVER, 1);
        assertThat(newest(client).board()).contains(BoardCondition.WORKING);
        bench.run(1, client, observer);
        int before = observer.all(SettingsReport.class).size();

        bench.vehicle.board = Optional.of(BoardCondition.SILENT);
        bench.run(1, client, observer);

        assertThat(newest(client).board()).contains(BoardCondition.SILENT);
        assertThat(newest(observer).board()).contains(BoardCondition.SILENT);
        assertThat(observer.all(SettingsReport.class)).hasSize(before + 1);
    }

    @Test
    void settingIsAcknowledgedWithWhatIsInForceAndTheOthersAreTold() {
        Client client = bench.commander();
        Client observer = bench.client(Role.OBSERVER, 1);
        List<CommandMessage> commands = List.of(
                new SetGains("g1", GainAxis.HEADING, 2.4, 0.1, 0.2),
                new SetGains("g2", GainAxis.SPEED, 0.5, 0, 0),
                new SetVelocityMultiplier("v", 0.5),
                new SetLostLinkAction("l", LostLinkAction.DRIFT));
        for (CommandMessage command : commands) {
            assertThat(client.say(command)).hasExactlyElementsOfTypes(Ack.class, SettingsReport.class);
        }

        SettingsReport inForce = new SettingsReport(
                        new Gains(2.4, 0.1, 0.2),
                        new Gains(0.5, 0, 0),
                        0.5,
                        LostLinkAction.DRIFT,
                        Optional.of(new Waypoint(45, 10, 1.5)),
                        Optional.empty())
                .with(new BoatCapabilities(
                        Collections.singletonMap("panorama", "there is no camera on board"), Optional.of(List.of())));
        assertThat(newest(client)).usingRecursiveComparison().isEqualTo(inForce);
        assertThat(newest(observer)).usingRecursiveComparison().isEqualTo(inForce);
        assertThat(newest(bench.client(Role.OBSERVER, 1)))
                .usingRecursiveComparison()
                .isEqualTo(inForce);
    }

    @Test
    void whoLatchedTheFleetStopIsToldToEverybodyUntilTheRelease() {
        Client client = bench.commander();
        Client observer = bench.client(Role.OBSERVER, 1);
        assertThat(newest(observer).stoppedBy()).isEmpty();

        assertThat(client.say(new FleetStop("f"))).hasExactlyElementsOfTypes(Ack.class, SettingsReport.class);

        assertThat(newest(observer).stoppedBy()).isEqualTo(client.session.clientId());
        assertThat(newest(bench.client(Role.OBSERVER, 1)).stoppedBy()).isEqualTo(client.session.clientId());
        client.say(new FleetRelease("r"));
        assertThat(newest(observer).stoppedBy()).isEmpty();
    }

    @Test
    void whoLatchedTheFleetStopIsKnownAfterARestart() {
        bench.server.restore("base2", new FleetStop("f"), new Ack("f"));

        assertThat(newest(bench.client(Role.OBSERVER, 1)).stoppedBy()).isEqualTo("base2");
    }

    @Test
    void settingOutOfRangeIsRefusedForAReasonAndChangesNothing() {
        Client client = bench.commander();
        SettingsReport before = newest(client);
        String[] bodies = {
            "{\"type\":\"gains\",\"seq\":5,\"command\":\"x\",\"axis\":\"HEADING\",\"p\":1001,\"i\":0,\"d\":0}",
            "{\"type\":\"gains\",\"seq\":5,\"command\":\"x\",\"axis\":\"HEADING\",\"p\":1,\"i\":-0.1,\"d\":0}",
            "{\"type\":\"gains\",\"seq\":5,\"command\":\"x\",\"axis\":\"SPEED\",\"p\":NaN,\"i\":0,\"d\":0}",
            "{\"type\":\"gains\",\"seq\":5,\"command\":\"x\",\"axis\":\"SPEED\",\"p\":1,\"i\":0,\"d\":1e400}",
            "{\"type\":\"gains\",\"seq\":5,\"command\":\"x\",\"axis\":\"RUDDER\",\"p\":1,\"i\":0,\"d\":0}",
            "{\"type\":\"velocity\",\"seq\":5,\"command\":\"x\",\"multiplier\":NaN}",
            "{\"type\":\"velocity\",\"seq\":5,\"command\":\"x\",\"multiplier\":-1}",
            "{\"type\":\"velocity\",\"seq\":5,\"command\":\"x\",\"multiplier\":11}",
            "{\"type\":\"lost-link\",\"seq\":5,\"command\":\"x\",\"action\":\"EXPLODE\"}",
        };
        for (String body : bodies) {
            client.session.receive(FrameBytes.of(body), bench.nowMs);

            Nack nack = client.all(Nack.class).get(client.all(Nack.class).size() - 1);
            assertThat(nack.commandId()).isEqualTo("x");
            assertThat(nack.reason()).isEqualTo(NackReason.MALFORMED);
            assertThat(nack.detail()).matches("(?s).*(in 0.0 to 1000|in 0.0 to 10|words).*");
        }
        bench.client(Role.COMMANDER, 1); // asks what is in force, as an observer

        assertThat(newest(client)).usingRecursiveComparison().isEqualTo(before);
    }

    @Test
    void observerSetsNothing() {
        bench.commander();
        Client observer = bench.client(Role.OBSERVER, 1);

        assertThat(observer.say(new SetVelocityMultiplier("v", 2))).hasExactlyElementsOfTypes(Nack.class);
        assertThat(newest(bench.client(Role.OBSERVER, 1)).velocityMultiplier()).isEqualTo(1);
    }

    @Test
    void velocityMultiplierScalesEveryLegUpToTheBoatsOwnLimit() {
        Client client = bench.commander();
        client.command(new SetGains("g", GainAxis.SPEED, 0, 0, 0)); // feed-forward alone
        client.command(new UploadWaypoints("u", "l", List.of(new Waypoint(45.01, 10, 1.6))));
        client.command(new StartWaypoints("s", "l", 0));
        bench.run(0.1, client);
        assertThat(bench.vehicle.thrust()).isCloseTo(0.5, within(1e-6)); // 1.6 of 3.2 m/s

        double[][] table = {{0.5, 0.25}, {1.5, 0.75}, {10, 1}, {0, 0}, {1, 0.5}};
        for (double[] row : table) {
            client.command(new SetVelocityMultiplier("v" + row[0], row[0]));
            bench.run(0.1, client);
            assertThat(bench.vehicle.thrust()).as("times %s", row[0]).isCloseTo(row[1], within(1e-6));
        }
    }
}
