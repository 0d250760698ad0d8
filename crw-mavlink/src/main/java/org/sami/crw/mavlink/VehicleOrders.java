package org.sami.crw.mavlink;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.FleetRelease;
import org.sami.boat.link.FleetStop;
import org.sami.boat.link.Gains;
import org.sami.boat.link.HeldWaypoints;
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
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * What the base asks of a boat, as an autopilot does it (the table of docs/mavlink.md): paths as missions in AUTO, a single place in GUIDED, keeping a place in
 * LOITER, by hand in MANUAL, stop as disarmed in HOLD. Motors are armed only by these orders. For the gateway's thread.
 */
final class VehicleOrders {
    private static final double ARRIVED_M =
            2.5; // of a place in GUIDED, on which an autopilot does not say that it is there
    private static final double ARRIVED_STILL_M = 3.5;
    private static final double STILL_MPS = 0.15;
    private static final int MOST_WAYPOINTS = 300; // each may need two items, and a vehicle holds some 600

    private final VehicleMotion motion;
    private final MissionStore store;
    private final VehicleSettings settings;
    private final Consumer<LinkMessage> broadcast;
    private final Consumer<VehicleFiles.Kept> keep;
    private Optional<DrivenList> list = Optional.empty();
    private String stoppedBy; // who has latched the fleet stop; empty while it is not latched
    private double multiplier = 1;

    VehicleOrders(
            MavlinkBase base,
            VehicleSnapshot first,
            Executor thread,
            VehicleSettings settings,
            Consumer<LinkMessage> broadcast,
            Consumer<VehicleFiles.Kept> keep,
            VehicleFiles.Kept kept) {
        this.settings = settings;
        this.broadcast = broadcast;
        this.keep = keep;
        motion = new VehicleMotion(base, first, thread);
        store = new MissionStore(base, first.id(), thread);
        stoppedBy = kept.stoppedBy();
        list = kept.list().map(DrivenList::new);
    }

    // ---- what it does

    /** What the vehicle does, as boats say it: by its mode, whoever has put it there. */
    BoatMode mode() {
        VehicleSnapshot now = motion.vehicle();
        if (!now.armed()) {
            return stoppedBy.isEmpty() ? BoatMode.STOPPED : BoatMode.FLEET_STOP;
        }
        boolean there = list.filter(DrivenList::isCompleted).isPresent();
        return switch (now.mode()) {
            case VehicleMotion.AUTO, VehicleMotion.GUIDED -> there ? BoatMode.HOLD : BoatMode.PATH;
            case VehicleMotion.LOITER -> BoatMode.HOLD;
            case "RTL", "SMART_RTL" -> BoatMode.RETURN;
            case VehicleMotion.HOLD, "INITIALIZING" -> BoatMode.STOPPED;
            default -> BoatMode.TELEOPERATION;
        };
    }

    /** How far it is along its list. */
    Progress progress() {
        return list.map(DrivenList::progress).orElse(new Progress("", 0, false));
    }

    /** The settings in force. The autopilot's own gains are no concern of the base. */
    SettingsReport settings() {
        Gains own = new Gains(0, 0, 0);
        LostLinkAction lostLink =
                settings.lostLink().orElse(LostLinkAction.CONTINUE); // it goes on unless it says otherwise
        return new SettingsReport(own, own, multiplier, lostLink, Optional.empty(), Optional.empty(), stoppedBy);
    }

    /** The vehicle reports itself. Whether somebody has taken it from the base just now. */
    boolean reported(VehicleSnapshot vehicle, long atMs) {
        boolean other = motion.reported(vehicle, atMs);
        if (!other) {
            arrive(vehicle);
        }
        return other;
    }

    void happened(VehicleEvent event) {
        boolean driving = motion.vehicle().mode().equals(VehicleMotion.AUTO) && store.holds(list);
        boolean further = false;
        if (driving && event instanceof VehicleEvent.ItemReached reached) {
            further = list.orElseThrow().reached(reached.item());
        } else if (driving && event instanceof VehicleEvent.ItemCurrent current) {
            further = list.orElseThrow().current(current.item());
        }
        if (further) {
            broadcast.accept(progress());
            keepSpeed();
        }
    }

