package org.sami.crw.mavlink;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Gains;
import org.sami.boat.link.HoldPosition;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.SetLostLinkAction;
import org.sami.boat.link.SetVelocityMultiplier;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.StopMotors;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.UploadWaypoints;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleKind;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * What the base asks of a boat, as an autopilot does it (the table of docs/mavlink.md): paths as missions in AUTO, a single place in GUIDED, keeping a place in
 * LOITER, by hand in MANUAL, stop as disarmed in HOLD; of a copter as {@link CopterMotion} says. Motors are armed only by these orders. For the gateway's
 * thread.
 */
final class AutopilotCommands {
    private static final long STICKS_MS = 5_000; // without sticks; then they are a new try
    private static final long REFUSED_MS = 1_000; // after it has refused to be driven by hand, before it is asked again

    private final String name;
    private final VehicleMotion motion;
    private final VehiclePaths paths;
    private final StepAside aside;
    private final VehicleSettings settings;
    private final Consumer<LinkMessage> broadcast;
    private final Consumer<VehicleFiles.Kept> keep;
    private final Consumer<String> alarm;
    private final List<Delayed> afterStop = new ArrayList<>();
    private long atMs; // of the last tick
    private boolean toldWhyNot; // in the present try
    private long refusedMs = Long.MIN_VALUE / 2; // when it refused last to be driven by hand
    private long sticksMs = Long.MIN_VALUE / 2; // when sticks came last
    private String stoppedBy; // who has latched the fleet stop; empty while it is not latched

    /** A list that came while the vehicle was being stopped. */
    private record Delayed(UploadWaypoints upload, Consumer<LinkMessage> answer) {}

    AutopilotCommands(
            String name,
            MavlinkBase base,
            VehicleSnapshot first,
            Executor thread,
            VehicleSettings settings,
            DoubleSupplier radiusM,
            Consumer<LinkMessage> broadcast,
            Consumer<VehicleFiles.Kept> keep,
            Consumer<String> alarm,
            VehicleFiles.Kept kept) {
        this.name = name;
        this.settings = settings;
        this.broadcast = broadcast;
        this.keep = keep;
        this.alarm = alarm;
        motion = first.kind() == VehicleKind.COPTER
                ? new CopterMotion(base, first, thread, () -> broadcast.accept(settings()), alarm)
                : new VehicleMotion(base, first, thread);
        paths = new VehiclePaths(base, motion, thread, radiusM, broadcast, this::remember, alarm, kept);
        aside = new StepAside(name, motion, paths.targets(), alarm);
        stoppedBy = kept.stoppedBy();
    }

    // ---- what it does

    /** What the vehicle does, as boats say it: by its mode, whoever has put it there. */
    BoatMode mode() {
        VehicleSnapshot now = motion.vehicle();
        if (!now.armed()) {
            return stoppedBy.isEmpty() ? BoatMode.STOPPED : BoatMode.FLEET_STOP;
        }
        return switch (now.mode()) {
            case VehicleMotion.AUTO, VehicleMotion.GUIDED -> paths.isAtEnd() ? BoatMode.HOLD : BoatMode.PATH;
            case VehicleMotion.LOITER -> BoatMode.HOLD;
            case CopterMotion.BRAKE -> stoppedBy.isEmpty() ? BoatMode.HOLD : BoatMode.FLEET_STOP;
            case "RTL", "SMART_RTL", "LAND" -> BoatMode.RETURN;
            case VehicleMotion.HOLD, "INITIALIZING" -> BoatMode.STOPPED;
            default -> BoatMode.TELEOPERATION;
        };
    }

    /** Whether the fleet stop is latched and carried out: nothing is sent from here that arms the vehicle. */
    boolean isLatched() {
        return !stoppedBy.isEmpty() && !motion.isStopping();
    }

    /** Whether the vehicle is still carrying out an order. */
    boolean isBusy() {
        return motion.isBusy();
    }

    /** How far it is along its list. */
    Progress progress() {
        return paths.progress();
    }

    /** The settings in force. The autopilot's own gains are no concern of the base. */
    SettingsReport settings() {
        Gains own = new Gains(0, 0, 0);
        LostLinkAction lostLink =
                settings.failsafe().lostLink().orElse(LostLinkAction.CONTINUE); // it goes on unless it says otherwise
        return new SettingsReport(own, own, paths.multiplier(), lostLink, motion.home(), Optional.empty(), stoppedBy)
                .withActionBy(settings.failsafe().words());
    }

    /** The vehicle reports itself. Whether somebody has taken it from the base just now. */
    boolean reported(VehicleSnapshot vehicle, long atMs) {
        boolean other = motion.reported(vehicle, atMs);
        if (!other && paths.isReplaced(vehicle)) {
            motion.release();
            other = true;
        }
        if (!other) {
            paths.seen();
        }
        return other;
    }

    /** Whether somebody else has just started it while the base has ordered nothing. */
    boolean isStartedByOthers() {
        return motion.isStartedByOthers();
    }

    /** Whether a vehicle says so as it is given what the base has ordered. */
    boolean causes(StatusText text) {
        return paths.causes(text);
    }

    void happened(VehicleEvent event) {
        paths.happened(event);
    }

    /** Its autopilot has started again. Its list is kept; nothing moves the vehicle before the next command. */
    void restarted() {
        motion.release();
        paths.restarted();
        giveUpDelayed();
    }

