package org.sami.crw.service.reach;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

class WayDangerTest {
    private static final GeoPoint ORIGIN = GeoPoint.of(45.4, 10.9);
    private static final GeoArea ROCK = box(40, -20, 80, 20);
    private static final Water CALM = water(CrossTrackError.CALM);
    private static final Water FIELD = water(CrossTrackError.FIELD);

    private static Water water(CrossTrackError error) {
        return Water.of(ORIGIN, List.of(ROCK), Optional.empty()).drivenWith(error);
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(east, south), at(east, north), at(west, north)), List.of());
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(ORIGIN, eastM, northM);
    }

    @Test
    void wayAroundInCalmWaterIsNoDanger() {
        assertThat(WayDanger.of(at(0, 0), List.of(at(120, 0)), CALM)).isEmpty();
    }

    @Test
    void pointInsideIsNamedWithItsDepthAndNotTakenForAWayThatPasses() {
        assertThat(WayDanger.of(at(0, 0), List.of(at(52, 0), at(0, 0)), CALM))
                .extracting(WayDanger::words)
                .singleElement()
                .asString()
                .matches("is sent to 45\\.\\d{5},10\\.\\d{5}, which lies 12\\.0 m inside a no-go area; "
                        + "boats may be 0\\.6 m off their path, so up to 12\\.6 m inside");
    }

    @Test
    void boatThatLiesInsideIsSaidToLeave() {
        assertThat(WayDanger.of(at(45, 0), List.of(at(0, 0)), CALM))
                .extracting(WayDanger::words)
                .containsExactly("lies 5.0 m inside a no-go area, and leaves it on the shortest way");
    }

    @Test
    void inTheFieldItIsSaidWhereAWayPassesAndHowFarInsideABoatMayCome() {
        assertThat(WayDanger.of(at(0, 0), List.of(at(120, 0)), FIELD))
                .extracting(WayDanger::words)
                .singleElement()
                .asString()
                .matches("passes a no-go area at 6\\.\\d m near 45\\.\\d{5},10\\.\\d{5}; "
                        + "boats may be 10\\.3 m off their path, so up to 3\\.\\d m inside");
    }

    @Test
    void wayOutFromInsideIsSaidOnceAndWhatFollowsByItself() {
        assertThat(WayDanger.of(at(45, 0), List.of(at(0, 0)), FIELD)).hasSize(1);
        assertThat(WayDanger.of(at(45, 0), List.of(at(0, 0), at(120, 0)), FIELD))
                .hasSize(2);
    }

    @Test
    void depthIsThatOfTheWords() {
        assertThat(insideM(at(0, 0), at(52, 0), CALM)).isEqualTo(12.6);
        assertThat(insideM(at(45, 0), at(0, 0), CALM)).isEqualTo(5);
        assertThat(insideM(at(0, 0), at(120, 0), FIELD)).isEqualTo(3.9);
    }

    private static double insideM(GeoPoint from, GeoPoint to, Water water) {
        WayDanger danger = WayDanger.of(from, List.of(to), water).get(0);
        assertThat(danger.words()).contains(danger.insideM() + " m inside");
        return danger.insideM();
    }
}
