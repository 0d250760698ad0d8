package org.sami.crw.mavlink;

import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Predicate;
import java.util.function.Supplier;
import java.util.stream.IntStream;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.Role;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.SlowableClock;
import org.sami.crw.fleet.RobotKind;
import org.sami.crw.proxy.gateway.GatewayLink;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.crw.proxy.tcp.BoatAddress;
import org.sami.mavlink.link.SigningKey;
import org.sami.spn.protocol.Priority;
import org.sami.spn.value.GeoArea;

/** Commands one vehicle through a gateway by messages of the boat link, each once. */
final class LinkClient implements AutoCloseable {
    private final List<LinkMessage> said = new CopyOnWriteArrayList<>();
    private final List<String> alarms = new CopyOnWriteArrayList<>();
    private final List<Priority> priorities = new CopyOnWriteArrayList<>(); // of those
    private final SlowableClock clock = new SlowableClock();
    private final MavlinkGateway gateway;
    private final String address;
    private GatewayLink link;
    private volatile boolean open;
    private volatile boolean ended;
    private long sent;
    private String term = "";

    /** Connects, says hello as commander, and waits until the vehicle says where it is. */
    LinkClient(Path folder, String address) {
        this(folder, address, Optional.empty());
    }

    /** The same by a base that has the key of a fleet. */
    LinkClient(Path folder, String address, Optional<SigningKey> fleetKey) {
        this(folder, address, () -> fleetKey);
    }

    /** The same by a base whose key is replaced meanwhile. */
    LinkClient(Path folder, String address, Supplier<Optional<SigningKey>> fleetKey) {
        this.address = address;
        gateway = new MavlinkGateway(clock, new VehicleFiles(folder), fleetKey);
        link = connect();
        greet();
        Await.until("it says where it is", () -> first(Telemetry.class).isPresent());
    }

    private GatewayLink connect() {
        return gateway.connect(BoatAddress.parse(address).toSocketAddress(), new Heard());
    }

    private Role greet() {
        Await.until("the vehicle is reached", () -> {
            if (ended) { // it was not heard in time
                ended = false;
                link = connect();
            }
            return open;
        });
        say(new Hello("", "client", Role.COMMANDER, 10, "", "client.0", 1));
        Await.until("it is welcomed", () -> first(Welcome.class).isPresent());
        term = first(Welcome.class).orElseThrow().term();
        return first(Welcome.class).orElseThrow().role();
    }

    /** Whether the gateway's time passes slowly from now on, so that it waits for as long as a test needs. */
    void slow(boolean now) {
        clock.slow(now);
    }

    /** Leaves the vehicle, as a base does that has lost the link to it; the gateway goes on. */
    void leave() {
        link.close();
    }

    /** Says hello as commander over a new connection in place of this one; what the client then is. */
    Role reconnect() {
        link.close();
        open = false;
        ended = false;
        said.clear();
        link = connect();
        return greet();
    }

    private <T extends LinkMessage> Optional<T> first(Class<T> kind) {
        return said.stream().filter(kind::isInstance).map(kind::cast).findFirst();
    }

    /** The last message of a kind that the vehicle has said over this connection. */
    <T extends LinkMessage> Optional<T> last(Class<T> kind) {
        return said.stream().filter(kind::isInstance).map(kind::cast).reduce((before, later) -> later);
    }

    /** How many messages of a kind the vehicle has said over this connection. */
    long count(Class<? extends LinkMessage> kind) {
        return said.stream().filter(kind::isInstance).count();
    }

    /** The links on which the vehicle is reached. */
    List<LinkStatus> linkStatuses() {
        return link.linkStatuses();
    }

    /** The area in which the vehicle may go. */
    void keepTo(Optional<GeoArea> within, List<GeoArea> avoid) {
        keepTo(within, avoid, RobotKind.BOAT);
    }

    /** The area in which the robots of a session of a kind may go. */
    void keepTo(Optional<GeoArea> within, List<GeoArea> avoid, RobotKind robots) {
        gateway.keepTo(within, avoid, robots);
    }

    /** Waits for an alarm with such words. */
    void untilAlarm(String words) {
        Await.until("alarm " + words, () -> hasAlarm(words));
    }

    /** The alarms with such words that have come. */
    List<String> alarms(String words) {
        return alarms.stream().filter(text -> text.contains(words)).toList();
    }

    /** The alarms of a priority that begin so, in their order. */
    List<String> said(String words, Priority priority) {
        return IntStream.range(0, alarms.size())
                .filter(i -> priorities.get(i) == priority && alarms.get(i).startsWith(words))
                .mapToObj(alarms::get)
                .toList();
    }

    /** Whether an alarm with such words has come. */
    boolean hasAlarm(String words) {
        return alarms.stream().anyMatch(text -> text.contains(words));
    }

    /** Takes the command from who has it. */
    void takeCommand() {
        ask(new TakeCommand("take", "client.0", 2));
        Await.until("it commands", () -> last(Welcome.class).orElseThrow().role() == Role.COMMANDER);
        term = last(Welcome.class).orElseThrow().term();
    }

    void say(LinkMessage message) {
        link.send(LinkCodec.STANDARD.encode(new Frame(sent++, term, message)));
    }

    /** Gives a command and waits for its answer. */
    LinkMessage ask(CommandMessage command) {
        say(command);
        return answerTo(command);
    }

    /** Waits for the answer to a command that was given. */
    LinkMessage answerTo(CommandMessage command) {
        Await.until(command.type() + " is answered", () -> answer(command).isPresent());
        return answer(command).orElseThrow();
    }

    /** Whether the vehicle has said that this client only observes it. */
    boolean isObserver() {
        return hasHeard(message -> message instanceof Welcome welcome && welcome.role() == Role.OBSERVER);
    }

    /** Whether the vehicle has said such a thing over this connection. */
    boolean hasHeard(Predicate<LinkMessage> what) {
        return said.stream().anyMatch(what);
    }

    private Optional<LinkMessage> answer(CommandMessage command) {
        String id = command.commandId();
        return said.stream()
                .filter(message -> (message instanceof Ack ack
                                && ack.commandId().equals(id))
                        || (message instanceof Nack nack && nack.commandId().equals(id))
                        || (message instanceof HeldWaypoints held
                                && held.commandId().equals(id)))
                .findFirst();
    }

    @Override
    public void close() {
        gateway.close();
    }

    private final class Heard implements GatewayLink.Listener {
        @Override
        public void opened() {
            open = true;
        }

        @Override
        public void arrived(byte[] frame) {
            try {
                said.add(LinkCodec.STANDARD.decode(frame).message());
            } catch (LinkException e) {
                throw new IllegalStateException(e);
            }
        }

        @Override
        public void said(Priority priority, String text) {
            priorities.add(priority);
            alarms.add(text);
        }

        @Override
        public void closed(String why) {
            open = false;
            ended = true;
        }

        @Override
        public void found(InetSocketAddress vehicle) {
            // it is asked for by its number
        }
    }
}