    /** The items of a mission set the speeds of its legs; a multiplier is set after each of them. */
    private void keepSpeed() {
        if (multiplier != 1 && !list.orElseThrow().isCompleted()) {
            motion.speed(speedOf(list.orElseThrow().next()));
        }
    }

    private double speedOf(int waypoint) {
        return multiplier * list.orElseThrow().waypoints().get(waypoint).speedMps();
    }

    /** In GUIDED the autopilot does not say that it has arrived. */
    private void arrive(VehicleSnapshot vehicle) {
        if (motion.isGuided()
                && list.isPresent()
                && !list.get().isCompleted()
                && vehicle.position().isPresent()) {
            Waypoint last = list.get().waypoints().get(list.get().waypoints().size() - 1);
            var at = vehicle.position().get();
            double leftM = new LocalFrame(last.latDeg(), last.lonDeg()).distanceM(at.latDeg(), at.lonDeg());
            if (leftM <= ARRIVED_M || (leftM <= ARRIVED_STILL_M && at.speedMps() < STILL_MPS)) {
                list.get().advance(list.get().waypoints().size());
                broadcast.accept(progress());
            }
        }
    }

    /** Its autopilot has started again. Its list is kept; nothing moves the vehicle before the next command. */
    void restarted() {
        motion.release();
        store.forget();
    }

    void tick(long atMs) {
        motion.tick(atMs);
    }

    /**
     * The base no longer commands it: a vehicle under way keeps its place, like a boat without a commander. A silent vehicle gets no order: it could arrive
     * when somebody else already steers it.
     */
    void left() {
        BoatMode mode = mode();
        boolean ours = motion.isHeard() && (motion.isOrdered() || motion.isBusy());
        if (ours && (mode == BoatMode.PATH || mode == BoatMode.TELEOPERATION)) {
            motion.hold(why -> {});
        }
    }

    // ---- what is asked

