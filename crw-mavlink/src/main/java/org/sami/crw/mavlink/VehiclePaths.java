package org.sami.crw.mavlink;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import org.sami.boat.link.Ack;
import org.sami.boat.link.CommandMessage;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.LinkMessage;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.Progress;
import org.sami.boat.link.StartWaypoints;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.base.MavlinkBase;
import org.sami.mavlink.command.VehicleCommand;
import org.sami.mavlink.vehicle.HeardLink;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * The list of waypoints that the base has given to a vehicle, as an autopilot does it: a path as a mission in AUTO, a single place in GUIDED. How far the
 * vehicle is along it, {@link MissionProgress} judges. For the gateway's thread.
 */
final class VehiclePaths {
    private final MavlinkBase base;
    private final VehicleMotion motion;
    private final MissionStore store;
    private final MissionProgress judged;
    private final PathTargets targets;
    private final StalledListDetector stalled = new StalledListDetector();
    private final Consumer<LinkMessage> broadcast;
    private final Runnable changed;
    private Optional<DrivenList> list;
    private double multiplier = 1;

    /**
     * The list that an earlier base has given to the vehicle, or none.
     *
     * @param radiusM within which the vehicle counts a waypoint as reached, in metres
     * @param changed called when another list, or a further part of one, is to be kept for the next base
     * @param alarm receives faults, in words for the operator
     */
    VehiclePaths(
            MavlinkBase base,
            VehicleMotion motion,
            Executor thread,
            DoubleSupplier radiusM,
            Consumer<LinkMessage> broadcast,
            Runnable changed,
            Consumer<String> alarm,
            VehicleFiles.Kept kept) {
        this.base = base;
        this.motion = motion;
        this.broadcast = broadcast;
        this.changed = changed;
        store = new MissionStore(
                base,
                motion.vehicle().id(),
                thread,
                motion::isInAuto,
                this::isOnNetwork,
                this::further,
                held -> another(),
                alarm);
        judged = new MissionProgress(motion, store, () -> list, radiusM, this::progressed, alarm);
        targets = new PathTargets(
                motion,
                () -> list,
                held -> !isMission(held) || store.holds(list),
                this::speedOf,
                () -> broadcast.accept(progress()));
        list = kept.list().map(upload -> DrivenList.kept(upload, kept.heldTo(), kept.next(), motion.flies()));
    }

    private boolean isOnNetwork() {
        return motion.vehicle().heardOn().stream().noneMatch(HeardLink::slow);
    }

    /** Where the vehicle is under way to, for giving way. */
    PathTargets targets() {
        return targets;
    }

    // ---- how far it is

    /** Whether it has come to the end of its list. */
    boolean isAtEnd() {
        return list.filter(DrivenList::isCompleted).isPresent();
    }

    /** How far it is along its list. */
    Progress progress() {
        return list.map(DrivenList::progress).orElse(new Progress("", 0, false));
    }

    double multiplier() {
        return multiplier;
    }

    /** What the next base needs after a crash of this one. */
    VehicleFiles.Kept kept(String stoppedBy) {
        return new VehicleFiles.Kept(
                stoppedBy,
                list.map(DrivenList::upload),
                list.map(held -> held.window().to()).orElse(0),
                list.map(DrivenList::next).orElse(0));
    }

    /** Whether a vehicle says that its mission has changed as a part of it is on its way. */
    boolean causes(StatusText text) {
        return judged.causes(text);
    }

    void happened(VehicleEvent event) {
        judged.happened(event);
    }

    private void another() {
        judged.replaced("it holds another mission than it was given");
    }

