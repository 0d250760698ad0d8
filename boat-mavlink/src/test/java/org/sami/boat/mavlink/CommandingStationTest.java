package org.sami.boat.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerSession;
import org.sami.mavlink.vehicle.VehicleId;

/** Who commands, in the boat's time. */
class CommandingStationTest {
    private static final VehicleId STATION = new VehicleId(255, 190);
    private static final VehicleId OTHER = new VehicleId(254, 190);

    private final BoatServer boat = new BoatServer(
            ServerConfig.of("anna", "boot1")
                    .lostLinkAction(LostLinkAction.DRIFT)
                    .build(),
            new DrivenHull(45, 10));
    private long nowMs = 1_000;
    private final BoatClient client = new BoatClient(boat, nowMs);
    private final List<String> said = new ArrayList<>();
    private final CommandingStation command =
            new CommandingStation(client, "anna", (severity, text) -> said.add(text), commands -> {}, nowMs);

    private void pass(long millis) {
        for (long end = nowMs + millis; nowMs < end; nowMs += 100) {
            boat.tick(nowMs);
            command.watch(nowMs);
        }
    }

    private ServerSession base() {
        ServerSession session = boat.connect(new FrameSink() {
            @Override
            public void send(byte[] frame) {}
        });
        session.receive(new Frame(0, "", new Hello("", "base1", Role.COMMANDER, 1, "", "s1", 1)), nowMs);
        return session;
    }

    @Test
    void aBaseKeepsTheCommandForHalfAMinuteAfterItsLinkWasLost() {
        ServerSession base = base();
        pass(200);
        assertThat(command.take(STATION, nowMs)).contains("base1 commands anna: its operator can hand over");

        base.closed(nowMs);
        pass(20_000);
        assertThat(command.take(STATION, nowMs))
                .hasValueSatisfying(why -> assertThat(why).startsWith("base1 commands anna, lost 20 s ago"));
        pass(CommandingStation.KEPT_MS);
        assertThat(command.take(STATION, nowMs)).isEmpty();
        assertThat(boat.commandedBy()).contains(BoatClient.NAME);
        assertThat(said).containsExactly("base1 commands anna; ground stations watch", "ground stations command anna");
    }

    @Test
    void heartbeatsOfAnotherStationDoNotMaskThatTheCommandingOneIsSilent() {
        assertThat(command.take(STATION, nowMs)).isEmpty();
        client.send(HoldPosition::new, nowMs);
        for (int i = 0; i < 3; i++) {
            pass(1_000);
            command.heard(STATION, nowMs);
        }
        assertThat(command.take(OTHER, nowMs)).contains("ground station 255/190 commands anna");
        assertThat(boat.mode()).isEqualTo(BoatMode.HOLD);

        for (int i = 0; i < 5; i++) {
            pass(1_000);
            command.heard(OTHER, nowMs);
        }
        assertThat(boat.mode()).isEqualTo(BoatMode.STOPPED); // what is set for a lost link
        assertThat(command.take(OTHER, nowMs)).isEmpty();
        assertThat(command.isHolder(OTHER)).isTrue();
    }

    @Test
    void aBaseThatTakesTheCommandHasItAtOnce() {
        assertThat(command.take(STATION, nowMs)).isEmpty();
        ServerSession base = base();
        assertThat(base.role()).contains(Role.OBSERVER); // it greets, and takes nothing by that
        base.receive(new Frame(1, "", new org.sami.boat.link.TakeCommand("t1", "s1", 9)), nowMs);
        pass(100);
        assertThat(command.isHolder(STATION)).isFalse();
        assertThat(command.take(STATION, nowMs)).contains("base1 commands anna: its operator can hand over");
    }
}
