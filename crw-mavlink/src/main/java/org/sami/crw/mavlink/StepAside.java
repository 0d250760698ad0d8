package org.sami.crw.mavlink;

import java.util.Optional;
import java.util.function.Consumer;
import org.sami.boat.link.Traffic;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.traffic.CourseAndSpeed;
import org.sami.mavlink.command.GuidedCourse;
import org.sami.mavlink.vehicle.VehiclePosition;
import org.sami.mavlink.vehicle.VehicleSnapshot;

/**
 * Steers a vehicle that is under way around other boats, in mode GUIDED by heading and speed, and lets it go on along its mission once nobody is in the way; has one at
 * the end of its path make room. Only a vehicle that follows an order of the base is steered. For the gateway's thread.
 */
final class StepAside {
    private static final long FREE_MS = 1_000; // for so long nobody is in the way before it goes on by itself
    private static final long RETRY_MS = 2_000;
    private static final long STEER_MS = 200;
    private static final long LONG_MS = 60_000;

    private final String name;
    private final VehicleMotion motion;
    private final PathTargets targets;
    private final Consumer<String> alarm;
    private final VehicleGivingWay rule;
    private long freeSinceMs;
    private long tryFromMs;
    private long steeredMs;
    private long beganMs;
    private boolean isLong; // the operator knows
    private boolean goesOn; // it is being ordered to: a course would undo that
    private long nowMs;

    /**
     * Nobody is near.
     *
     * @param alarm receives what the operator should know
     */
    StepAside(String name, VehicleMotion motion, PathTargets targets, Consumer<String> alarm) {
        this.name = name;
        this.motion = motion;
        this.targets = targets;
        this.alarm = alarm;
        rule = new VehicleGivingWay(name);
    }

    /** The base says who is near. */
    void update(Traffic traffic) {
        rule.update(traffic, nowMs);
    }

    /** Whether another boat is near, which needs to know more often how the vehicle moves. */
    boolean isNearOthers(VehiclePosition at) {
        return rule.isNearOthers(at, nowMs);
    }

    void tick(long atMs) {
        nowMs = atMs;
        VehicleSnapshot vehicle = motion.vehicle();
        Optional<VehicleTarget> target = targets.target();
        Optional<VehiclePosition> at = vehicle.position()
                .filter(known -> vehicle.located() && known.headingDeg().isPresent());
        if (target.isEmpty() || at.isEmpty() || !motion.isHeard()) { // ArduPilot stops where nobody steers it for 3 s
            rule.rest(atMs);
            makeRoom(at);
        } else {
            rule.leaveStation();
            steer(at.get(), target.get());
        }
    }

    /** A vehicle at the end of its path moves aside for one that has to come by. */
    private void makeRoom(Optional<VehiclePosition> at) {
        Optional<Waypoint> end = targets.end();
        if (end.isEmpty()) {
            rule.leaveStation();
        } else if (at.isPresent() && motion.isHeard() && !motion.isBusy() && nowMs >= tryFromMs) {
            VehicleStation station = rule.station(at.get(), nowMs);
            station.next(end.get(), nowMs).ifPresent(place -> {
                tryFromMs = nowMs + RETRY_MS;
                motion.move(place, why -> {
                    if (why.isEmpty()) {
                        station.sentTo(place);
                    }
                });
            });
        }
    }

    private void steer(VehiclePosition at, VehicleTarget target) {
        CourseAndSpeed chosen = rule.choose(at, target, nowMs);
        freeSinceMs = rule.isGivingWay() ? nowMs : Math.min(freeSinceMs, nowMs);
        if (!motion.isAside()) {
            if (rule.isGivingWay() && !motion.isBusy() && nowMs >= tryFromMs) {
                begin();
                motion.steerAside(new GuidedCourse(chosen.courseRad(), chosen.speedMps()));
            }
            return;
        }
        if (goesOn) {
            return;
        }
        if (nowMs - steeredMs >= STEER_MS) {
            steeredMs = nowMs;
            motion.steerAside(new GuidedCourse(chosen.courseRad(), chosen.speedMps()));
        }
        boolean isThrough = rule.isArrived() && !targets.passes(target);
        boolean isFree = nowMs - freeSinceMs >= FREE_MS && rule.canGoOn();
        if ((isThrough || isFree) && !motion.isBusy() && nowMs >= tryFromMs) {
            goOn(target);
        } else if (nowMs - beganMs >= LONG_MS && !isLong) {
            isLong = true;
            alarm.accept(name + " has given way" + words() + " for " + LONG_MS / 1000 + " s");
        }
    }

    /** The boat to which the vehicle gives way now; empty text for none. */
    String toWhom() {
        return motion.isAside() ? rule.nearestWithRightOfWay(nowMs).orElse("") : "";
    }

    private String words() {
        return rule.nearest(nowMs).map(other -> " to " + other).orElse("");
    }

    private void begin() {
        beganMs = nowMs;
        isLong = false;
        motion.stepAside(
                why -> why.filter(words -> !words.equals(VehiclePilot.VOID) && !words.equals(VehiclePilot.TAKEN))
                        .ifPresent(words -> {
                            tryFromMs = nowMs + RETRY_MS;
                            alarm.accept(name + " cannot give way" + words() + ": " + words);
                        }));
    }

    private void goOn(VehicleTarget target) {
        tryFromMs = nowMs + RETRY_MS;
        goesOn = true;
        targets.goOn(target, why -> {
            goesOn = false;
            if (why.isEmpty()) {
                tryFromMs = nowMs;
                rule.goesOn();
            }
        });
    }
}
