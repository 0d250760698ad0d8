package org.sami.boat.server;

import java.util.Optional;
import java.util.function.Supplier;
import org.sami.boat.link.BoardCondition;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.LostLinkAction;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.TrackingError;
import org.sami.boat.server.traffic.GivingWay;
import org.sami.boat.server.traffic.StationGivingWay;
import org.sami.boat.server.traffic.Surroundings;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Decides what the motors do. The boat is in exactly one mode at a time: {@link ModeTable} says which events change it, and a part for each mode drives the
 * boat. Only {@link #tick} and a change of mode touch the motors.
 */
final class ModeControl {
    private final Vehicle vehicle;
    private final SteeringControl steering;
    private final Surroundings surroundings;
    private final GivingWay givingWay;
    private final PathDrive path;
    private final StationKeeper station;
    private final HomewardDrive homeward;
    private final HandDrive hand;
    private BoatMode mode = BoatMode.STOPPED;
    private boolean moved; // since the server started
    private long lastTickMs = Long.MIN_VALUE;

    ModeControl(ServerConfig config, Vehicle vehicle) {
        this.vehicle = vehicle;
        steering = new SteeringControl(vehicle, config);
        surroundings = new Surroundings(config.boatId());
        double positionErrorM =
                config.trackingError().map(TrackingError::positionM).orElse(0.0);
        givingWay = new GivingWay(surroundings, vehicle, positionErrorM);
        PathFollower follower = new PathFollower(vehicle, steering, givingWay, config.arrivalRadiusM());
        LocalFrame home = config.home().orElseGet(this::here);
        WaysHome waysHome = new WaysHome(home);
        path = new PathDrive(follower, waysHome);
        homeward = new HomewardDrive(config, vehicle, follower, waysHome, home);
        hand = new HandDrive(steering, config.deadmanMs());
        station = new StationKeeper(
                config,
                vehicle,
                steering,
                surroundings,
                new StationGivingWay(surroundings, vehicle, config.holdRadiusM(), positionErrorM),
                new StationDrive(vehicle, steering, givingWay));
    }

    BoatMode mode() {
        return mode;
    }

    /** The boats near this one. */
    Surroundings surroundings() {
        return surroundings;
    }

    /** The boat to which it gives way on a path or on its way home; empty text for none. */
    String givesWayTo(long nowMs) {
        boolean drives = mode == BoatMode.PATH || mode == BoatMode.RETURN;
        return drives && givingWay.isGivingWay()
                ? surroundings
                        .nearestWithRightOfWay(vehicle.latDeg(), vehicle.lonDeg(), nowMs)
                        .orElse("")
                : "";
    }

    SteeringControl steering() {
        return steering;
    }

    /** The waypoint list and its progress. */
    PathDrive path() {
        return path;
    }

    /** The way home. */
    HomewardDrive homeward() {
        return homeward;
    }

    /** The turn all round for a panorama. */
    PanoramaTurn panorama() {
        return station.panorama();
    }

    boolean hasCamera() {
        return vehicle.camera().isPresent();
    }

    Optional<BoardCondition> board() {
        return vehicle.board();
    }

    String cameraTrouble() {
        return vehicle.cameraTrouble();
    }

    /** Whether the boat refuses a command in its present mode. */
    boolean denies(ModeEvent event) {
        return ModeTable.action(mode, event) == ModeAction.DENY;
    }

    /** Takes a new list in place of the old one; a boat on its way along the old one keeps station. */
    void replaceTrack(WaypointTrack newTrack) {
        path.replace(newTrack);
        change(ModeEvent.UPLOAD);
    }

    /** Follows the list from a waypoint on; at the end of the list it keeps station. */
    void follow(int index) {
        path.startAt(index);
        surroundings.forgetBorder();
        change(path.track().isCompleted() ? ModeEvent.START_AT_END : ModeEvent.START);
    }

    /** Keeps station here. */
    void hold() {
        change(ModeEvent.HOLD_POSITION);
    }

    /** Keeps station here and turns all round. */
    void takePanorama(TakePanorama command) {
        change(ModeEvent.PANORAMA);
        station.panorama().begin(command);
    }

    void stop() {
        change(ModeEvent.STOP_MOTORS);
    }

    void fleetStop() {
        change(ModeEvent.FLEET_STOP);
    }

    void release() {
        change(ModeEvent.FLEET_RELEASE);
    }

    /** Sets the motors until the next setting, or until none comes for long; not if the boat {@linkplain #denies denies} it. */
    void teleoperate(double thrust, double rudder, long nowMs) {
        if (change(ModeEvent.TELEOPERATE) == ModeAction.HAND) {
            hand.set(thrust, rudder, nowMs);
        }
    }

    /**
     * Does what is set for a lost link. A boat that no command has moved since its server started, which may have been in mid-path, stays where it is: no
     * operator has said that it may move again. An aircraft that is to turn its motors off lands where it is, as autopilots do.
     */
    void linkLost(LostLinkAction action) {
        if (moved) {
            change(ModeEvent.linkLost(action));
            if (action == LostLinkAction.DRIFT && mode == BoatMode.STOPPED) { // not under a fleet stop
                vehicle.setAltitude(0);
            }
        }
    }

    private ModeAction change(ModeEvent event) {
        return change(event, this::here);
    }

    /**
     * Does at an event what the table says.
     *
     * @param place where the boat keeps station, if that is what it does; asked before anything changes, as a boat may not know where it is
     */
    private ModeAction change(ModeEvent event, Supplier<LocalFrame> place) {
        ModeAction action = ModeTable.action(mode, event);
        Optional<LocalFrame> kept = action == ModeAction.HOLD ? Optional.of(place.get()) : Optional.empty();
        mode = action.after(mode);
        moved |= mode != BoatMode.STOPPED && mode != BoatMode.FLEET_STOP;
        switch (action) {
            case STOP:
            case LOCK:
                steering.rest();
                levelOff();
                break;
            case HOLD:
                levelOff();
                station.begin(kept.get());
                break;
            case PATH:
                path.begin();
                break;
            case HOME:
                homeward.begin();
                break;
            case NONE:
                throw new IllegalStateException(event + " in mode " + mode);
            default: // KEEP, DENY, HAND: nothing begins
        }
        return action;
    }

    /** An aircraft that climbs or descends stays at its altitude. */
    private void levelOff() {
        if (!vehicle.isAtAltitude()) {
            vehicle.setAltitude(vehicle.altM().orElse(0));
        }
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
        surroundings.see(vehicle.vesselsInSight(), nowMs);
        switch (mode) {
            case PATH:
                return drivePath(nowMs, seconds);
            case HOLD:
                station.tick(nowMs, seconds);
                return false;
            case RETURN:
                driveHome(nowMs, seconds);
                return false;
            case TELEOPERATION:
                driveByHand(nowMs);
                return false;
            default:
                vehicle.setMotors(0, 0);
                return false;
        }
    }

    private boolean drivePath(long nowMs, double seconds) {
        boolean reached = path.tick(nowMs, seconds);
        if (path.track().isCompleted()) {
            change(ModeEvent.PATH_DONE, path::end);
        }
        return reached;
    }

    private void driveHome(long nowMs, double seconds) {
        if (homeward.isHome()) {
            change(ModeEvent.HOME_REACHED, homeward::home);
        } else {
            homeward.tick(nowMs, seconds);
        }
    }

    private void driveByHand(long nowMs) {
        if (hand.isSilent(nowMs)) {
            change(ModeEvent.HAND_SILENT);
        } else {
            hand.tick();
        }
    }

    private LocalFrame here() {
        return new LocalFrame(vehicle.latDeg(), vehicle.lonDeg());
    }
}
