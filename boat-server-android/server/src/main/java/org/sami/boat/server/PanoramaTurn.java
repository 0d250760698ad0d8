package org.sami.boat.server;

import java.util.Optional;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.server.vehicle.Vehicle;

/** Turns the boat all round on its place and takes the pictures of a panorama. */
final class PanoramaTurn {
    private static final double TURNING_EFFORT = 0.3; // slow enough for pictures

    private final Vehicle vehicle;
    private final SteeringControl steering;
    private Optional<Panorama> panorama = Optional.empty();
    private Optional<PanoramaReport> completed = Optional.empty();

    PanoramaTurn(Vehicle vehicle, SteeringControl steering) {
        this.vehicle = vehicle;
        this.steering = steering;
    }

    void begin(TakePanorama command) {
        panorama = Optional.of(new Panorama(command));
    }

    void giveUp() {
        panorama = Optional.empty();
    }

    boolean isUnderWay() {
        return panorama.isPresent();
    }

    /** Turns on for one tick; only while a panorama is under way. */
    void tick() {
        Panorama turn = panorama.get();
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

    /** The panorama that was completed since the last call. */
    Optional<PanoramaReport> takeReport() {
        Optional<PanoramaReport> report = completed;
        completed = Optional.empty();
        return report;
    }
}
