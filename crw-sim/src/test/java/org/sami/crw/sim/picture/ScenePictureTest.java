package org.sami.crw.sim.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.time.Instant;
import java.util.List;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.sim.picture.Scene.SeenBoat;
import org.sami.spn.value.GeoPoint;

class ScenePictureTest {
    private static final GeoPoint HOME = GeoPoint.of(45.4, 10.9);
    private static final LocalFrame FRAME = new LocalFrame(45.4, 10.9);
    private static final Instant NOON = Instant.parse("2026-05-03T10:12:44Z");

    private static GeoPoint at(double eastM, double northM) {
        double lat = FRAME.latDeg(eastM, northM);
        return GeoPoint.of(lat, FRAME.lonDegOn(lat, eastM));
    }

    private static Scene scene(double headingDeg, long seed, SeenBoat... others) {
        return new Scene("anna", HOME, Math.toRadians(headingDeg), NOON, seed, HOME, List.of(others));
    }

    @Test
    void equalScenesGiveEqualPicturesAndOthersOtherOnes() {
        SeenBoat bert = new SeenBoat("bert", at(2, 12), 1);

        byte[] picture = ScenePicture.jpeg(scene(0, 1, bert));

        assertThat(ScenePicture.jpeg(scene(0, 1, bert))).isEqualTo(picture);
        assertThat(ScenePicture.jpeg(scene(0, 2, bert))).isNotEqualTo(picture);
        assertThat(ScenePicture.jpeg(scene(10, 1, bert))).isNotEqualTo(picture);
    }

    @Test
    void pictureIsAJpegOfTheSizeThatIsSaidAndSmall() throws Exception {
        for (int heading = 0; heading < 360; heading += 45) {
            byte[] picture = ScenePicture.jpeg(scene(heading, 1));

            BufferedImage read = ImageIO.read(new ByteArrayInputStream(picture));
            assertThat(read.getWidth()).isEqualTo(640);
            assertThat(read.getHeight()).isEqualTo(360);
            assertThat(picture.length).isLessThanOrEqualTo(ScenePicture.MOST_BYTES);
        }
    }

    /** Looking north: a boat to the north-east stands to the right, as large as it is far. */
    @Test
    void boatStandsAtItsBearingAndInItsSize() {
        int near = changed(new SeenBoat("b", at(3, 10), Math.PI / 2), true);
        int far = changed(new SeenBoat("b", at(9, 30), Math.PI / 2), true);

        assertThat(near).isGreaterThan(3 * far / 2);
        assertThat(changed(new SeenBoat("b", at(3, 10), Math.PI / 2), false)).isZero();
    }

    @Test
    void boatBehindOrBesideIsNotSeen() {
        for (GeoPoint place : List.of(at(0, -10), at(30, 1), at(-30, 1))) {
            SeenBoat boat = new SeenBoat("b", place, 0);
            assertThat(changed(boat, true) + changed(boat, false)).isZero();
        }
    }

    /** How many pixels of one half of the picture differ where this boat is there. */
    private static int changed(SeenBoat boat, boolean rightHalf) {
        BufferedImage without = ScenePicture.draw(scene(0, 1));
        BufferedImage with = ScenePicture.draw(scene(0, 1, boat));
        int from = rightHalf ? 320 : 0;
        int changed = 0;
        for (int x = from; x < from + 320; x++) {
            for (int y = 0; y < 336; y++) {
                changed += with.getRGB(x, y) == without.getRGB(x, y) ? 0 : 1;
            }
        }
        return changed;
    }
}