    private void progressed() {
        broadcast.accept(progress());
        keepSpeed();
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

    /** Counts what the vehicle, as it has just reported itself, has reached, and looks whether it has come to the end of its list where an autopilot does not say so. */
    void seen() {
        if (judged.seen()) {
            atEnd();
        }
    }

    private void atEnd() {
        if (list.orElseThrow().advance(list.orElseThrow().waypoints().size())) {
            broadcast.accept(progress());
        }
    }

    /** Whether somebody else has just replaced the mission along which it drives. */
    boolean isReplaced(VehicleSnapshot vehicle) {
        return judged.isReplaced(vehicle);
    }

    void tick(long atMs) {
        store.tick(atMs);
        stalled.stays(motion.vehicle(), atMs)
                .filter(number -> motion.isInAuto() && motion.isOrdered())
                .ifPresent(number -> {
                    var unused = base.command(motion.vehicle().id(), VehicleCommand.setCurrentItem(number));
                });
    }

    /** A further part of a list is held. */
    private void further(DrivenList along, int item) {
        changed.run();
        stalled.stopReplaced(along.window().slot(item));
    }

    /** Another vehicle has its id: nothing that was meant for this one is sent there. */
    void replaced() {
        store.giveUp();
    }

    /** Its autopilot has started again. Its list is kept. */
    void restarted() {
        store.restarted();
    }

    // ---- what is asked

    /**
     * A vehicle that is on its way, sets off, or keeps its place at the end of its way, keeps its place until the new list is started; where it does not, the old one
     * stays. So no item is replaced under a vehicle that carries it out.
     */
    void upload(UploadWaypoints upload, boolean isUnderWay, Consumer<LinkMessage> answer) {
        DrivenList asked = DrivenList.of(upload, motion.flies());
        Optional<Integer> landing = asked.landingUnderWay();
        if (landing.isPresent()) {
            answer.accept(new Nack(
                    upload.commandId(),
                    NackReason.NOT_ABLE,
                    "its autopilot lands only at the end of a path, and waypoint " + landing.get()
                            + " is on the ground"));
            return;
        }
        Runnable taken = () -> {
            list = Optional.of(asked);
            changed.run();
            answer.accept(new Ack(upload.commandId()));
            broadcast.accept(progress());
            list.filter(this::isMission).ifPresent(store::put);
        };
        if (isUnderWay || motion.isInAuto() || motion.isGuided() || motion.isSettingOff()) {
            motion.hold(why -> why.ifPresentOrElse(words -> answer.accept(refused(upload, words)), taken));
        } else {
            taken.run();
        }
    }

    /** The refusal of a command for a reason in words; of one that a later command made void it says so. */
    static Nack refused(CommandMessage command, String why) {
        NackReason reason = switch (why) {
            case VehiclePilot.VOID -> NackReason.STALE;
            case VehiclePilot.TAKEN -> NackReason.NOT_COMMANDER; // it waits until the vehicle is taken back
            default -> NackReason.NOT_ABLE;
        };
        return new Nack(command.commandId(), reason, why);
    }

    /** Whether it goes there by a mission; to a single place a boat goes in GUIDED. */
    private boolean isMission(DrivenList list) {
        return motion.flies() ? !list.waypoints().isEmpty() : list.waypoints().size() > 1;
    }

    /** Answered once the vehicle has read back what it holds. */
    void readBack(CommandMessage command, Consumer<LinkMessage> answer) {
        if (list.isEmpty()) {
            answer.accept(new HeldWaypoints(command.commandId(), "", List.of()));
        } else if (!isMission(list.get())) {
            answer.accept(new HeldWaypoints(
                    command.commandId(), list.get().id(), list.get().waypoints()));
        } else {
            DrivenList asked = list.get();
            store.whenReadBack(asked, why -> {
                if (why.isEmpty()) {
                    catchUp(asked);
                    answer.accept(new HeldWaypoints(command.commandId(), asked.id(), asked.waypoints()));
                } else if (why.get().equals(MissionStore.ANOTHER)) {
                    answer.accept(new HeldWaypoints(command.commandId(), "", List.of()));
                } else {
                    answer.accept(refused(command, why.get()));
                }
            });
        }
    }

    /** What a vehicle has passed while no base commanded it lies behind it. */
    private void catchUp(DrivenList along) {
        if (motion.isInAuto()
                && motion.vehicle().currentItem().filter(along::current).isPresent()) {
            broadcast.accept(along.progress());
        }
    }

    /** Has the vehicle drive from a waypoint on; {@code ended} receives why it does not. */
    void start(StartWaypoints start, Consumer<LinkMessage> answer, Consumer<Optional<String>> ended) {
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
        } else if (!motion.vehicle().armed() && list.get().isOnTheGround(start.index())) {
            started(list.get(), start.index());
            atEnd();
            ended.accept(Optional.empty());
        } else if (!motion.flies() && (start.index() == waypoints - 1 || !isMission(list.get()))) {
            guide(list.get(), start.index(), ended);
        } else {
            follow(list.get(), start.index(), ended);
        }
    }

    private void guide(DrivenList to, int index, Consumer<Optional<String>> ended) {
        Waypoint place = to.waypoints().get(index);
        motion.guide(place, multiplier * place.speedMps(), () -> started(to, index), ended);
    }

    /** What the vehicle does not hold is sent while it keeps its place. */
    private void follow(DrivenList along, int index, Consumer<Optional<String>> ended) {
        if (motion.isInAuto() && !(along.has(index) && store.holds(list))) {
            motion.hold(why -> why.ifPresentOrElse(words -> ended.accept(why), () -> drive(along, index, ended)));
        } else {
            drive(along, index, ended);
        }
    }

    private void drive(DrivenList along, int index, Consumer<Optional<String>> ended) {
        if (!along.has(index)) {
            along.window(along.windowFrom(index));
        }
        motion.follow(then -> store.whenReadBack(along, then), () -> leg(along, index), ended);
    }

    /** A vehicle that drives there already, or has come further meanwhile, is not sent back. */
    private VehicleMotion.Leg leg(DrivenList along, int index) {
        boolean isPast = isPast(along, index);
        return new VehicleMotion.Leg(
                isPast ? Optional.empty() : Optional.of(along.itemOf(index)),
                index == 0 ? along.takeOffItem() : Optional.empty(),
                along.takeOffM().map(metres -> climb(along, index, metres)),
                along.lands(),
                speedOf(isPast ? along.next() : index),
                () -> {
                    if (isPast) {
                        along.countFrom(index);
                    } else {
                        along.startAt(index);
                        judged.sentElsewhere();
                    }
                    judged.sent();
                },
                () -> broadcast.accept(progress()));
    }

    /** To the height of the path's take-off, and to that of the waypoint where it is higher. */
    private VehicleMotion.Climb climb(DrivenList along, int index, double takeOffM) {
        double altM = along.waypoints().get(index).altM();
        return new VehicleMotion.Climb(
                Math.max(takeOffM, altM),
                index == 0 ? 0 : Math.min(takeOffM, altM), // to its first waypoint it goes from wherever it is
                () -> started(along, index),
                then -> store.whenReadBack(along, then),
                () -> leg(along, index));
    }

    /** Whether the vehicle drives along the list already, and to that waypoint or a later one. */
    private boolean isPast(DrivenList along, int index) {
        return motion.isInAuto()
                && !along.isCompleted()
                && along.next() >= index
                && motion.vehicle()
                        .currentItem()
                        .filter(number -> along.isPast(number, index))
                        .isPresent();
    }

    private void started(DrivenList along, int index) {
        along.startAt(index);
        broadcast.accept(progress());
    }

    /** Scales the speed of each leg, of the one under way too where it is. */
    void multiply(double by, boolean isUnderWay) {
        multiplier = by;
        if (isUnderWay && motion.isOrdered()) {
            motion.speed(speedOf(list.orElseThrow().next()));
        }
    }
}