    /** Another vehicle has its id now: nothing that it was ordered goes on. */
    void replaced() {
        motion.release();
        paths.replaced();
        giveUpDelayed();
    }

    void tick(long nowMs) {
        atMs = nowMs;
        motion.tick(atMs);
        paths.tick(atMs);
        aside.tick(atMs);
        if (!motion.isStopping() && !afterStop.isEmpty()) {
            Delayed next = afterStop.remove(0);
            paths.upload(next.upload, mode() == BoatMode.PATH, next.answer);
        }
    }

    /** The base says which boats are near: it gives way to them while it is under way. */
    void near(Traffic traffic) {
        aside.update(traffic);
    }

    /** Whether another boat is near, which needs to know more often how it moves. */
    boolean isNearOthers(VehiclePosition at) {
        return aside.isNearOthers(at);
    }

    /** The boat to which it gives way now; empty text for none. */
    String givesWayTo() {
        return aside.toWhom();
    }

    private void giveUpDelayed() {
        List<Delayed> given = List.copyOf(afterStop);
        afterStop.clear();
        given.forEach(
                each -> each.answer.accept(new Nack(each.upload.commandId(), NackReason.STALE, "it was not begun")));
    }

    /**
     * The base no longer commands it: a vehicle under way, or armed to set off, keeps its place, like a boat without a commander; one that lies still stays so. A silent vehicle gets no order: it could arrive
     * when somebody else already steers it. One that is being stopped is not armed again. One that climbs unheard stays up there.
     */
    void left() {
        giveUpDelayed();
        BoatMode mode = mode();
        boolean ours = motion.isHeard() && !motion.isStopping() && (motion.isOrdered() || motion.isBusy());
        boolean moves = mode == BoatMode.PATH || mode == BoatMode.TELEOPERATION;
        boolean mayMove = motion.isBusy() && motion.vehicle().armed();
        if (ours && (moves || mayMove)) {
            motion.hold(why -> {});
        } else {
            motion.abandon();
        }
    }

    // ---- what is asked

    /** Executes a command; the answer comes when the vehicle has done it, or refuses. */
    void execute(CommandMessage command, String clientId, Consumer<LinkMessage> answer) {
        Consumer<Optional<String>> ended =
                why -> answer.accept(why.<LinkMessage>map(words -> VehiclePaths.refused(command, words))
                        .orElseGet(() -> new Ack(command.commandId())));
        if (command instanceof StopMotors) {
            motion.stop(ended);
        } else if (command instanceof FleetStop) {
            latch(clientId);
            motion.stop(ended);
        } else if (command instanceof FleetRelease) {
            latch("");
            answer.accept(new Ack(command.commandId()));
        } else if (command instanceof UploadWaypoints upload) {
            upload(upload, answer);
        } else if (command instanceof ReadBack) {
            paths.readBack(command, answer);
        } else if ((command instanceof StartWaypoints || command instanceof HoldPosition) && !stoppedBy.isEmpty()) {
            answer.accept(new Nack(command.commandId(), NackReason.FLEET_STOPPED, "the fleet stop is latched"));
        } else if (command instanceof StartWaypoints start) {
            paths.start(start, answer, ended);
        } else if (command instanceof HoldPosition) {
            motion.hold(ended);
        } else if (command instanceof SetVelocityMultiplier set) {
            paths.multiply(set.multiplier(), mode() == BoatMode.PATH);
            answer.accept(new Ack(command.commandId()));
            broadcast.accept(settings());
        } else if (command instanceof SetLostLinkAction set) {
            settings.failsafe().set(set.action(), ended);
        } else {
            answer.accept(new Nack(
                    command.commandId(),
                    NackReason.NOT_ABLE,
                    "an autopilot takes no " + command.type()
                            + " from here: set its parameters in its ground station"));
        }
    }

    /** Waits until a stop is done: an order to keep the place before the upload would undo it. */
    private void upload(UploadWaypoints upload, Consumer<LinkMessage> answer) {
        if (motion.isStopping() || !afterStop.isEmpty()) {
            afterStop.add(new Delayed(upload, answer));
        } else {
            paths.upload(upload, mode() == BoatMode.PATH, answer);
        }
    }

    private void latch(String clientId) {
        stoppedBy = clientId;
        remember();
        broadcast.accept(settings());
    }

    private void remember() {
        keep.accept(paths.kept(stoppedBy));
    }

    /**
     * Sticks of a person, -1 to 1; in force until the next ones, at most for the dead man's time. Why they do not move it is an alarm, once as long as they are held. A
     * copter is not flown so.
     */
    void teleoperate(double thrust, double rudder) {
        if (atMs - sticksMs > STICKS_MS) {
            toldWhyNot = false;
        }
        sticksMs = atMs;
        if (motion.flies()) {
            notDriven("vehicle " + motion.vehicle().id()
                    + " is not flown by hand from here: take its radio control, or send it somewhere");
        } else if (!stoppedBy.isEmpty()) {
            notDriven(name + " is not driven by hand: the fleet stop is latched, release it first");
        } else if (atMs - refusedMs > REFUSED_MS) {
            motion.steer(thrust, rudder, why -> {
                refusedMs = atMs;
                notDriven(name + " is not driven by hand: " + why);
            });
        }
    }

    private void notDriven(String words) {
        if (!toldWhyNot) {
            toldWhyNot = true;
            alarm.accept(words);
        }
    }
}
