package org.sami.crw.mavlink;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.boat.link.Ack;
import org.sami.boat.link.AskForCommand;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FileRefusal;
import org.sami.boat.link.FileRequest;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Frame;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.GrantCommand;
import org.sami.boat.link.Heartbeat;
import org.sami.boat.link.Hello;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.TakeCommand;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.WithdrawKeys;
import org.sami.crw.proxy.gateway.LinkStatus;
import org.sami.spn.protocol.Priority;

/**
 * The boat's end of the link to the base in this process: who commands, in which term, and which commands were answered. The same rules as a boat server's
 * (docs/link.md), for the one client that there can be. A command whose answer the vehicle still owes is not executed again when it is repeated.
 */
final class BaseSession implements VehicleConnection.Receiver {
    private static final int REMEMBERED = 4096;

    /** The vehicle for which the session speaks. */
    interface Boat {
        String name();

        String bootId();

        /** Executes a command; the answer comes at once or later, once. */
        void execute(CommandMessage command, String clientId, java.util.function.Consumer<LinkMessage> answer);

        void teleoperate(double thrust, double rudder);

        /** The base says which boats are near. */
        void near(Traffic traffic);

        /** The base has become commander or observer: battery, settings and progress are sent to it. */
        void introduce();

        /** The base is no longer commander, or its connection has ended. */
        void left();
    }

    private final Boat boat;
    private final VehicleConnection connection;
    private final Map<String, Optional<LinkMessage>> answers =
            new LinkedHashMap<>(); // by command; empty while it is owed
    private CommandEpoch newest = CommandEpoch.NONE;
    private String clientId = "";
    private boolean greeted;
    private boolean commands;
    private String takenBy; // somebody else than the base, who steers the vehicle
    private String term = "";
    private long terms;
    private long newestExecuted = -1;
    private double telemetryHz = 1;

    /**
     * A session in which the base has not said hello yet.
     *
     * @param takenBy who else steers the vehicle, from the session before; empty if nobody does
     */
    BaseSession(Boat boat, VehicleConnection connection, String takenBy) {
        this.boat = boat;
        this.connection = connection;
        this.takenBy = takenBy;
    }

    /** Whether the base has said hello. */
    boolean isGreeted() {
        return greeted && !connection.isOver();
    }

    boolean isCommanded() {
        return commands && !connection.isOver();
    }

    /** Period of telemetry that the base asks for, in ms. */
    long telemetryPeriodMs() {
        return Math.max(1, Math.round(1000 / telemetryHz));
    }

    /** The links on which the vehicle is reached now. */
    void linkStatuses(List<LinkStatus> now) {
        connection.linkStatuses(now);
    }

    void say(LinkMessage message) {
        connection.say(message);
    }

    void alarm(String text) {
        say(Priority.HIGH, text);
    }

    /** Says something to the operator. */
    void say(Priority priority, String text) {
        connection.say(priority, text);
    }

    /** Ends the connection: the base says hello again over the next. */
    void end(String why) {
        connection.end(why);
    }

    void beat(long nowMs) {
        say(new Heartbeat(Math.max(0, nowMs)));
    }

    /** Who steers the vehicle in place of the base; empty if nobody does. */
    String takenBy() {
        return takenBy;
    }

    /** Nobody else steers the vehicle any longer. */
    void givenBack() {
        takenBy = "";
    }

    /** Somebody else steers the vehicle: the base observes until its operator takes it back. */
    void takenBy(String who) {
        boolean isNews = !who.equals(takenBy);
        takenBy = who;
        if (commands) {
            commands = false;
            newest = newest.next(CommandEpoch.NO_BASE, who);
            welcome(Role.OBSERVER);
        } else if (isNews && isGreeted()) { // the same controller in another mode: no appointment of its own
            newest = new CommandEpoch(Math.max(1, newest.number()), CommandEpoch.NO_BASE, who);
            welcome(Role.OBSERVER);
        }
    }

    @Override
    public void received(Frame frame) {
        LinkMessage message = frame.message();
        if (message instanceof Hello hello) {
            greet(hello);
        } else if (message instanceof FileRequest request) {
            say(new FileRefusal(
                    request.requestId(), FileRefusal.Reason.NO_FILES, "an autopilot's files are not fetched"));
        } else if (message instanceof CommandMessage command && greeted) {
            take(command, frame);
        } else if (message instanceof Teleoperate hand
                && commands
                && frame.term().equals(term)) {
            if (frame.sequence() > newestExecuted) {
                newestExecuted = frame.sequence();
                boat.teleoperate(hand.thrust(), hand.rudder());
            }
        } else if (message instanceof Traffic traffic && commands) {
            boat.near(traffic);
        } // heartbeats only have to arrive; what boats say is ignored
    }

