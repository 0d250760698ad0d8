package org.sami.crw.operator.alarm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.proxy.status.BoatPose;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/** Robots that approach each other over the ground, at heights that the test says. */
class ApproachCheckTest {
    private static final GeoPoint HOME = GeoPoint.of(45.6, 10.68);
    private static final double EAST = Math.PI / 2;

    private final ApproachCheck check = new ApproachCheck();

    private static BoatPose pose(double eastM, double altM, double speedMps, long atMillis) {
        GeoPoint ground = Geodesy.offset(HOME, eastM, 0);
        return new BoatPose(new GeoPoint(ground.latDeg(), ground.lonDeg(), altM), EAST, speedMps, atMillis);
    }

    /** What is said of one that flies a metre a second towards another, 2 m before it. */
    private Map<String, Optional<String>> meeting(double altM, double otherAltM) {
        check.at("other", pose(2, otherAltM, 0, 0), 0);
        return check.at("copter1", pose(0, altM, 1, 0), 0);
    }

    @Test
    void copterThatFliesOverABoatOrACopterOnTheGroundApproachesNothing() {
        assertThat(meeting(40, 0)).isEmpty();
    }

    @Test
    void coptersInLayersFourMetresApartApproachNothing() {
        assertThat(meeting(30, 34)).isEmpty();
    }

    @Test
    void coptersOfEqualHeightsApproachEachOther() {
        assertThat(meeting(30, 30))
                .containsEntry("other", Optional.of("copter1 and other come within 0 m of each other in 2 s"));
    }

    @Test
    void distanceThatIsSaidHasTheDifferenceOfHeightsInIt() {
        assertThat(meeting(30, 32))
                .containsEntry("other", Optional.of("copter1 and other come within 2 m of each other in 2 s"));
    }

    @Test
    void copterThatDescendsOntoOneThatHoversIsSaidBeforeItIsThere() {
        check.at("low", pose(0, 20, 0, 0), 0);
        double saidAtM = Double.NaN;
        for (long s = 0; s < 10 && Double.isNaN(saidAtM); s++) {
            double altM = 32 - 1.5 * s;
            boolean said = check.at("high", pose(0.5, altM, 0, s * 1000), s * 1000).values().stream()
                    .anyMatch(Optional::isPresent);
            saidAtM = said ? altM : saidAtM;
        }

        assertThat(saidAtM).isBetween(23.0, 24.5); // 2 s and more before it is as high as the other
    }

    @Test
    void coptersThatMeetWhileOneDescendsToTheHeightOfTheOtherAreSaid() {
        check.at("level", pose(6, 20, 0, 0), 0);
        check.at("descends", pose(-2, 28, 2, 0), 0);

        assertThat(check.at("descends", pose(0, 26, 2, 1000), 1000)) // 20 m high where it meets the other
                .containsEntry("level", Optional.of("descends and level come within 0 m of each other in 3 s"));
    }

    @Test
    void copterThatClimbsAwayFromOneOfItsHeightIsStillSaid() {
        check.at("level", pose(3, 20, 0, 0), 0);
        check.at("climbs", pose(0, 18, 1, 0), 0);

        assertThat(check.at("climbs", pose(1, 20, 1, 1000), 1000).get("level")).isPresent();
    }

    @Test
    void alarmEndsOnceOneHasClimbedAway() {
        meeting(30, 30);

        assertThat(check.at("copter1", pose(1, 40, 0, 1000), 1000)).containsEntry("other", Optional.empty());
    }
}
