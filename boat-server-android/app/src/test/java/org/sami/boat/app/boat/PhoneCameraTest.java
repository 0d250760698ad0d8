package org.sami.boat.app.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatCode;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.server.picture.PictureFolder;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.vehicle.CameraShot;

/** Pictures on the phone: kept one after another, and what becomes of those that fail. */
class PhoneCameraTest {
    @TempDir
    Path folder;

    private final TestPictures pictures = new TestPictures();
    private final List<String> said = new CopyOnWriteArrayList<>();
    private PhoneCamera camera;

    @BeforeEach
    void open() throws IOException {
        camera = new PhoneCamera(pictures, PictureFolder.open(folder, "anna"), said::add);
    }

    @AfterEach
    void close() {
        camera.close();
    }

    private static void awaitEnd(CameraShot shot) {
        Await.until("the picture is over", shot::isOver);
    }

    private List<String> files() throws IOException {
        try (Stream<Path> all = Files.list(folder)) {
            return all.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    @Test
    void pictureIsKeptUnderTheNameThatWasSaidAtOnce() throws Exception {
        CameraShot shot = camera.take();
        awaitEnd(shot);

        assertThat(shot.isKept()).isTrue();
        assertThat(files()).containsExactly(shot.fileName()).containsExactly("anna-000001.jpg");
        assertThat(said).isEmpty();
    }

    @Test
    void pictureThatFailsIsSaidAndTheNextOneIsTaken() throws Exception {
        pictures.setFault("the camera does not open within 5 s");
        CameraShot failed = camera.take();
        awaitEnd(failed);
        assertThat(failed.isKept()).isFalse();
        assertThat(said)
                .containsExactly("the picture anna-000001.jpg was not taken: the camera does not open within 5 s");
        assertThat(camera.failure()).isEqualTo("the camera does not open within 5 s");

        pictures.setFault("");
        CameraShot next = camera.take();
        awaitEnd(next);
        assertThat(next.isKept()).isTrue();
        assertThat(camera.failure()).isEmpty();
    }

    @Test
    void pictureThatIsTooLargeIsNotKeptAndNothingOfItIsLeft() throws Exception {
        pictures.setBytes(PictureFolder.MOST_BYTES_OF_ONE + 1);
        CameraShot shot = camera.take();
        awaitEnd(shot);

        assertThat(shot.isKept()).isFalse();
        assertThat(camera.failure()).contains("more than " + PictureFolder.MOST_BYTES_OF_ONE);
        assertThat(files()).isEmpty();
    }

    @Test
    void moreThanTheCameraTakesAreRefusedAtOnce() throws Exception {
        CountDownLatch open = new CountDownLatch(1);
        PictureSource slow = new PictureSource() {
            @Override
            public String trouble() {
                return "";
            }

            @Override
            public byte[] take(int mostBytes) throws IOException {
                assertThatCode(open::await).doesNotThrowAnyException();
                return new byte[1];
            }
        };
        try (PhoneCamera busy = new PhoneCamera(slow, PictureFolder.open(folder, "olga"), said::add)) {
            List<CameraShot> shots = new ArrayList<>();
            for (int i = 0; i < 40; i++) {
                shots.add(busy.take());
            }
            assertThat(shots.stream().filter(CameraShot::isOver)).as("refused").hasSizeBetween(22, 23);
            assertThat(said).allMatch(text -> text.endsWith("too many pictures wait to be taken"));
            open.countDown();
            shots.forEach(PhoneCameraTest::awaitEnd);
            assertThat(shots.get(0).isKept()).isTrue();
        }
    }
}
