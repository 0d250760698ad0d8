package org.sami.crw.sim.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.picture.PictureFolder;
import org.sami.boat.server.vehicle.CameraShot;
import org.sami.spn.value.GeoPoint;

class DrawingCameraTest {
    private static final GeoPoint HERE = GeoPoint.of(45.4, 10.9);
    private static final Scene SCENE = new Scene("anna", HERE, 0, Instant.EPOCH, 1, HERE, List.of());

    @TempDir
    Path folder;

    private final List<String> faults = Collections.synchronizedList(new ArrayList<>());

    @Test
    void keepsWhatLayAheadUnderTheNameThatItSays() throws Exception {
        CameraShot shot;
        try (DrawingCamera camera = camera(PictureFolder.open(folder, "anna"))) {
            shot = camera.take();
        }

        assertThat(shot.isKept()).isTrue();
        assertThat(Files.readAllBytes(folder.resolve(shot.fileName()))).isEqualTo(ScenePicture.jpeg(SCENE));
        assertThat(faults).isEmpty();
    }

    @Test
    void pictureThatCannotBeKeptHasFailedAndIsTold() throws Exception {
        CameraShot shot;
        try (DrawingCamera camera = camera(PictureFolder.open(folder, "anna", 5, 100))) {
            shot = camera.take();
        }

        assertThat(shot.isOver()).isTrue();
        assertThat(shot.isKept()).isFalse();
        assertThat(faults).containsExactly("the picture anna-000001.jpg cannot be kept");
    }

    private DrawingCamera camera(PictureFolder pictures) {
        return new DrawingCamera("anna", pictures, () -> SCENE, (what, why) -> faults.add(what));
    }
}
