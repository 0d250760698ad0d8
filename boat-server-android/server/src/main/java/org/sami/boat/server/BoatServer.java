package org.sami.boat.server;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandAsked;
import org.sami.boat.link.CommandEpoch;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FileRequest;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Frame;
import org.sami.boat.link.FrameSink;
import org.sami.boat.link.Goodbye;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.Hello;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Motion;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.Role;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Telemetry;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.link.Welcome;
import org.sami.boat.link.WithdrawKeys;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * The boat server: clients command and watch one boat through it (docs/link.md).
 *
 * <p>It has no thread, socket or clock. One thread connects sessions, hands them frames and calls {@link #tick} ten times
 * a second, all with milliseconds of one clock that never runs back; a wall clock will not do.
 *
 * <p>One client commands, others observe. When the commander is silent for the configured time, or its link closes, the boat starts its lost-link action,
 * in every mode except the latched fleet stop. From a lost client it accepts only a hello and commands that stop it. A regained link starts nothing: the
 * lost-link action goes on until the next command. The command changes hands only by a message for it ({@link CommandTransfer}), or when a client asks
 * for it in its hello and no other client has it.
 *
 * <p>Commands older than a stop move nothing. On one link the frames' sequence numbers order them; over all links the term does. Each appointment of a client
 * has a new term, which its welcome names. A frame with another term was sent before the client had read that welcome.
 */
public final class BoatServer {
    private static final String OTHER_TERM = "it does not name the term of the last welcome: say hello again";

    private final ServerConfig config;
    private final Vehicle vehicle;
    private final ServerLog log;
    private final CommandLedger ledger = new CommandLedger();
    private final ModeControl modes;
    private final CommandExecutor executor;
    private final SensorSampler sensors;
    private final StateReports state;
    private final MotionReports motion;
    private final EpochGuard epochs;
    private final TransferRateLimits limits = new TransferRateLimits();
    private final List<ServerSession> sessions = new ArrayList<>();
    private Optional<ServerSession> commander = Optional.empty();
    private boolean commanderLost;
    private String movedBy = ""; // client that set the boat in motion or released it last; empty after a lost link
    private long terms;

    /** A server that keeps no log. */
    public BoatServer(ServerConfig config, Vehicle vehicle) {
        this(config, vehicle, ServerLog.NONE);
    }

    /** A server at rest; where the vehicle is now is its home position. */
    public BoatServer(ServerConfig config, Vehicle vehicle, ServerLog log) {
        this.config = Objects.requireNonNull(config, "config");
        this.vehicle = Objects.requireNonNull(vehicle, "vehicle");
        this.log = Objects.requireNonNull(log, "log");
        epochs = new EpochGuard(log);
        modes = new ModeControl(config, vehicle);
        sensors = new SensorSampler(vehicle);
        executor = new CommandExecutor(config, modes, sensors.channels());
        BatteryWatch battery =
                new BatteryWatch(config, vehicle, modes.homeward().waysHome());
        state = new StateReports(vehicle, battery, modes, executor);
        motion = new MotionReports(vehicle, modes);
    }

    /**
     * Takes back what an earlier start of this server had executed, in its order, before anybody connects: the ids that are
     * not to be executed again, the waypoint list, the settings and the latched fleet stop. It moves nothing: what only
     * concerned motion is remembered, not done.
     *
     * @param clientId who had sent it; empty if that is not known, and its id then counts for all clients
     * @param answer what the boat had answered
     */
    public void restore(String clientId, CommandMessage command, LinkMessage answer) {
        ledger.record(RememberedCommand.of(clientId, command, answer));
        if (answer instanceof Ack) {
            restoreInForce(clientId, command);
        }
    }

    /** Takes back a command of an earlier start of which only this is known any more. */
    public void restore(RememberedCommand command) {
        ledger.record(command);
    }

    /**
     * Takes back what a command of an earlier start has set: the list, its ways home, a setting, the latched stop. Others say nothing: motion is not begun
     * again, and keys and the number of the commander are kept elsewhere.
     */
    public void restoreInForce(String clientId, CommandMessage command) {
        boolean lists = command instanceof UploadWaypoints || command instanceof SetWaysHome;
        if (lists || CommandExecutor.isSetting(command) || CommandExecutor.isLatch(command)) {
            executor.execute(clientId, command);
        }
    }

    /** Takes back who commanded last in earlier starts, before anybody connects: who was replaced by then stays so. */
    public void restore(CommandEpoch epoch) {
        epochs.restore(epoch);
    }

    /** A link to a client has opened; the client then says hello. */
    public ServerSession connect(FrameSink toClient) {
        return connect(toClient, FileProvider.NONE);
    }

    /** A link to a client has opened, which may fetch files; the client then says hello. */
    public ServerSession connect(FrameSink toClient, FileProvider files) {
        ServerSession session = new ServerSession(this, toClient, files);
        sessions.add(session);
        return session;
    }

    /** Lets time pass: failsafes, control, reports. To be called ten times a second. */
    public void tick(long nowMs) {
        watchCommander(nowMs);
        if (modes.tick(nowMs)) {
            broadcast(modes.path().track().progress(), nowMs);
        }
        Optional<PanoramaReport> report = modes.panorama().takeReport();
        if (report.isPresent()) {
            broadcast(report.get(), nowMs);
        }
        reportMotion(nowMs);
        state.tick(nowMs, message -> broadcast(message, nowMs));
        for (ServerSession session : sessions) {
            session.tick(nowMs);
        }
        if (sensors.areDue(nowMs)) { // last: an instrument that fails stops nothing else
            sensors.tick(nowMs, reading -> broadcast(reading, nowMs));
        }
    }

    /** Reports motion to the base while the boat moves near others, often enough for them to give way. */
    private void reportMotion(long nowMs) {
        if (hasCommander() && knowsWhereItIs()) {
            Optional<Motion> report = motion.due(nowMs);
            if (report.isPresent()) {
                commander.get().send(report.get(), nowMs);
            }
        }
    }

    /** What the boat is doing. */
    public BoatMode mode() {
        return modes.mode();
    }

    /** Whether a commander is linked now. */
    public boolean hasCommander() {
        return commander.isPresent() && !commanderLost;
    }

    /** The client that commands now; empty for none. */
    public Optional<String> commandedBy() {
        return commander.filter(session -> !commanderLost).map(ServerSession::clientId);
    }

    /** Another client than the one that latched the fleet stop, which has stopped the boat as well since; empty for none, and after a restart. */
    public Optional<String> alsoStoppedBy() {
        return executor.alsoStoppedBy();
    }

    /** The waypoint list that the boat holds. */
    public List<Waypoint> waypoints() {
        return modes.path().track().waypoints();
    }

    String boatId() {
        return config.boatId();
    }

    /** Also called for each frame: a process that stood still has not ticked, and frames that waited for it are late. */
    private void watchCommander(long nowMs) {
        if (hasCommander() && commander.get().isSilent(nowMs, config.lostLinkAfterMs())) {
            loseCommander();
        }
    }

    void received(ServerSession session, Frame frame, long nowMs) {
        watchCommander(nowMs);
        LinkMessage message = frame.message();
        if (message instanceof Hello) {
            greet(session, (Hello) message, nowMs);
        } else if (message instanceof FileRequest) {
            session.askForFile((FileRequest) message, nowMs);
        } else if (isCommander(session) && commanderLost && !isStopping(message)) {
            refuseLate(session, message, "the link was lost: say hello again", nowMs);
        } else if (message instanceof CommandMessage) {
            command(session, (CommandMessage) message, frame, nowMs);
        } else if (message instanceof Teleoperate) {
            teleoperate(session, (Teleoperate) message, frame, nowMs);
        } else if (message instanceof Traffic && isCommander(session)) {
            modes.surroundings().update((Traffic) message, nowMs);
        } // a heartbeat only has to arrive; messages that boats send are ignored
    }

    /** Refuses a frame after a lost link: it may have been under way all the time; only a new hello shows that the client is there. */
    private static void refuseLate(ServerSession session, LinkMessage message, String why, long nowMs) {
        String id = message instanceof CommandMessage ? ((CommandMessage) message).commandId() : "";
        session.send(new Nack(id, NackReason.NOT_GREETED, why), nowMs);
    }

    void closed(ServerSession session, long nowMs) {
        sessions.remove(session);
        if (isCommander(session)) {
            if (!commanderLost) {
                loseCommander();
            }
            commander = Optional.empty();
        }
    }

    private void loseCommander() {
        boolean staysAtRest =
                modes.mode() == BoatMode.STOPPED && commander.get().hasDisarmed();
        commanderLost = true;
        movedBy = "";
        if (!staysAtRest) {
            modes.linkLost(executor.lostLinkAction());
        }
    }

    private void greet(ServerSession session, Hello hello, long nowMs) {
        if (!hello.boatId().isEmpty() && !hello.boatId().equals(config.boatId())) {
            session.send(new Goodbye(config.boatId(), "this boat is " + config.boatId()), nowMs);
            return;
        }
        boolean vacant = !hasCommander() || isCommander(session);
        session.greeted(hello, config.telemetryHz());
        CommandEpoch claim = new CommandEpoch(hello.epoch(), hello.session(), hello.clientId());
        boolean wishes = hello.role() == Role.COMMANDER && session.granted().equals(Optional.of(Role.COMMANDER));
        Optional<String> refusal = wishes && !isCommander(session) ? epochs.refusal(claim) : Optional.empty();
        if (wishes && vacant && !refusal.isPresent()) {
            epochs.appoint(claim);
            appoint(session, nowMs);
        } else {
            if (isCommander(session)) { // it steps down, and no other client has taken over
                loseCommander();
                commander = Optional.empty();
            }
            introduce(session, Role.OBSERVER, "", nowMs);
            if (refusal.isPresent() && !hello.session().isEmpty()) { // others do not know the reason
                session.send(new Nack("", NackReason.SUPERSEDED, refusal.get()), nowMs);
            }
        }
    }

    /** Appoints a client. The former commander becomes an observer and gets a welcome that says so. The boat goes on with what it does. */
    private void appoint(ServerSession next, long nowMs) {
        Optional<ServerSession> former = commander.filter(session -> session != next);
        boolean goesOn = isCommander(next) && !commanderLost;
        String term = goesOn ? next.term() : newTerm();
        commander = Optional.of(next);
        commanderLost = false;
        former.ifPresent(session -> introduce(session, Role.OBSERVER, "", nowMs));
        introduce(next, Role.COMMANDER, term, nowMs);
    }

    private String newTerm() {
        return config.bootId() + "." + ++terms;
    }

    /** Sends a client its role and the state of the boat. */
    private void introduce(ServerSession session, Role role, String term, long nowMs) {
        session.setRole(role, term);
        session.send(
                new Welcome(config.boatId(), config.bootId(), role, term, "", true, Optional.of(epochs.newest())),
                nowMs);
        session.send(state.battery(), nowMs);
        session.send(executor.settings(), nowMs);
        session.send(modes.path().track().progress(), nowMs);
    }

    private void command(ServerSession session, CommandMessage command, Frame frame, long nowMs) {
        CommandLedger.Known known = ledger.of(session.clientId(), command);
        if (session.role().isPresent() && CommandTransfer.isOne(command)) {
            session.send(transfer(session, command, known, nowMs), nowMs);
        } else if (session.role().isPresent() && !isCommander(session) && command instanceof FleetStop) {
            stopForObserver(session, (FleetStop) command, frame, nowMs);
        } else if (!isCommander(session)) {
            NackReason reason = session.role().isPresent() ? NackReason.NOT_COMMANDER : NackReason.NOT_GREETED;
            session.send(CommandExecutor.nack(command, reason, "this client does not command"), nowMs);
        } else if (command instanceof ReadBack) { // changes nothing, so each one is answered from the present state
            WaypointTrack track = modes.path().track();
            session.send(new HeldWaypoints(command.commandId(), track.listId(), track.waypoints()), nowMs);
        } else if (known == CommandLedger.Known.REPEATED && !isStopAgain(session, command, frame)) {
            session.send(ledger.answerTo(session.clientId(), command), nowMs);
        } else if (known == CommandLedger.Known.DIFFERS && !isStop(command)) {
            session.send(idTaken(command), nowMs);
        } else if (session.isOfAnotherTerm(frame) && !isStopping(command)) {
            refuseLate(session, command, OTHER_TERM, nowMs);
        } else if (session.isOvertaken(frame) && !isStopping(command)) {
            session.send(CommandExecutor.nack(command, NackReason.STALE, "a later command came before"), nowMs);
        } else {
            execute(session, command, frame, nowMs);
        }
    }

    /** Whoever is linked may stop the boat. While it is stopped, further stops leave it as it is and are not logged. */
    private void stopForObserver(ServerSession session, FleetStop stop, Frame frame, long nowMs) {
        boolean isNew = session.stopsAnew(stop.commandId());
        if (modes.mode() == BoatMode.FLEET_STOP) {
            executor.stopAgain(session.clientId());
            session.send(new Ack(stop.commandId()), nowMs);
            if (isNew) {
                outdateCommander(nowMs);
            }
        } else if (!session.isOvertaken(frame)) {
            execute(session, stop, frame, nowMs);
            outdateCommander(nowMs);
        }
    }

    /** What the commander sent before it hears of a stop is older than the stop, a release too. */
    private void outdateCommander(long nowMs) {
        if (hasCommander()) {
            introduce(commander.get(), Role.COMMANDER, newTerm(), nowMs);
        }
    }

    private static LinkMessage idTaken(CommandMessage command) {
        String detail = "this client has sent another command under that id: " + command.type() + " is not executed";
        return CommandExecutor.nack(command, NackReason.ID_TAKEN, detail);
    }

    private LinkMessage transfer(ServerSession session, CommandMessage command, CommandLedger.Known known, long nowMs) {
        if (known != CommandLedger.Known.NEW) {
            boolean repeated = known == CommandLedger.Known.REPEATED;
            return repeated ? ledger.answerTo(session.clientId(), command) : idTaken(command);
        }
        if (!session.granted().equals(Optional.of(Role.COMMANDER))) {
            return CommandExecutor.nack(command, NackReason.NOT_COMMANDER, "this base's key may only observe");
        }
        Optional<ServerSession> present = commander.filter(commanding -> !commanderLost);
        Optional<Nack> superseded =
                epochs.refusal(command, session.clientId(), isCommander(session), present.isPresent());
        if (superseded.isPresent()) {
            return superseded.get();
        }
        CommandTransfer transfer = CommandTransfer.of(command, session, present, sessions);
        if (transfer.asked().isPresent() && !limits.takesWish(session.wishes(), nowMs)) {
            return CommandExecutor.nack(command, NackReason.TOO_OFTEN, "asked too often: ask again in some seconds");
        }
        transfer.asked().ifPresent(commanding -> commanding.send(new CommandAsked(session.clientId()), nowMs));
        transfer.appointed().ifPresent(next -> {
            epochs.appoint(command, next.claimedSession(), next.clientId());
            appoint(next, nowMs);
        });
        if (transfer.answer() instanceof Ack) { // a refused request may be granted the next time
            ledger.record(RememberedCommand.of(session.clientId(), command, transfer.answer()));
        }
        if (transfer.appointed().isPresent()) {
            note(session, command, transfer.answer(), nowMs);
        }
        return transfer.answer();
    }

    /** Logs a change of commander, up to a limit: observers must not fill the log. */
    private void note(ServerSession session, CommandMessage command, LinkMessage answer, long nowMs) {
        if (limits.takesLine(nowMs)) {
            long leftOut = limits.takeLeftOut();
            if (leftOut > 0) {
                log.leftOut(nowMs, leftOut);
            }
            log.answered(nowMs, session.clientId(), command, answer);
        }
    }

    private boolean isCommander(ServerSession session) {
        return commander.isPresent() && commander.get() == session;
    }

    /** Whether a command only stops the boat, which obeys it however late it is. Keeping station does not count for a boat at rest. */
    private boolean isStopping(LinkMessage command) {
        boolean rests = command instanceof HoldPosition && modes.mode() == BoatMode.STOPPED;
        return command instanceof FleetStop || (isStoppingOnly(command) && !rests);
    }

    private static boolean isStop(LinkMessage command) {
        return command instanceof StopMotors || command instanceof FleetStop;
    }

    /**
     * Whether a repeated stop has to stop the boat again, because it moves for another client or for a lost link. Motion that the sender itself has started
     * since goes on, and a late copy of a frame does nothing.
     */
    private boolean isStopAgain(ServerSession session, CommandMessage command, Frame frame) {
        boolean latched = modes.mode() == BoatMode.FLEET_STOP;
        boolean inForce = latched || (command instanceof StopMotors && modes.mode() == BoatMode.STOPPED);
        boolean own = session.clientId().equals(movedBy);
        return isStop(command) && !inForce && !own && !session.isOvertaken(frame);
    }

    private static boolean isStoppingOnly(LinkMessage command) {
        return command instanceof StopMotors || command instanceof HoldPosition;
    }

    private void execute(ServerSession session, CommandMessage command, Frame frame, long nowMs) {
        Progress before = modes.path().track().progress();
        LinkMessage answer = command instanceof WithdrawKeys
                ? withdraw(session, (WithdrawKeys) command, nowMs)
                : executor.execute(session.clientId(), command);
        ledger.record(RememberedCommand.of(session.clientId(), command, answer));
        if (CommandExecutor.isMoving(command) && answer instanceof Ack) {
            movedBy = session.clientId();
        }
        session.executed(frame);
        log.answered(nowMs, session.clientId(), command, answer);
        session.send(answer, nowMs);
        if (CommandExecutor.isSetting(command) || CommandExecutor.isLatch(command)) {
            broadcast(executor.settings(), nowMs);
        }
        if (!modes.path().track().isAt(before)) {
            broadcast(modes.path().track().progress(), nowMs);
        }
    }

    private LinkMessage withdraw(ServerSession by, WithdrawKeys command, long nowMs) {
        try {
            by.withdraw(command);
        } catch (IOException e) {
            return CommandExecutor.nack(command, NackReason.NOT_KEPT, "the keys cannot be kept: " + e.getMessage());
        }
        for (ServerSession session : new ArrayList<>(sessions)) {
            if (!session.granted().isPresent() && session.role().isPresent()) {
                session.turnAway("its key was withdrawn", nowMs);
            }
        }
        return new Ack(command.commandId());
    }

    private void teleoperate(ServerSession session, Teleoperate hand, Frame frame, long nowMs) {
        if (!isCommander(session)) {
            return;
        }
        if (session.isOfAnotherTerm(frame)) {
            refuseLate(session, hand, OTHER_TERM, nowMs);
        } else if (!session.isOvertaken(frame)) {
            session.executed(frame);
            if (!modes.denies(ModeEvent.TELEOPERATE)) {
                movedBy = session.clientId();
                modes.teleoperate(hand.thrust(), hand.rudder(), nowMs);
            }
        }
    }

    private void broadcast(LinkMessage message, long nowMs) {
        for (ServerSession session : sessions) {
            if (session.role().isPresent()) {
                session.send(message, nowMs);
            }
        }
    }

    /** Whether the boat has telemetry: a phone without a fix has none. */
    boolean knowsWhereItIs() {
        return !Double.isNaN(vehicle.latDeg() + vehicle.lonDeg() + vehicle.headingRad() + vehicle.speedMps());
    }

    Telemetry telemetry(long nowMs) {
        return new Telemetry(
                vehicle.latDeg(),
                vehicle.lonDeg(),
                vehicle.headingRad(),
                vehicle.speedMps(),
                vehicle.batteryPercent(),
                modes.mode(),
                nowMs,
                vehicle.altM(),
                modes.givesWayTo(nowMs));
    }
}
