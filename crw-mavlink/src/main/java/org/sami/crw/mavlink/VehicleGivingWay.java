package org.sami.crw.mavlink;

import java.util.Optional;
import org.sami.boat.link.Traffic;
import org.sami.boat.server.LegGuidance;
import org.sami.boat.server.traffic.CourseAndSpeed;
import org.sami.boat.server.traffic.CourseVector;
import org.sami.boat.server.traffic.GivingWay;
import org.sami.boat.server.traffic.Surroundings;
import org.sami.boat.server.vehicle.Kinematics;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.mavlink.vehicle.VehiclePosition;

/**
 * Decides how a vehicle under way gives way to the boats near it, by the rule of the boats with our own server ({@link GivingWay}): which of two boats has the right of
 * way, and what is safe, is the same for all. The vehicle's leg begins where it was when it set off for the waypoint. For the gateway's thread.
 */
final class VehicleGivingWay {
    /** Standard deviation of a vehicle's position along each axis, in metres. The rule keeps 2.1 times that more. */
    private static final double POSITION_ERROR_M = 0.5;

    /** Until a heading and speed take effect: the rule decides for where the vehicle is then. */
    private static final long LATENCY_MS = 300;

    /** A boat with a rudder needs some headway to turn. */
    private static final double TURNING_MPS = 0.3;

    /** The ordered speed exceeds the present one by at most this: autopilots overshoot where they accelerate at once. */
    private static final double GAIN_MPS = 0.4;

    private static final double ARRIVED_M = 2; // at a waypoint, as with an autopilot's WP_RADIUS
    private static final double ON_LINE_M = 0.6;
    private static final double NEAR_M = 20; // within it others need to know more often how the vehicle moves
    private static final long LONGEST_STEP_MS = 1_000;

    private final Surroundings surroundings;
    private final Motion motion = new Motion();
    private final GivingWay rule;
    private final VehicleStation station;
    private Optional<Leg> leg = Optional.empty();
    private long chosenMs;
    private CourseAndSpeed chosen = new CourseAndSpeed(0, 0);

    /** The way to a waypoint. */
    private record Leg(VehicleTarget target, LocalFrame end, LegGuidance guidance, boolean isArrived, double offsetM) {}

    /** The vehicle when what is chosen takes effect, from its last report and the time since. */
    private static final class Motion implements Kinematics {
        private double latDeg;
        private double lonDeg;
        private double headingRad;
        private double speedMps;

        void set(VehiclePosition at, boolean astern, long nowMs) {
            headingRad = Math.toRadians(at.headingDeg().orElse(0.0));
            speedMps = astern ? -at.speedMps() : at.speedMps();
            long aheadMs = Math.min(LONGEST_STEP_MS, Math.max(0, nowMs - at.heardMs())) + LATENCY_MS;
            double wayM = speedMps * aheadMs / 1000;
            LocalFrame plane = new LocalFrame(at.latDeg(), at.lonDeg());
            double eastM = wayM * StrictMath.sin(headingRad);
            double northM = wayM * StrictMath.cos(headingRad);
            latDeg = plane.latDeg(eastM, northM);
            lonDeg = plane.lonDeg(eastM, northM);
        }

        @Override
        public double latDeg() {
            return latDeg;
        }

        @Override
        public double lonDeg() {
            return lonDeg;
        }

        @Override
        public double headingRad() {
            return headingRad;
        }

        @Override
        public double speedMps() {
            return speedMps;
        }
    }

    /** No other boat is near yet. */
    VehicleGivingWay(String boatId) {
        surroundings = new Surroundings(boatId);
        rule = new GivingWay(surroundings, motion, POSITION_ERROR_M, TURNING_MPS);
        station = new VehicleStation(surroundings, motion, POSITION_ERROR_M);
    }

    /** Receives the boats nearby from the base. */
    void update(Traffic traffic, long nowMs) {
        surroundings.update(traffic, nowMs);
    }

    /** The vehicle is not under way by itself: it does not give way. */
    void rest(long nowMs) {
        surroundings.tick(nowMs);
        leg = Optional.empty();
        chosenMs = nowMs;
    }