    private void greet(Hello hello) {
        if (!hello.boatId().isEmpty() && !hello.boatId().equals(boat.name())) {
            say(new Goodbye(boat.name(), "this boat is " + boat.name()));
            return;
        }
        greeted = true;
        clientId = hello.clientId();
        telemetryHz = hello.telemetryHz() > 0 ? hello.telemetryHz() : telemetryHz;
        if (hello.role() == Role.COMMANDER && takenBy.isEmpty()) {
            appoint(new CommandEpoch(hello.epoch(), hello.session(), clientId));
        } else {
            boolean leaves = commands;
            commands = false;
            if (!takenBy.isEmpty() && newest.clientId().isEmpty()) {
                newest = newest.next(CommandEpoch.NO_BASE, takenBy);
            }
            welcome(Role.OBSERVER);
            if (leaves) {
                boat.left();
            }
        }
    }

    private void appoint(CommandEpoch claim) {
        newest = claim.number() > newest.number() ? claim : newest;
        takenBy = "";
        if (!commands) {
            commands = true;
            term = boat.bootId() + "." + ++terms;
        }
        welcome(Role.COMMANDER);
    }

    private void welcome(Role role) {
        if (connection.isOver()) {
            return; // a vehicle that has started again may not say yet which start it is
        }
        String named = role == Role.COMMANDER ? term : "";
        say(new Welcome(boat.name(), boat.bootId(), role, named, "", true, Optional.of(newest)));
        boat.introduce();
    }

    private void take(CommandMessage command, Frame frame) {
        boolean stops = command instanceof FleetStop || (command instanceof StopMotors && commands);
        Optional<LinkMessage> known = answers.get(command.commandId());
        if (command instanceof TakeCommand take) {
            say(new Ack(take.commandId()));
            appoint(new CommandEpoch(take.epoch(), take.session(), clientId));
        } else if (command instanceof AskForCommand ask) {
            ask(ask);
        } else if (command instanceof GrantCommand grant) {
            refuse(grant, NackReason.UNKNOWN_CLIENT, "no other base is linked to this boat");
        } else if (!commands && !stops) {
            refuse(
                    command,
                    NackReason.NOT_COMMANDER,
                    takenBy.isEmpty() ? "this base observes" : "it is steered by " + takenBy);
        } else if (known != null && !stops) {
            known.ifPresent(this::say);
        } else if (!stops && !frame.term().equals(term)) {
            refuse(command, NackReason.NOT_GREETED, "it does not name the term of the last welcome: say hello again");
        } else if (command instanceof WithdrawKeys) {
            say(new Ack(command.commandId())); // it knows no keys of bases
        } else {
            execute(command, frame);
        }
    }

    private void ask(AskForCommand ask) {
        if (takenBy.isEmpty()) {
            say(new Ack(ask.commandId()));
            appoint(new CommandEpoch(ask.epoch(), ask.session(), clientId));
        } else {
            refuse(ask, NackReason.NOT_ABLE, takenBy + " cannot be asked: take the command");
        }
    }

    private void refuse(CommandMessage command, NackReason reason, String detail) {
        say(new Nack(command.commandId(), reason, detail));
    }

    private void execute(CommandMessage command, Frame frame) {
        newestExecuted = Math.max(newestExecuted, frame.sequence());
        String id = command.commandId();
        answers.put(id, Optional.empty());
        boat.execute(command, clientId, answer -> {
            if (command instanceof ReadBack || !isUsedUp(answer)) {
                answers.remove(id); // asked again, it is answered from how things are then
            } else {
                answers.put(id, Optional.of(answer));
            }
            say(answer);
        });
        if (answers.size() > REMEMBERED) {
            answers.remove(answers.keySet().iterator().next());
        }
    }

    private static boolean isUsedUp(LinkMessage answer) {
        return !(answer instanceof Nack nack)
                || (nack.reason() != NackReason.STALE && nack.reason() != NackReason.NOT_COMMANDER);
    }

    @Override
    public void closed() {
        if (commands) {
            commands = false;
            boat.left();
        }
    }
}
