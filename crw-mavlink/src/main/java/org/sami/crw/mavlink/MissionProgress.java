package org.sami.crw.mavlink;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Consumer;
import java.util.function.DoubleSupplier;
import java.util.function.Supplier;
import org.sami.boat.link.Waypoint;
import org.sami.mavlink.vehicle.StatusText;
import org.sami.mavlink.vehicle.VehicleEvent;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Judges what a vehicle reports of its mission: whether it is progress along the list that it was given, or somebody else has replaced the mission or set its
 * current item forward. For the gateway's thread.
 */
final class MissionProgress {
    private final VehicleMotion motion;
    private final MissionStore store;
    private final Supplier<Optional<DrivenList>> list;
    private final VehicleArrival arrival;
    private final MissionWatch watch;
    private final VehicleTrail trail;
    private final EarlyReports early = new EarlyReports();
    private final UnjudgedReports unjudged = new UnjudgedReports();
    private final Runnable progressed;
    private final Consumer<String> alarm;
    private boolean isForeign; // the mission along which it drives, as was noticed just now

    /**
     * Nothing is reported yet.
     *
     * @param list the list along which the vehicle is to drive; empty where it was given none
     * @param radiusM within which the vehicle counts a waypoint as reached, in metres
     * @param progressed called when a report was progress along the list
     * @param alarm receives faults, in words for the operator
     */
    MissionProgress(
            VehicleMotion motion,
            MissionStore store,
            Supplier<Optional<DrivenList>> list,
            DoubleSupplier radiusM,
            Runnable progressed,
            Consumer<String> alarm) {
        this.motion = motion;
        this.store = store;
        this.list = list;
        arrival = new VehicleArrival(motion);
        watch = new MissionWatch(radiusM);
        trail = new VehicleTrail(radiusM);
        this.progressed = progressed;
        this.alarm = alarm;
    }

    private DrivenList along() {
        return list.get().orElseThrow();
    }

    private boolean isInAuto() {
        return motion.vehicle().mode().equals(VehicleMotion.AUTO);
    }

    /** Whether a vehicle says that its mission has changed as a part of it is on its way. */
    boolean causes(StatusText text) {
        return MissionWatch.isChange(text) && store.isMoving();
    }

    /** Takes what happened to the vehicle. */
    void happened(VehicleEvent event) {
        if (event instanceof VehicleEvent.Said said && MissionWatch.isChange(said.text())) {
            store.doubt();
        }
        if (!store.holds(list.get())) {
            return;
        }
        if (isInAuto()) {
            unjudged.add(event);
            judge();
        } else if (motion.isSettingOff()) {
            early.keep(event);
        }
    }

    /** Takes the vehicle as it has just reported itself. Returns whether it is at the end of its list where an autopilot does not say so. */
    boolean seen() {
        motion.vehicle().position().ifPresent(trail::add);
        if (isInAuto() && store.holds(list.get())) {
            early.take().forEach(unjudged::add);
            judge();
        } else {
            unjudged.forget();
            if (!motion.isSettingOff()) {
                early.forget();
            }
        }
        return list.get()
                .filter(along ->
                        motion.flies() ? store.holds(list.get()) && arrival.hasLanded(along) : arrival.isThere(along))
                .isPresent();
    }

    private void judge() {
        while (store.holds(list.get())) {
            Optional<VehicleEvent> next =
                    unjudged.next(this::isDoubtful, trail, motion.vehicle().heardMs());
            if (next.isEmpty()) {
                return;
            }
            drives(next.get());
        }
        unjudged.forget();
    }

    private boolean isDoubtful(VehicleEvent event) {
        return event instanceof VehicleEvent.ItemCurrent current
                ? !along().passedBy(current.item()).isEmpty()
                : event instanceof VehicleEvent.ItemReached reached
                        && farM(along(), reached).isPresent();
    }

    private void drives(VehicleEvent event) {
        boolean further = false;
        if (event instanceof VehicleEvent.ItemReached reached) {
            further = isReached(along(), reached);
        } else if (event instanceof VehicleEvent.ItemCurrent current) {
            further = isFurther(along(), current);
        }
        if (further) {
            trail.restart();
            progressed.run();
        }
    }

    private static Optional<Waypoint> waypoint(DrivenList along, VehicleEvent.ItemReached reached) {
        return along.waypointOf(reached.item()).map(along.waypoints()::get);
    }

    private Optional<Double> farM(DrivenList along, VehicleEvent.ItemReached reached) {
        return waypoint(along, reached).flatMap(waypoint -> watch.tooFarM(waypoint, reached));
    }

    private boolean isReached(DrivenList along, VehicleEvent.ItemReached reached) {
        Optional<Double> farM = farM(along, reached)
                .filter(metres -> trail.skipped(List.of(waypoint(along, reached).orElseThrow()), reached.heardMs())
                        .isPresent());
        if (farM.isPresent()) {
            replaced(String.format(
                    Locale.ROOT,
                    "it says that it has reached waypoint %d, and is %.0f m from it",
                    along.waypointOf(reached.item()).orElseThrow() + 1,
                    farM.get()));
            return false;
        }
        return along.reached(reached.item());
    }

    /** Of waypoints between, its reports may be lost; but it must have been there. */
    private boolean isFurther(DrivenList along, VehicleEvent.ItemCurrent current) {
        OptionalInt skipped = trail.skipped(along.passedBy(current.item()), current.heardMs());
        if (skipped.isPresent()) {
            replaced("it has left out waypoint " + (along.passed() + skipped.getAsInt() + 1));
            return false;
        }
        return along.current(current.item());
    }

    /** What it reports is no progress along the list any longer. */
    void replaced(String why) {
        store.forget();
        isForeign = true;
        alarm.accept(
                "the mission of vehicle " + motion.vehicle().id() + " is not the one of this base any longer: " + why);
    }

    /** Whether somebody else has just replaced the mission along which it drives. */
    boolean isReplaced(VehicleSnapshot vehicle) {
        if (isForeign) {
            isForeign = false;
            return isTheirs();
        }
        if (!store.holds(list.get())) {
            watch.forget();
            return false;
        }
        boolean isReplaced = watch.isReplaced(along().window().size(), vehicle);
        if (isReplaced) {
            store.forget(); // whoever commands it: what it reports is no progress along the list
        }
        return isReplaced && isTheirs();
    }

    private boolean isTheirs() {
        boolean drives = motion.vehicle().armed() && isInAuto();
        return (drives || motion.isAside()) && motion.isOrdered();
    }

    /** It has taken the item to which it is sent, before a heartbeat tells that it follows the mission. */
    void sent() {
        early.sent();
    }

    /** It is sent to a waypoint that it had not come to: only the way from here on counts. */
    void sentElsewhere() {
        trail.restart();
    }
}