    /** Makes room at the end of its path, by {@link VehicleStation#next}; after {@link #rest}. */
    VehicleStation station(VehiclePosition at, long nowMs) {
        motion.set(at, false, nowMs);
        return station;
    }

    /** It does not lie at the end of its path. */
    void leaveStation() {
        station.leave();
    }

    /**
     * Heading and speed now, to the target or around others.
     *
     * @param at a position with a heading
     */
    CourseAndSpeed choose(VehiclePosition at, VehicleTarget target, long nowMs) {
        surroundings.tick(nowMs);
        motion.set(at, chosen.speedMps() < 0 && rule.isGivingWay(), nowMs);
        Leg to = leg.filter(one -> one.target.isSame(target)).orElseGet(() -> begin(target));
        double eastM = to.end.eastM(motion.latDeg, motion.lonDeg);
        double northM = to.end.northM(motion.latDeg, motion.lonDeg);
        double courseRad = to.guidance.courseRad(eastM, northM, target.speedMps());
        leg = Optional.of(new Leg(
                target,
                to.end,
                to.guidance,
                to.guidance.isDone(eastM, northM, ARRIVED_M) || Math.hypot(eastM, northM) <= ARRIVED_M / 2,
                to.guidance.line(eastM, northM, courseRad).offsetM()));
        double seconds = Math.min(LONGEST_STEP_MS, Math.max(0, nowMs - chosenMs)) / 1000.0;
        chosenMs = nowMs;
        chosen = rule.choose(
                new CourseAndSpeed(courseRad, target.speedMps()),
                new CourseVector(motion.headingRad),
                to.guidance.line(eastM, northM, courseRad),
                true,
                nowMs,
                seconds);
        return new CourseAndSpeed(chosen.courseRad(), orderedMps());
    }

    /** As fast as the rule assumes that a boat is while it turns to its course. */
    private double orderedMps() {
        if (rule.isTurning()) {
            return TURNING_MPS;
        }
        if (chosen.speedMps() <= 0) {
            return chosen.speedMps();
        }
        double turned = StrictMath.cos(chosen.courseRad() - motion.headingRad);
        double mps = rule.whileTurningMps(chosen.speedMps(), turned);
        return Math.min(mps, Math.max(0, motion.speedMps) + GAIN_MPS);
    }

    private Leg begin(VehicleTarget target) {
        LocalFrame end = new LocalFrame(target.place().latDeg(), target.place().lonDeg());
        double eastM = end.eastM(motion.latDeg, motion.lonDeg);
        double northM = end.northM(motion.latDeg, motion.lonDeg);
        return new Leg(target, end, new LegGuidance(eastM, northM, target.speedMps()), false, 0);
    }

    /** The vehicle goes on by itself: from here straight to its target. */
    void goesOn() {
        leg = Optional.empty();
    }

    /** Whether it leaves its course or speed because of others. */
    boolean isGivingWay() {
        return !surroundings.isEmpty() && rule.isGivingWay();
    }

    /** Whether it is at its target. */
    boolean isArrived() {
        return leg.filter(Leg::isArrived).isPresent();
    }

    /** Whether the way from here straight to its target is free of no-go areas: it is back on its line, or none is near. */
    boolean canGoOn() {
        return !surroundings.hasEdges()
                || leg.filter(one -> Math.abs(one.offsetM) <= ON_LINE_M).isPresent();
    }

    /** The boat with the right of way that is nearest to it; empty where none is near. */
    Optional<String> nearestWithRightOfWay(long nowMs) {
        return surroundings.nearestWithRightOfWay(motion.latDeg, motion.lonDeg, nowMs);
    }

    /** The boat nearest to it. */
    Optional<String> nearest(long nowMs) {
        return surroundings.nearest(motion.latDeg, motion.lonDeg, nowMs);
    }

    /** Whether another boat is so near to a position that it needs to know more often how the vehicle moves. */
    boolean isNearOthers(VehiclePosition at, long nowMs) {
        return !surroundings.isEmpty() && surroundings.isNear(at.latDeg(), at.lonDeg(), NEAR_M, nowMs);
    }
}
