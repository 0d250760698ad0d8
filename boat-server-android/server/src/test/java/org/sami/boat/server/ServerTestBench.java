package org.sami.boat.server;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Role;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.vehicle.Camera;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Sensor;
import org.sami.boat.server.vehicle.Vehicle;

/** A boat server on a test bench: a vehicle moved by hand, clients that write down what they get. */
final class ServerTestBench {
    final Dummy vehicle = new Dummy();
    final List<String> log = new ArrayList<>();
    final BoatServer server;
    private final List<String> clients = new ArrayList<>();
    private final List<CommandMessage> commands = new ArrayList<>(); // with its answer, what the boat's log holds
    private final List<LinkMessage> answers = new ArrayList<>();
    private final String boatId;
    private final int starts;
    private final UnaryOperator<ServerConfig.Builder> config;
    private CommandEpoch epoch = CommandEpoch.NONE;
    long nowMs = 10_000;

    ServerTestBench(Sensor... sensors) {
        this(UnaryOperator.identity(), sensors);
    }

    ServerTestBench(UnaryOperator<ServerConfig.Builder> config, Sensor... sensors) {
        this("boat1", 7, config, sensors);
    }

    /** A boat of another name. */
    ServerTestBench(String boatId) {
        this(boatId, 7, UnaryOperator.identity());
    }

    private ServerTestBench(String boatId, int starts, UnaryOperator<ServerConfig.Builder> config, Sensor... sensors) {
        this.boatId = boatId;
        this.starts = starts;
        this.config = config;
        vehicle.sensors = List.of(sensors);
        server = new BoatServer(
                config.apply(ServerConfig.of(boatId, "boot" + starts)).build(), vehicle, new Log());
    }

    private final class Log implements ServerLog {
        @Override
        public void answered(long ms, String clientId, CommandMessage command, LinkMessage answer) {
            ServerTestBench.this.answered(clientId, command, answer);
        }

        @Override
        public void appointed(CommandEpoch next) {
            epoch = next;
        }

        @Override
        public void leftOut(long ms, long count) {
            log.add("left out: " + count);
        }
    }

    private void answered(String clientId, CommandMessage command, LinkMessage answer) {
        log.add(command.commandId() + " " + answer.type());
        clients.add(clientId);
        commands.add(command);
        answers.add(answer);
    }

    /** Another start of the same boat's server, which takes back its log. */
    ServerTestBench startedAnew() {
        ServerTestBench next = new ServerTestBench(boatId, starts + 1, config);
        for (int i = 0; i < commands.size(); i++) {
            next.server.restore(clients.get(i), commands.get(i), answers.get(i));
            next.clients.add(clients.get(i));
            next.commands.add(commands.get(i));
            next.answers.add(answers.get(i));
        }
        next.server.restore(epoch);
        next.epoch = epoch;
        next.nowMs = nowMs;
        return next;
    }

    Client commander() {
        return client(Role.COMMANDER, 1);
    }

    Client client(Role role, double telemetryHz) {
        Client client = new Client();
        client.say(new Hello(boatId, "test", role, telemetryHz, ""));
        return client;
    }

    /** Ticks at 10 Hz; the given clients keep their links alive. */
    void run(double seconds, Client... alive) {
        for (int i = 0; i < Math.round(seconds * 10); i++) {
            nowMs += 100;
            for (Client client : alive) {
                client.say(new Heartbeat(nowMs));
            }
            server.tick(nowMs);
        }
    }

    /** One client of the server. */
    final class Client {
        final List<LinkMessage> got = new ArrayList<>();
        final ServerSession session;
        private final LinkCodec codec = new LinkCodec();
        private long sequence;
        private String term = "";

        Client() {
            session = server.connect(bytes -> got.add(decoded(bytes)));
        }

        /** Says something, and gives back what it got at once, the answer first. */
        List<LinkMessage> say(LinkMessage message) {
            return say(sequence++, message);
        }

        List<LinkMessage> say(long asSequence, LinkMessage message) {
            return hear(frame(asSequence, message));
        }

        /** A frame as this client sends it now, which may come later. */
        byte[] frame(long asSequence, LinkMessage message) {
            return codec.encode(new Frame(asSequence, term, message));
        }

        /** A frame of this client comes to the boat; gives back what the client got at once. */
        List<LinkMessage> hear(byte[] frame) {
            int before = got.size();
            session.receive(frame, nowMs);
            return got.subList(before, got.size());
        }

        /** Gives a command, and the answer to it. */
        LinkMessage command(CommandMessage command) {
            return say(command).get(0);
        }

        <M extends LinkMessage> List<M> all(Class<M> kind) {
            return got.stream().filter(kind::isInstance).map(kind::cast).toList();
        }

        private LinkMessage decoded(byte[] bytes) {
            try {
                LinkMessage message = codec.decode(bytes).message();
                if (message instanceof Welcome welcome) {
                    term = welcome.term();
                }
                return message;
            } catch (LinkException e) {
                throw new AssertionError(e);
            }
        }
    }

    /** A vehicle that is where the test says. */
    static final class Dummy implements Vehicle {
        private static final LocalFrame FRAME = new LocalFrame(45, 10);
        double eastM;
        double northM;
        double headingRad;
        double speedMps;
        double batteryPercent = 100;
        boolean fails;
        Camera camera;
        Optional<BoardCondition> board = Optional.empty();
        List<Sensor> sensors = List.of();
        double port = 9;
        double starboard = 9;

        boolean isResting() {
            return port == 0 && starboard == 0;
        }

        double thrust() {
            return (port + starboard) / 2;
        }

        double rudder() {
            return (port - starboard) / 2;
        }

        @Override
        public double latDeg() {
            return FRAME.latDeg(eastM, northM);
        }

        @Override
        public double lonDeg() {
            return FRAME.lonDeg(eastM, northM);
        }

        @Override
        public double headingRad() {
            if (fails) {
                throw new IllegalStateException("no compass");
            }
            return headingRad;
        }

        @Override
        public double speedMps() {
            return speedMps;
        }

        @Override
        public double batteryPercent() {
            return batteryPercent;
        }

        @Override
        public Optional<Camera> camera() {
            return Optional.ofNullable(camera);
        }

        @Override
        public Optional<BoardCondition> board() {
            return board;
        }

        @Override
        public List<Sensor> sensors() {
            return sensors;
        }

        @Override
        public void setMotors(double newPort, double newStarboard) {
            port = newPort;
            starboard = newStarboard;
        }
    }
}
