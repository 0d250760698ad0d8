package org.sami.boat.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerConfig;
import org.sami.boat.server.ServerSession;
import org.sami.mavlink.mission.MissionItem;
import org.sami.mavlink.onboard.OrderReply;
import org.sami.mavlink.onboard.StationOrder;
import org.sami.mavlink.vehicle.VehicleId;

/** A boat with the parts that obey ground stations, without a link to them, in a time of its own. */
final class DrivenBoat {
    static final VehicleId STATION = new VehicleId(255, 190);
    static final VehicleId OTHER = new VehicleId(254, 190);
    static final double LAT = 45;
    static final double LON = 10;

    private static final long TICK_MS = 100;

    final DrivenHull hull = new DrivenHull(LAT, LON);
    final BoatServer server;
    final BoatClient client;
    final CommandingStation command;
    final BoatMission mission;
    final BoatParameters parameters;
    final BoatVehicle vehicle;
    final BoatFence fence = new BoatFence();
    final List<String> said = new ArrayList<>(); // about the fence
    int fenceReports;
    private final FenceGuard guard;
    long nowMs = 1_000;

    DrivenBoat(LostLinkAction lostLink) {
        server = new BoatServer(
                ServerConfig.of("anna", "boot1").lostLinkAction(lostLink).build(), hull);
        client = new BoatClient(server, nowMs);
        command = new CommandingStation(client, "anna", (severity, text) -> {}, this::commandChanged, nowMs);
        mission = new BoatMission(client);
        parameters = new BoatParameters(client, 1);
        vehicle = new BoatVehicle(
                "anna", client, command, mission, parameters, new StationWayCheck("anna", client, fence));
        guard = new FenceGuard(
                "anna", client, fence, vehicle, (severity, text) -> said.add(text), () -> fenceReports++);
        pass(200);
    }

    private void commandChanged(boolean commands) {
        vehicle.commandChanged(commands);
    }

    /** Lets time pass while these stations, and the bases, show that they are there. */
    void pass(long millis, VehicleId... present) {
        for (long end = nowMs + millis; nowMs < end; nowMs += TICK_MS) {
            bases.forEach(base -> base.say(new Heartbeat(nowMs)));
            for (VehicleId station : present) {
                command.heard(station, nowMs);
            }
            server.tick(nowMs);
            command.watch(nowMs);
            client.takeProgress().forEach(progress -> mission.take(progress, nowMs));
            mission.tick(nowMs);
            vehicle.watch();
            guard.tick(nowMs);
            hull.move(TICK_MS / 1000.0);
        }
    }

    OrderReply order(VehicleId station, StationOrder order) {
        return vehicle.order(station, order, nowMs);
    }

    OrderReply mode(VehicleId station, int number) {
        return order(station, new StationOrder.ChangeMode(number));
    }

    OrderReply arm(VehicleId station) {
        return order(station, new StationOrder.Arm());
    }

    OrderReply disarm(VehicleId station) {
        return order(station, new StationOrder.Disarm());
    }

    void mission(MissionItem... items) {
        vehicle.missionChanged(List.of(items), nowMs);
    }

    void fence(MissionItem... items) {
        fence.replace(List.of(items));
        guard.replaced(nowMs);
    }

    private final List<Base> bases = new ArrayList<>();

    /** A base of ours says hello; it commands if nobody does. */
    Base base(Role role) {
        Base base = new Base("base1");
        bases.add(base);
        base.say(new Hello("", base.name, role, 1, "", "s1", 1));
        return base;
    }

    /** A base of ours, which is there until it goes. */
    final class Base implements FrameSink {
        private final String name;
        private final ServerSession session = server.connect(this);
        private final List<LinkMessage> heard = new ArrayList<>();
        private String term = "";
        private long sequence;

        Base(String name) {
            this.name = name;
        }

        void say(LinkMessage message) {
            session.receive(new Frame(sequence++, term, message), nowMs);
        }

        void send(Function<String, CommandMessage> order) {
            say(order.apply("b" + sequence));
        }

        /** It says nothing more; its connection stays. */
        void falls() {
            bases.remove(this);
        }

        boolean isAsked() {
            return heard.stream().anyMatch(CommandAsked.class::isInstance);
        }

        Optional<Role> role() {
            return session.role();
        }

        @Override
        public void send(byte[] frame) {
            throw new IllegalStateException("frames are handed over as they are");
        }

        @Override
        public void send(Frame frame) {
            heard.add(frame.message());
            if (frame.message() instanceof Welcome welcome) {
                term = welcome.term();
            }
        }
    }
}
