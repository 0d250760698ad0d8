package org.sami.crw.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.value.GeoPoint;

class GeodesyTest {
    @ParameterizedTest
    @CsvSource({
        // one degree along the meridian at the equator and at 45 degrees, along the equator, and over the antimeridian
        "0,0,1,0,110574.39",
        "44.5,10,45.5,10,111131.75",
        "0,0,0,1,111319.49",
        "0,179.5,0,-179.5,111319.49",
        "45,10,45,10,0",
    })
    void measuresOnTheEllipsoid(double lat1, double lon1, double lat2, double lon2, double metres) {
        assertThat(Geodesy.distanceM(GeoPoint.of(lat1, lon1), GeoPoint.of(lat2, lon2)))
                .isCloseTo(metres, within(0.05));
    }

    @ParameterizedTest
    @CsvSource({"100,0", "0,100", "-30,40", "0,0", "250,-250"})
    void anOffsetLiesAtItsDistanceAndInItsDirection(double eastM, double northM) {
        GeoPoint origin = GeoPoint.of(45.6, 10.68);

        GeoPoint point = Geodesy.offset(origin, eastM, northM);

        assertThat(Geodesy.distanceM(origin, point)).isCloseTo(Math.hypot(eastM, northM), within(1e-6));
        assertThat(new LocalPlane(origin).x(point)).isCloseTo(eastM, within(0.02));
        assertThat(new LocalPlane(origin).y(point)).isCloseTo(northM, within(0.02));
    }

    @ParameterizedTest
    @CsvSource({"0", "25.3", "-33", "45.6", "60"})
    void thePlaneAgreesWithTheEllipsoidOverAnOperatingArea(double latDeg) {
        GeoPoint origin = GeoPoint.of(latDeg, 179.99);
        LocalPlane plane = new LocalPlane(origin);
        for (int degrees = 0; degrees < 360; degrees += 15) {
            double angle = Math.toRadians(degrees);
            GeoPoint a = Geodesy.offset(origin, 2000 * Math.cos(angle), 2000 * Math.sin(angle));
            GeoPoint b = Geodesy.offset(origin, -1500 * Math.sin(angle), 900 * Math.cos(angle));

            double onPlane = Math.hypot(plane.x(a) - plane.x(b), plane.y(a) - plane.y(b));

            assertThat(onPlane).isCloseTo(Geodesy.distanceM(a, b), within(1.5));
        }
    }

    @Test
    void aLengthIsTheSumOfItsLegs() {
        GeoPoint start = GeoPoint.of(45.6, 10.68);
        GeoPoint a = Geodesy.offset(start, 100, 0);
        GeoPoint b = Geodesy.offset(a, 0, 50);

        assertThat(Geodesy.lengthM(start, List.of(a, b))).isCloseTo(150, within(1e-6));
        assertThat(Geodesy.lengthM(start, List.of())).isZero();
    }

    @ParameterizedTest
    @CsvSource({"5,3,0,GREATER", "3,5,0,LESS", "3,3,0,EQUAL", "3.0005,3,0.001,EQUAL", "3.002,3,0.001,GREATER"})
    void quantitiesWithinTheToleranceAreEqual(
            double first, double second, double tolerance, QuantityComparison result) {
        assertThat(QuantityComparison.of(first, second, tolerance)).isEqualTo(result);
    }
}
