package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.IntToDoubleFunction;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.sami.boat.link.Waypoint;

/**
 * The waypoint to which a vehicle is under way by order of the base, and what becomes of it while the vehicle gives way and its autopilot does not count. For the
 * gateway's thread.
 */
final class PathTargets {
    private final VehicleMotion motion;
    private final Supplier<Optional<DrivenList>> list;
    private final Predicate<DrivenList> isHeld;
    private final IntToDoubleFunction speedMps;
    private final Runnable progressed;

    /**
     * The targets of a list.
     *
     * @param list that the base has given to the vehicle
     * @param isHeld whether the vehicle holds a list, as far as it has to for driving along it
     * @param speedMps of the leg to a waypoint of the list
     * @param progressed called when a further waypoint counts as reached
     */
    PathTargets(
            VehicleMotion motion,
            Supplier<Optional<DrivenList>> list,
            Predicate<DrivenList> isHeld,
            IntToDoubleFunction speedMps,
            Runnable progressed) {
        this.motion = motion;
        this.list = list;
        this.isHeld = isHeld;
        this.speedMps = speedMps;
        this.progressed = progressed;
    }

    /** The waypoint to which it is under way by order of the base; empty where it is not. */
    Optional<VehicleTarget> target() {
        boolean isUnderWay = motion.vehicle().armed()
                && (motion.isAside() || motion.isGuided() || (motion.isInAuto() && motion.isOrdered()));
        return list.get()
                .filter(held -> isUnderWay && !held.isCompleted() && isFollowed(held))
                .map(held -> new VehicleTarget(
                        held.id(),
                        held.next(),
                        held.waypoints().get(held.next()),
                        speedMps.applyAsDouble(held.next()),
                        held.next() == held.waypoints().size() - 1));
    }

    /** The end of its path, where it lies by order of the base; empty where it does not, and for copters. */
    Optional<Waypoint> end() {
        boolean isKept = motion.vehicle().armed()
                && !motion.isAside()
                && (motion.isGuided() || (motion.isInAuto() && motion.isOrdered()));
        return list.get()
                .filter(held -> isKept && !motion.flies() && held.isCompleted() && isFollowed(held))
                .map(held -> held.waypoints().get(held.waypoints().size() - 1));
    }

    private boolean isFollowed(DrivenList held) {
        return !held.waypoints().isEmpty() && (motion.isGuided() || isHeld.test(held));
    }

    /** It has come to its target while it gives way. Whether it can go on to the next one without its autopilot. */
    boolean passes(VehicleTarget target) {
        DrivenList along = list.get().orElseThrow();
        boolean passes = !target.isLast() && along.has(target.index() + 1);
        if (passes && along.advance(target.index() + 1)) {
            progressed.run();
        }
        return passes;
    }

    /** Has it go on by itself, to where it was under way when it gave way. */
    void goOn(VehicleTarget to, Consumer<Optional<String>> ended) {
        if (to.isLast()) {
            motion.goOn(to.place(), to.speedMps(), ended);
        } else {
            DrivenList along = list.get().orElseThrow();
            motion.goOn(
                    new VehicleMotion.Leg(
                            Optional.of(along.itemOf(to.index())),
                            Optional.empty(),
                            Optional.empty(),
                            false,
                            to.speedMps(),
                            () -> {},
                            () -> {}),
                    ended);
        }
    }
}
