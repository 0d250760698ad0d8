package org.sami.boat.server;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.server.vehicle.CameraShot;
import org.sami.boat.server.vehicle.Vehicle;

/** Turns the boat all round on its place and takes the pictures of a panorama. */
final class PanoramaTurn {
    private static final double TURNING_EFFORT = 0.3; // slow enough for pictures
    private static final int MOST_WAITED_TICKS = 100; // 10 s

    private final Vehicle vehicle;
    private final SteeringControl steering;
    private final List<CameraShot> shots = new ArrayList<>();
    private int waitedTicks;
    private Optional<Panorama> panorama = Optional.empty();
    private Optional<PanoramaReport> completed = Optional.empty();

    PanoramaTurn(Vehicle vehicle, SteeringControl steering) {
        this.vehicle = vehicle;
        this.steering = steering;
    }

    void begin(TakePanorama command) {
        panorama = Optional.of(new Panorama(command));
        shots.clear();
        waitedTicks = 0;
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
            vehicle.camera().ifPresent(camera -> shots.add(camera.take()));
        }
        if (turn.isDone()) {
            steering.rest();
            awaitPictures(turn.command());
        } else {
            steering.drive(0, TURNING_EFFORT);
        }
    }

    /** Reports once every picture is kept or has failed; a camera that does not come back is waited for only so long. */
    private void awaitPictures(TakePanorama command) {
        boolean over = shots.stream().allMatch(CameraShot::isOver);
        if (!over && waitedTicks < MOST_WAITED_TICKS) {
            waitedTicks++;
            return;
        }
        List<String> files = new ArrayList<>();
        int kept = 0;
        for (CameraShot shot : shots) {
            if (shot.isKept()) {
                kept++;
                if (!shot.fileName().isEmpty()) {
                    files.add(shot.fileName());
                }
            }
        }
        panorama = Optional.empty();
        if (kept > 0) {
            completed = Optional.of(
                    new PanoramaReport(command.commandId(), kept, vehicle.latDeg(), vehicle.lonDeg(), files));
        }
    }

    /** The panorama that was completed since the last call. */
    Optional<PanoramaReport> takeReport() {
        Optional<PanoramaReport> report = completed;
        completed = Optional.empty();
        return report;
    }
}
