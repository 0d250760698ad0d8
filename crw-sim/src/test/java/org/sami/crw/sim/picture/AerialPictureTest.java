package org.sami.crw.sim.picture;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.sim.hull.TargetField;
import org.sami.crw.sim.picture.Scene.SeenBoat;
import org.sami.spn.value.GeoPoint;

class AerialPictureTest {
    private static final LocalFrame FRAME = new LocalFrame(45.4, 10.9);
    private static final GeoPoint FAR_HOME = at(5_000, 0, 0);
    private static final Instant NOON = Instant.parse("2026-05-03T10:12:44Z");

    private static GeoPoint at(double eastM, double northM, double upM) {
        double lat = FRAME.latDeg(eastM, northM);
        return new GeoPoint(lat, FRAME.lonDegOn(lat, eastM), upM);
    }

    private static Scene scene(double headingDeg, double upM, SeenBoat... others) {
        return new Scene("uav1", at(0, 0, upM), Math.toRadians(headingDeg), NOON, 1, FAR_HOME, List.of(others));
    }

    @Test
    void cameraInTheAirLooksStraightDownAndOneOnTheGroundAhead() {
        int topOnTheGround = ScenePicture.draw(scene(0, 0)).getRGB(20, 60);
        int topInTheAir = ScenePicture.draw(scene(0, 30)).getRGB(20, 60);

        assertThat(topOnTheGround >> 16 & 0xFF).as("red of the sky").isGreaterThan(100);
        assertThat(topInTheAir >> 16 & 0xFF).as("red of the water").isLessThan(90);
    }

    /** At 30 m the picture is 42 m wide: 10 m are 152 pixels. */
    @Test
    void boatStandsWhereItIsSeenFromTheHeadingAndHeight() {
        SeenBoat eastOfIt = new SeenBoat("b", at(10, 0, 0), 0);

        assertThat(changedAround(scene(0, 30, eastOfIt), 320 + 152, 180))
                .as("heading north")
                .isGreaterThan(100);
        assertThat(changedAround(scene(90, 30, eastOfIt), 320, 180 - 152))
                .as("heading east")
                .isGreaterThan(100);
        assertThat(changedAround(scene(0, 60, eastOfIt), 320 + 76, 180))
                .as("from 60 m")
                .isBetween(25, 700);
        assertThat(changed(scene(180, 5, eastOfIt)))
                .as("outside of the picture")
                .isZero();
    }

    @Test
    void copterIsSeenFromAboveItOnlyAndLargerTheNearerItIs() {
        int low = changed(scene(0, 30, new SeenBoat("c", at(2, 2, 0), 0, true)));
        int near = changed(scene(0, 30, new SeenBoat("c", at(2, 2, 22), 0, true)));

        assertThat(near).isGreaterThan(4 * low);
        assertThat(changed(scene(0, 30, new SeenBoat("c", at(2, 2, 35), 0, true))))
                .isZero();
    }

    @Test
    void targetThatTheDetectorReportsIsInThePictureInItsColour() {
        TargetField.Target target = new TargetField(1).near(45.4, 10.9, 2_000).get(0);
        GeoPoint above = new GeoPoint(target.latDeg(), target.lonDeg(), 20);

        BufferedImage picture = ScenePicture.draw(new Scene("uav1", above, 0, NOON, 1, FAR_HOME, List.of()));

        int rgb = picture.getRGB(320 + 18, 180 + 12); // on the raft's ring
        assertThat(rgb >> 16 & 0xFF).isGreaterThan(200);
        assertThat(rgb & 0xFF).isLessThan(80);
    }

    @Test
    void boatsPictureShowsACopterAboveTheWater() {
        GeoPoint low = at(0, 0, 0);
        BufferedImage without = ScenePicture.draw(new Scene("anna", low, 0, NOON, 1, FAR_HOME, List.of()));
        BufferedImage with = ScenePicture.draw(
                new Scene("anna", low, 0, NOON, 1, FAR_HOME, List.of(new SeenBoat("c", at(0, 40, 6), 0, true))));

        assertThat(differing(without, with, 300, 340, 50, Perspective.HORIZON_Y))
                .isGreaterThan(20);
    }

    private static int changed(Scene scene) {
        return differing(ScenePicture.draw(scene.with(List.of())), ScenePicture.draw(scene), 0, 640, 0, 336);
    }

    private static int changedAround(Scene scene, int x, int y) {
        return differing(
                ScenePicture.draw(scene.with(List.of())), ScenePicture.draw(scene), x - 15, x + 15, y - 15, y + 15);
    }

    private static int differing(BufferedImage one, BufferedImage other, int left, int right, int top, int bottom) {
        int differing = 0;
        for (int x = left; x < right; x++) {
            for (int y = top; y < bottom; y++) {
                differing += one.getRGB(x, y) == other.getRGB(x, y) ? 0 : 1;
            }
        }
        return differing;
    }
}
