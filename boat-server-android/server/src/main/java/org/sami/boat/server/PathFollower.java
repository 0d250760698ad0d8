package org.sami.boat.server;

import org.sami.boat.link.Waypoint;
import org.sami.boat.server.traffic.CourseAndSpeed;
import org.sami.boat.server.traffic.CourseVector;
import org.sami.boat.server.traffic.GivingWay;
import org.sami.boat.server.traffic.LineAhead;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Drives a vehicle along a waypoint track, leg by leg, on the straight lines between the waypoints and not only towards them. The first leg begins
 * where the vehicle is when it starts to follow the track.
 */
final class PathFollower {
    private static final double DRIFT_THRESHOLD_MPS = 0.1; // turning in still water can look like less
    private static final double STANDING_MPS = 0.3;

    private final Vehicle vehicle;
    private final SteeringControl steering;
    private final GivingWay givingWay;
    private final double arrivalRadiusM;
    private final DriftEstimate drift = new DriftEstimate();
    private LocalFrame end; // of the leg
    private LegGuidance leg;
    private double legMps; // as its waypoint says

    /**
     * A follower.
     *
     * @param arrivalRadiusM distance in metres at which the vehicle may pass a waypoint
     */
    @SuppressWarnings("NullAway.Init") // follow() comes first and sets the leg and its end
    PathFollower(Vehicle vehicle, SteeringControl steering, GivingWay givingWay, double arrivalRadiusM) {
        this.vehicle = vehicle;
        this.steering = steering;
        this.givingWay = givingWay;
        this.arrivalRadiusM = arrivalRadiusM;
    }

    /** Follows a track that is not completed, from the vehicle's position to its target and on. */
    void follow(WaypointTrack track) {
        begin(track, vehicle.latDeg(), vehicle.lonDeg());
    }

    private void begin(WaypointTrack track, double fromLatDeg, double fromLonDeg) {
        Waypoint target = track.target();
        legMps = target.speedMps();
        vehicle.setAltitude(target.altM());
        end = new LocalFrame(target.latDeg(), target.lonDeg());
        double fromEastM = end.eastM(fromLatDeg, fromLonDeg);
        double fromNorthM = end.northM(fromLatDeg, fromLonDeg);
        leg = new LegGuidance(fromEastM, fromNorthM, CornerSpeed.atTarget(track, end, fromEastM, fromNorthM));
        drift.reset();
    }

    /** The end of the current leg. */
    LocalFrame end() {
        return end;
    }

    /** Whether the vehicle has reached the track's target; {@link #goOn} may follow. */
    boolean isAtTarget() {
        return isOverTarget() && vehicle.isAtAltitude();
    }

    private boolean isOverTarget() {
        return leg.isDone(eastM(), northM(), arrivalRadiusM);
    }

    /** Begins the leg from the target just reached to the track's next one. */
    void goOn(WaypointTrack track) {
        begin(track, end.originLatDeg(), end.originLonDeg());
    }

    /**
     * Steers for one tick; rests while the vehicle does not know its position, heading or speed.
     *
     * @param multiplier of the speed of the leg
     */
    void steer(double multiplier, long nowMs, double seconds) {
        double eastM = eastM();
        double northM = northM();
        double headingRad = vehicle.headingRad();
        if (Double.isNaN(eastM + northM + headingRad)) {
            steering.rest();
            drift.reset();
            return;
        }
        if (isOverTarget() && !vehicle.isAtAltitude()) { // it climbs or descends on the spot
            steering.rest();
            drift.reset();
            return;
        }
        CourseVector heading = new CourseVector(headingRad);
        drift.see(eastM, northM, heading, seconds);
        double wantedMps = leg.speedMps(eastM, northM, legMps * multiplier, drift.speedMps());
        double courseRad = leg.courseRad(eastM, northM, wantedMps);
        CourseAndSpeed wanted = new CourseAndSpeed(courseRad, wantedMps);
        LineAhead along = leg.line(eastM, northM, courseRad);
        CourseAndSpeed chosen = givingWay.choose(wanted, heading, along, true, nowMs, seconds);
        if (waits(chosen)) {
            steering.holdAgainst(drift.againstRad(), drift.speedMps(), seconds);
        } else {
            steering.steerAlong(headingRad(chosen), chosen.speedMps(), seconds);
        }
    }

    /** Whether the vehicle waits for others in a current. It then heads into the current: it can only hold its place along its heading. */
    private boolean waits(CourseAndSpeed chosen) {
        return chosen.speedMps() == 0
                && givingWay.isGivingWay()
                && !givingWay.isTurning()
                && drift.speedMps() > DRIFT_THRESHOLD_MPS
                && Math.abs(vehicle.speedMps()) < STANDING_MPS;
    }

    private double headingRad(CourseAndSpeed chosen) {
        double chosenMps = chosen.speedMps();
        return chosenMps > 0 ? drift.headingRad(chosen.course(), chosenMps) : chosen.courseRad();
    }

    private double eastM() {
        return end.eastM(vehicle.latDeg(), vehicle.lonDeg());
    }

    private double northM() {
        return end.northM(vehicle.latDeg(), vehicle.lonDeg());
    }
}
