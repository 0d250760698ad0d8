package org.sami.crw.service.water;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Where boats may go, far from the area to stay in and around a pole. */
class WaterTest {
    private static final GeoPoint HOME = GeoPoint.of(45.6, 10.68);

    private static GeoArea square(double sideM) {
        double half = sideM / 2;
        return new GeoArea(
                List.of(
                        Geodesy.offset(HOME, -half, -half),
                        Geodesy.offset(HOME, half, -half),
                        Geodesy.offset(HOME, half, half),
                        Geodesy.offset(HOME, -half, half)),
                List.of());
    }

    @ParameterizedTest
    @ValueSource(doubles = {200, 9_000, 11_000, 500_000, 4_000_000})
    void nothingOutsideOfTheAreaToStayInIsAllowedHoweverFarAway(double northM) {
        Water water = Water.of(HOME, List.of(), Optional.of(square(100)));
        GeoPoint far = GeoPoint.of(HOME.latDeg() + northM / 111_000, HOME.lonDeg());

        assertThat(water.clearanceM(far)).isZero();
        assertThat(water.allows(List.of(far))).isFalse();
        assertThat(water.allows(List.of(HOME))).isTrue();
    }

    @ParameterizedTest
    @ValueSource(doubles = {90, -90})
    void areaAroundAPoleIsAnArea(double poleDeg) {
        double latDeg = poleDeg - Math.signum(poleDeg) * 0.01; // 1.1 km
        GeoArea around = new GeoArea(
                List.of(
                        GeoPoint.of(latDeg, 0),
                        GeoPoint.of(latDeg, 90),
                        GeoPoint.of(latDeg, 180),
                        GeoPoint.of(latDeg, -90)),
                List.of());
        Water water = Water.of(around.outline().get(0), List.of(around), Optional.empty());

        assertThat(water.allows(List.of(GeoPoint.of(poleDeg, 0)))).isFalse();
        assertThat(water.allows(List.of(GeoPoint.of(poleDeg - Math.signum(poleDeg) * 0.02, 45))))
                .isTrue();
    }

    @ParameterizedTest
    @ValueSource(doubles = {89.99, 88.5, -89.99})
    void planeNearAPoleKeepsDistancesAndGivesPointsBack(double latDeg) {
        GeoPoint origin = GeoPoint.of(latDeg, 170);
        LocalPlane plane = new LocalPlane(origin);
        GeoPoint other = Geodesy.offset(origin, 700, -400);

        double distanceM = Math.hypot(plane.x(other), plane.y(other));
        GeoPoint back = plane.point(plane.x(other), plane.y(other));

        assertThat(distanceM).isCloseTo(Geodesy.distanceM(origin, other), within(0.5));
        assertThat(Geodesy.distanceM(back, other)).isLessThan(0.01);
    }

    @Test
    void planeElsewhereIsAsItWas() {
        LocalPlane plane = new LocalPlane(HOME);

        assertThat(plane.x(Geodesy.offset(HOME, 700, -400))).isCloseTo(700, within(0.5));
        assertThat(plane.y(Geodesy.offset(HOME, 700, -400))).isCloseTo(-400, within(0.5));
    }
}
