package org.sami.boat.server;

import java.util.Optional;
import org.sami.boat.server.traffic.StationGivingWay;
import org.sami.boat.server.traffic.Surroundings;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.boat.server.vehicle.Vehicle;

/**
 * Keeps the boat's station: lets it drift within a radius and drives it back from outside, moves it aside for others, and turns it all round for a panorama.
 */
final class StationKeeper {
    private static final double ASIDE_MPS = 0.6;
    private static final double NEAR_OTHERS_M = 20;
    private static final double KEPT_NEAR_OTHERS_M = 1.5;

    private final ServerConfig config;
    private final Vehicle vehicle;
    private final SteeringControl steering;
    private final Surroundings surroundings;
    private final StationGivingWay givingWay;
    private final StationDrive drive;
    private final PanoramaTurn panorama;
    private LocalFrame station;
    private boolean drivesBack;
    private boolean drivesAside;

    /**
     * A keeper of the station where the vehicle is.
     *
     * @param drive moves the boat
     * @param givingWay finds a place to move aside to
     */
    StationKeeper(
            ServerConfig config,
            Vehicle vehicle,
            SteeringControl steering,
            Surroundings surroundings,
            StationGivingWay givingWay,
            StationDrive drive) {
        this.config = config;
        this.vehicle = vehicle;
        this.steering = steering;
        this.surroundings = surroundings;
        this.givingWay = givingWay;
        this.drive = drive;
        panorama = new PanoramaTurn(vehicle, steering);
        station = new LocalFrame(vehicle.latDeg(), vehicle.lonDeg());
    }

    /** Takes another station; a panorama that was begun is given up. */
    void begin(LocalFrame newStation) {
        panorama.giveUp();
        station = newStation;
        drivesBack = false;
        drivesAside = false;
        givingWay.begin();
        drive.begin();
        steering.rest();
    }

    /** The turn all round that the boat makes while it keeps its station. */
    PanoramaTurn panorama() {
        return panorama;
    }

    /** Keeps the station for one tick. */
    void tick(long nowMs, double seconds) {
        if (isDrivingAside(nowMs, seconds)) {
            return;
        }
        double distanceM = steering.distanceM(station);
        boolean isTaken = givingWay.isTaken(station, KEPT_NEAR_OTHERS_M / 2, nowMs);
        double nextToM = givingWay.nextToTakenM();
        double keptM = isTaken ? Math.max(nextToM + KEPT_NEAR_OTHERS_M, config.holdRadiusM()) : keptM(nowMs);
        double enoughM = isTaken ? Math.max(nextToM, keptM / 2) : keptM / 2;
        if (drivesBack && distanceM < enoughM) {
            drivesBack = false;
            steering.rest();
        } else if (distanceM > keptM) {
            drivesBack = true;
        }
        if (drivesBack) {
            drive.drive(station, config.returnSpeedMps(), nowMs, seconds);
        } else if (panorama.isUnderWay()) {
            panorama.tick();
        }
    }

    private boolean isDrivingAside(long nowMs, double seconds) {
        Optional<LocalFrame> aside = panorama.isUnderWay() ? Optional.empty() : givingWay.aside(station, nowMs);
        if (aside.isPresent()) {
            drivesAside = true;
            drive.drive(aside.get(), ASIDE_MPS, nowMs, seconds);
        } else if (drivesAside) {
            drivesAside = false;
            steering.rest();
        }
        return drivesAside;
    }

    /**
     * How far the boat drifts from its station before it drives back, in metres. Near others it stays close, so that they have room, unless another boat needs
     * its place or it turns all round, which driving back would interrupt.
     */
    private double keptM(long nowMs) {
        boolean isToStayNear = !panorama.isUnderWay()
                && surroundings.isNear(vehicle.latDeg(), vehicle.lonDeg(), NEAR_OTHERS_M, nowMs)
                && givingWay.isClear(station, nowMs);
        return isToStayNear ? Math.min(KEPT_NEAR_OTHERS_M, config.holdRadiusM()) : config.holdRadiusM();
    }
}