    /** Executes a command; the answer comes when the vehicle has done it, or refuses. */
    void execute(CommandMessage command, String clientId, Consumer<LinkMessage> answer) {
        Consumer<Optional<String>> ended = why -> answer.accept(
                why.<LinkMessage>map(words -> refused(command, words)).orElseGet(() -> new Ack(command.commandId())));
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
            readBack(command, answer);
        } else if (command instanceof StartWaypoints start) {
            start(start, answer, ended);
        } else if (command instanceof HoldPosition && stoppedBy.isEmpty()) {
            motion.hold(ended);
        } else if (command instanceof HoldPosition) {
            answer.accept(latched(command));
        } else if (command instanceof SetVelocityMultiplier set) {
            multiply(set);
            answer.accept(new Ack(command.commandId()));
            broadcast.accept(settings());
        } else if (command instanceof SetLostLinkAction set) {
            settings.setLostLink(set.action(), ended);
        } else if (command instanceof TakePanorama) {
            answer.accept(new Nack(
                    command.commandId(),
                    NackReason.NO_CAMERA,
                    "a boat with an autopilot cannot turn on the spot for pictures all round"));
        } else {
            answer.accept(new Nack(
                    command.commandId(),
                    NackReason.NOT_ABLE,
                    "an autopilot takes no " + command.type()
                            + " from here: set its parameters in its ground station"));
        }
    }

    private static Nack refused(CommandMessage command, String why) {
        return why.equals(VehiclePilot.VOID)
                ? new Nack(command.commandId(), NackReason.STALE, why)
                : new Nack(command.commandId(), NackReason.NOT_ABLE, why);
    }

    private static Nack latched(CommandMessage command) {
        return new Nack(command.commandId(), NackReason.FLEET_STOPPED, "the fleet stop is latched");
    }

    private void latch(String clientId) {
        stoppedBy = clientId;
        remember();
        broadcast.accept(settings());
    }

    private void remember() {
        keep.accept(new VehicleFiles.Kept(stoppedBy, list.map(DrivenList::upload)));
    }

    /** A vehicle that is on its way along the old list keeps its place until the new one is started; where it does not, the old one stays. */
    private void upload(UploadWaypoints upload, Consumer<LinkMessage> answer) {
        if (upload.waypoints().size() > MOST_WAYPOINTS) {
            answer.accept(new Nack(
                    upload.commandId(),
                    NackReason.TOO_LONG,
                    upload.waypoints().size() + " waypoints; " + MOST_WAYPOINTS + " are taken"));
            return;
        }
        Runnable taken = () -> {
            list = Optional.of(new DrivenList(upload));
            remember();
            answer.accept(new Ack(upload.commandId()));
            broadcast.accept(progress());
            list.filter(VehicleOrders::isMission).ifPresent(store::put);
        };
        if (mode() == BoatMode.PATH && motion.isOrdered()) {
            motion.hold(why -> why.ifPresentOrElse(words -> answer.accept(refused(upload, words)), taken));
        } else {
            taken.run();
        }
    }

    /** Whether it goes there by a mission; to a single place it goes in GUIDED. */
    private static boolean isMission(DrivenList list) {
        return list.waypoints().size() > 1;
    }

    /** Answered once the vehicle has read back what it holds. */
    private void readBack(CommandMessage command, Consumer<LinkMessage> answer) {
        if (list.isEmpty()) {
            answer.accept(new HeldWaypoints(command.commandId(), "", List.of()));
        } else if (!isMission(list.get())) {
            answer.accept(new HeldWaypoints(
                    command.commandId(), list.get().id(), list.get().waypoints()));
        } else {
            DrivenList asked = list.get();
            store.whenReadBack(
                    asked,
                    why -> answer.accept(why.<LinkMessage>map(words -> refused(command, words))
                            .orElseGet(() -> new HeldWaypoints(command.commandId(), asked.id(), asked.waypoints()))));
        }
    }

    private void start(StartWaypoints start, Consumer<LinkMessage> answer, Consumer<Optional<String>> ended) {
        if (!stoppedBy.isEmpty()) {
            answer.accept(latched(start));
            return;
        }
        if (list.filter(held -> held.id().equals(start.listId())).isEmpty()) {
            answer.accept(new Nack(start.commandId(), NackReason.UNKNOWN_LIST, "this boat holds another list"));
            return;
        }
        int waypoints = list.get().waypoints().size();
        if (start.index() > waypoints) {
            answer.accept(
                    new Nack(start.commandId(), NackReason.BAD_INDEX, "the list has " + waypoints + " waypoints"));
        } else if (start.index() == waypoints) {
            list.get().startAt(start.index());
            motion.hold(ended);
        } else if (start.index() == waypoints - 1 || !isMission(list.get())) {
            guide(list.get(), start.index(), ended);
        } else {
            follow(list.get(), start.index(), ended);
        }
    }

    private void guide(DrivenList to, int index, Consumer<Optional<String>> ended) {
        Waypoint place = to.waypoints().get(index);
        motion.guide(place, multiplier * place.speedMps(), () -> started(to, index), ended);
    }

    private void follow(DrivenList along, int index, Consumer<Optional<String>> ended) {
        motion.follow(
                then -> store.whenReadBack(along, then),
                along.itemOf(index),
                speedOf(index),
                () -> started(along, index),
                ended);
    }

    private void started(DrivenList along, int index) {
        along.startAt(index);
        broadcast.accept(progress());
    }

    private void multiply(SetVelocityMultiplier set) {
        multiplier = set.multiplier();
        if (mode() == BoatMode.PATH && motion.isOrdered()) {
            motion.speed(speedOf(list.orElseThrow().next()));
        }
    }

    /** Sticks of a person, -1 to 1; in force until the next ones, at most for the dead man's time. */
    void teleoperate(double thrust, double rudder) {
        if (stoppedBy.isEmpty()) {
            motion.steer(thrust, rudder);
        }
    }
}
