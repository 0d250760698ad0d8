package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.server.ServerTestBench.Dummy;
import org.sami.boat.server.vehicle.CameraShot;

class PanoramaFilesTest {
    private final Dummy vehicle = new Dummy();
    private final List<CameraShot> shots = new ArrayList<>();
    private final PanoramaTurn turn = new PanoramaTurn(
            vehicle,
            new SteeringControl(vehicle, ServerConfig.of("anna", "boot").build()));

    private CameraShot take() {
        CameraShot shot = CameraShot.begun("anna-00000" + (shots.size() + 1) + ".jpg");
        shots.add(shot);
        return shot;
    }

    private void turnAllRound(int pictures) {
        vehicle.camera = this::take;
        turn.begin(new TakePanorama("c1", pictures));
        for (int step = 0; step < 40; step++) {
            turn.tick();
            vehicle.headingRad += 0.2;
        }
    }

    @Test
    void reportIsSentWhenAllPicturesAreKeptAndNamesThem() {
        turnAllRound(2);
        shots.get(0).setKept();
        turn.tick();
        assertThat(turn.takeReport()).isEmpty();

        shots.get(1).setKept();
        turn.tick();

        Optional<PanoramaReport> report = turn.takeReport();
        assertThat(report.map(PanoramaReport::files)).contains(List.of("anna-000001.jpg", "anna-000002.jpg"));
        assertThat(turn.isUnderWay()).isFalse();
    }

    @Test
    void pictureThatFailedIsNotNamedNorCounted() {
        turnAllRound(2);
        shots.get(0).setFailed();
        shots.get(1).setKept();
        turn.tick();

        PanoramaReport report = turn.takeReport().get();
        assertThat(report.pictures()).isEqualTo(1);
        assertThat(report.files()).containsExactly("anna-000002.jpg");
    }

    @Test
    void cameraThatDoesNotComeBackIsWaitedForTenSecondsOnly() {
        turnAllRound(2);
        shots.get(0).setKept();
        for (int tick = 0; tick < 101 && turn.isUnderWay(); tick++) {
            turn.tick();
        }

        assertThat(turn.takeReport().map(PanoramaReport::files)).contains(List.of("anna-000001.jpg"));
    }
}
