package org.sami.boat.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.function.BooleanSupplier;
import java.util.function.Function;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.Role;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.server.BoatServer;
import org.sami.boat.server.ServerSession;

/** A client of the boat's server in the same process: asks and is answered at once, and keeps what the boat reports. For the boat's thread. */
final class BoatClient implements FrameSink {
    /** The name with which it commands, for the people at bases. */
    static final String NAME = "ground station (MAVLink)";

    private static final double TELEMETRY_HZ = 10;
    private static final long TELEMETRY_AGE_MS = 2_000; // older telemetry does not say where the boat is now
    private static final int MOST_KEPT = 1000; // of what is not taken yet

    private final BoatServer boat;
    private final ServerSession session;
    private final String sessionId = "mavlink-" + UUID.randomUUID();
    private long sequence;
    private long commands;
    private long lists;
    private String term = "";
    private Role role = Role.OBSERVER;
    private CommandEpoch newest = CommandEpoch.NONE;
    private Optional<LinkMessage> answer = Optional.empty();
    private Optional<Telemetry> telemetry = Optional.empty();
    private Optional<BatteryReport> battery = Optional.empty();
    private Optional<SettingsReport> settings = Optional.empty();
    private List<Progress> progress = new ArrayList<>();
    private String listId = "";
    private List<SensorReport> readings = new ArrayList<>();

    /** A client that observes. */
    BoatClient(BoatServer boat, long nowMs) {
        this.boat = boat;
        session = boat.connect(this);
        hello(Role.OBSERVER, 0, nowMs);
    }

    private void hello(Role wish, long number, long nowMs) {
        say(new Hello("", NAME, wish, TELEMETRY_HZ, "", sessionId, number), nowMs);
    }

    private void say(LinkMessage message, long nowMs) {
        session.receive(new Frame(sequence++, term, message), nowMs);
    }

    /** Whether this client commands the boat, and its link counts as alive. */
    boolean commands() {
        return role == Role.COMMANDER && boat.hasCommander();
    }

    /** Whether this client commanded the boat until its ground station went silent. */
    boolean isLost() {
        return role == Role.COMMANDER && !boat.hasCommander();
    }

    /** The other client that commands the boat. */
    Optional<String> otherCommander() {
        return role == Role.COMMANDER ? Optional.empty() : boat.commandedBy();
    }

    /** The base that was appointed last, as far as the newest welcome says. */
    Optional<String> lastCommander() {
        return Optional.of(newest.clientId()).filter(name -> !name.isEmpty() && !name.equals(NAME));
    }

    /** Takes the command of a boat that nobody commands; whether it has it then. */
    boolean takeVacant(long nowMs) {
        long number = newest.clientId().equals(NAME) && role == Role.COMMANDER ? newest.number() : newest.number() + 1;
        hello(Role.COMMANDER, number, nowMs);
        if (!commands()) { // the welcome has named the newest number
            hello(Role.COMMANDER, newest.number() + 1, nowMs);
        }
        return commands();
    }

    /** Asks the client that commands, so its operator, for the command. Its number 0 gives it nothing where the boat notices only now that the other is lost. */
    void wish(long nowMs) {
        send(id -> new AskForCommand(id, sessionId, 0), nowMs);
    }

    /** Shows the boat that its ground station is there. */
    void alive(long nowMs) {
        say(new Heartbeat(nowMs), nowMs);
    }

    /** Sets the sticks. */
    void steer(Teleoperate sticks, long nowMs) {
        say(sticks, nowMs);
    }

    /** Sends a command; why the boat refuses it, empty where it does not. */
    Optional<String> send(Function<String, CommandMessage> command, long nowMs) {
        answer = Optional.empty();
        say(command.apply(sessionId + "." + ++commands), nowMs);
        LinkMessage now = answer.orElse(new Nack("", NackReason.NOT_ABLE, "no answer"));
        return now instanceof Nack refused ? Optional.of(refused.detail()) : Optional.empty();
    }

    /** Says by what the boat finds out that it is disarmed: it then stays at rest when the ground station is lost. */
    void disarmsBy(BooleanSupplier isDisarmed) {
        session.disarmsBy(isDisarmed);
    }

    /** Another client that has stopped a boat that is stopped already. */
    Optional<String> alsoStoppedBy() {
        return boat.alsoStoppedBy();
    }

    /** An id for a list, which no other client and no earlier start has used. */
    String newListId() {
        return sessionId + ".list" + ++lists;
    }

    /** Whether a list came from this client. */
    boolean isOwnList(String id) {
        return id.startsWith(sessionId + ".");
    }

    /** The list that the boat holds, as far as it has said; empty where it has said nothing of any. */
    String listId() {
        return listId;
    }

    /** Where the boat is and how it moves; empty where it does not know, as without a position fix. */
    Optional<Telemetry> telemetry(long nowMs) {
        return telemetry.filter(last -> nowMs - last.boatTimeMs() <= TELEMETRY_AGE_MS);
    }

    /** The charge that the boat reported last. */
    Optional<Double> batteryPercent() {
        return telemetry.map(Telemetry::batteryPercent);
    }

    Optional<BatteryReport> battery() {
        return battery;
    }

    Optional<SettingsReport> settings() {
        return settings;
    }

    /** What the boat does now. */
    BoatMode mode() {
        return boat.mode();
    }

    /** The list that the boat holds. */
    List<Waypoint> waypoints() {
        return boat.waypoints();
    }

    /** How far the boat has come since this was asked last, oldest first. */
    List<Progress> takeProgress() {
        List<Progress> taken = progress;
        progress = new ArrayList<>();
        return taken;
    }

    /** What was measured since this was asked last. */
    List<SensorReport> takeReadings() {
        List<SensorReport> taken = readings;
        readings = new ArrayList<>();
        return taken;
    }

    /** The link ends; for the boat that is a lost link where this client commands. */
    void close(long nowMs) {
        session.closed(nowMs);
    }

    @Override
    public void send(byte[] frame) {
        throw new IllegalStateException("frames are handed over as they are");
    }

    @Override
    public void send(Frame frame) {
        LinkMessage message = frame.message();
        if (message instanceof Welcome welcome) {
            role = welcome.role();
            term = welcome.term();
            newest = welcome.epoch().orElse(newest);
        } else if (message instanceof Ack || message instanceof Nack) {
            answer = Optional.of(message);
        } else if (message instanceof Telemetry now) {
            telemetry = Optional.of(now);
        } else if (message instanceof BatteryReport now) {
            battery = Optional.of(now);
        } else if (message instanceof SettingsReport now) {
            settings = Optional.of(now);
        } else if (message instanceof Progress now) {
            listId = now.listId();
            if (progress.size() < MOST_KEPT) {
                progress.add(now);
            }
        } else if (message instanceof SensorReport now && readings.size() < MOST_KEPT) {
            readings.add(now);
        }
    }
}
