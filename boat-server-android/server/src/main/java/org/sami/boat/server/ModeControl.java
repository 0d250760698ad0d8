package org.sami.boat.server;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.SetWaysHome;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.TrackingError;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.traffic.GivingWay;
import org.sami.boat.server.traffic.StationGivingWay;
import org.sami.boat.server.traffic.Surroundings;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Decides what the motors do: follows the waypoint track, keeps station, obeys the hand that drives, returns home, rests.
 * Exactly one mode at a time; only {@link #tick} and the change to a resting mode touch the motors.
 */
final class ModeControl {
    private static final double TURNING_EFFORT = 0.3; // slow enough for pictures
    private static final double ASIDE_MPS = 0.6;
    private static final double NEAR_OTHERS_M = 20;
    private static final double KEPT_NEAR_OTHERS_M = 1.5;

    private final ServerConfig config;
    private final Vehicle vehicle;
    private final SteeringControl steering;
    private final Surroundings surroundings;
    private final GivingWay givingWay;
    private final StationGivingWay stationGivingWay;
    private final StationDrive stationDrive;
    private final PathFollower follower;
    private final LocalFrame home;
    private final WaysHome waysHome;
    private BoatMode mode = BoatMode.STOPPED;
    private boolean moved; // since the server started
    private WaypointTrack track = WaypointTrack.NONE;
    private WaypointTrack wayHome = WaypointTrack.NONE; // that it follows while it returns
    private LocalFrame target;
    private boolean drivingBack;
    private boolean drivesAside;
    private double velocityMultiplier = 1;
    private Optional<Panorama> panorama = Optional.empty(); // while it keeps a station
    private Optional<PanoramaReport> completed = Optional.empty();
    private double thrust;
    private double rudder;
    private long handMs;
    private long lastTickMs = Long.MIN_VALUE;

    ModeControl(ServerConfig config, Vehicle vehicle) {
        this.config = config;
        this.vehicle = vehicle;
        steering = new SteeringControl(vehicle, config);
        surroundings = new Surroundings(config.boatId());
        double positionErrorM =
                config.trackingError().map(TrackingError::positionM).orElse(0.0);
        givingWay = new GivingWay(surroundings, vehicle, positionErrorM);
        stationGivingWay = new StationGivingWay(surroundings, vehicle, config.holdRadiusM(), positionErrorM);
        stationDrive = new StationDrive(vehicle, steering, givingWay);
        follower = new PathFollower(vehicle, steering, givingWay, config.arrivalRadiusM());
        home = here();
        waysHome = new WaysHome(home);
        target = home;
    }

    BoatMode mode() {
        return mode;
    }

    /** Where the vehicle was when its server started. */
    LocalFrame home() {
        return home;
    }

    /** The ways on which it would return there. */
    WaysHome waysHome() {
        return waysHome;
    }

    WaypointTrack track() {
        return track;
    }

    /** The boats near this one. */
    Surroundings surroundings() {
        return surroundings;
    }

    SteeringControl steering() {
        return steering;
    }

    double velocityMultiplier() {
        return velocityMultiplier;
    }

    void setVelocityMultiplier(double multiplier) {
        velocityMultiplier = multiplier;
    }

    /** Takes a new list in place of the old one; a boat on its way along the old one keeps station. */
    void replaceTrack(WaypointTrack newTrack) {
        track = newTrack;
        if (mode == BoatMode.PATH) {
            hold();
        }
    }

    /** Takes the ways home from the list that the boat holds. */
    void setWaysHome(SetWaysHome ways) {
        waysHome.set(ways, track.nextIndex());
    }

    void follow(int index) {
        moved = true;
        track.startAt(index);
        waysHome.start(track.listId(), index);
        surroundings.forgetBorder();
        if (track.isCompleted()) {
            hold();
        } else {
            mode = BoatMode.PATH;
            follower.follow(track);
        }
    }

    void hold() {
        hold(here());
    }

    boolean hasCamera() {
        return vehicle.hasCamera();
    }

    /** Keeps station here and turns all round; what was begun before is forgotten. */
    void takePanorama(TakePanorama command) {
        hold();
        panorama = Optional.of(new Panorama(command));
    }

    /** The panorama that the last tick has completed. */
    Optional<PanoramaReport> takeReport() {
        Optional<PanoramaReport> report = completed;
        completed = Optional.empty();
        return report;
    }

    private void hold(LocalFrame station) {
        moved = true;
        panorama = Optional.empty();
        mode = BoatMode.HOLD;
        target = station;
        drivingBack = false;
        drivesAside = false;
        stationGivingWay.begin();
        stationDrive.begin();
        steering.rest();
    }

    void stop() {
        mode = BoatMode.STOPPED;
        steering.rest();
    }

    void fleetStop() {
        mode = BoatMode.FLEET_STOP;
        steering.rest();
    }

    void teleoperate(double newThrust, double newRudder, long nowMs) {
        moved = true;
        mode = BoatMode.TELEOPERATION;
        thrust = newThrust;
        rudder = newRudder;
        handMs = nowMs;
    }

    /**
     * Does what is set for a lost link, whatever the boat was doing. A fleet stop stays; so does a boat that no command has moved since
     * its server started, which may have been in mid-path: whoever answers for it has not said that it may move again.
     */
    void linkLost(LostLinkAction action) {
        if (mode == BoatMode.FLEET_STOP || !moved) {
            return;
        }
        if (action == LostLinkAction.DRIFT) {
            stop();
        } else if (action == LostLinkAction.RETURN) {
            returnHome();
        } else if (mode != BoatMode.HOLD && (action == LostLinkAction.HOLD || mode != BoatMode.PATH)) {
            hold(); // a boat that keeps a station already keeps that one
        }
    }

    /** On the shortest of the ways that it knows, or straight; one that is on its way already goes on. */
    private void returnHome() {
        if (mode == BoatMode.RETURN) {
            return;
        }
        mode = BoatMode.RETURN;
        List<Waypoint> points = new ArrayList<>(waysHome.turns(vehicle.latDeg(), vehicle.lonDeg()));
        points.add(home.origin(config.returnSpeedMps()));
        wayHome = new WaypointTrack("", points);
        follower.follow(wayHome);
        waysHome.goOn(points.subList(0, points.size() - 1));
    }

    /**
     * Drives on; with motors at zero if that fails.
     *
     * @return whether the progress along the track has changed
     */
    boolean tick(long nowMs) {
        try {
            return drive(nowMs);
        } catch (RuntimeException e) {
            steering.rest();
            throw e;
        }
    }

    private boolean drive(long nowMs) {
        double seconds = lastTickMs == Long.MIN_VALUE ? 0 : (nowMs - lastTickMs) / 1000.0;
        lastTickMs = nowMs;
        surroundings.tick(nowMs);
        switch (mode) {
            case PATH:
                return tickPath(nowMs, seconds);
            case HOLD:
                tickHold(nowMs, seconds);
                return false;
            case RETURN:
                tickReturn(nowMs, seconds);
                return false;
            case TELEOPERATION:
                tickHand(nowMs);
                return false;
            default:
                vehicle.setMotors(0, 0);
                return false;
        }
    }

    private boolean tickPath(long nowMs, double seconds) {
        boolean reached = follower.isAtTarget();
        if (reached) {
            track.reached();
            if (track.isCompleted()) {
                hold(follower.end());
                return true;
            }
            follower.goOn(track);
            waysHome.driveLeg(track.nextIndex());
        }
        follower.steer(velocityMultiplier, nowMs, seconds);
        return reached;
    }

    private void tickHold(long nowMs, double seconds) {
        Optional<LocalFrame> aside = panorama.isPresent() ? Optional.empty() : stationGivingWay.aside(target, nowMs);
        if (aside.isPresent()) {
            drivesAside = true;
            stationDrive.drive(aside.get(), ASIDE_MPS, nowMs, seconds);
            return;
        } else if (drivesAside) {
            drivesAside = false;
            steering.rest();
        }
        double distanceM = steering.distanceM(target);
        boolean isTaken = stationGivingWay.isTaken(target, KEPT_NEAR_OTHERS_M / 2, nowMs);
        double nextToM = stationGivingWay.nextToTakenM();
        double keptM = isTaken ? Math.max(nextToM + KEPT_NEAR_OTHERS_M, config.holdRadiusM()) : keptM(nowMs);
        double enoughM = isTaken ? Math.max(nextToM, keptM / 2) : keptM / 2;
        if (drivingBack && distanceM < enoughM) {
            drivingBack = false;
            steering.rest();
        } else if (distanceM > keptM) {
            drivingBack = true;
        }
        if (drivingBack) {
            stationDrive.drive(target, config.returnSpeedMps(), nowMs, seconds);
        } else if (panorama.isPresent()) {
            tickPanorama(panorama.get());
        }
    }

    /**
     * How far from its station it drifts before it drives back: where others are near it leaves them the way, as long as nobody wants its place and it does
     * not turn all round, which driving back would break off.
     */
    private double keptM(long nowMs) {
        boolean isToStayNear = !panorama.isPresent()
                && surroundings.isNear(vehicle.latDeg(), vehicle.lonDeg(), NEAR_OTHERS_M, nowMs)
                && stationGivingWay.isClear(target, nowMs);
        return isToStayNear ? Math.min(KEPT_NEAR_OTHERS_M, config.holdRadiusM()) : config.holdRadiusM();
    }

    private void tickPanorama(Panorama turn) {
        if (turn.look(vehicle.headingRad())) {
            vehicle.takePicture();
        }
        if (turn.isDone()) {
            panorama = Optional.empty();
            steering.rest();
            completed = Optional.of(new PanoramaReport(
                    turn.command().commandId(), turn.command().pictures(), vehicle.latDeg(), vehicle.lonDeg()));
        } else {
            steering.drive(0, TURNING_EFFORT);
        }
    }

    private void tickReturn(long nowMs, double seconds) {
        if (wayHome.turnsAhead().isEmpty() && steering.distanceM(home) <= config.arrivalRadiusM()) {
            hold(home);
            return;
        }
        if (follower.isAtTarget()) {
            wayHome.reached();
            waysHome.goOn(wayHome.turnsAhead());
            follower.goOn(wayHome);
        }
        follower.steer(1, nowMs, seconds);
    }

    private void tickHand(long nowMs) {
        if (nowMs - handMs >= config.deadmanMs()) {
            stop();
        } else {
            steering.drive(thrust, rudder);
        }
    }

    private LocalFrame here() {
        return new LocalFrame(vehicle.latDeg(), vehicle.lonDeg());
    }
}
