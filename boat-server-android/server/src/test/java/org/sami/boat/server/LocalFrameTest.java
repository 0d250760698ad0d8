package org.sami.boat.server;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import net.sf.geographiclib.Geodesic;
import net.sf.geographiclib.GeodesicData;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.boat.server.vehicle.LocalFrame;

class LocalFrameTest {

    @ParameterizedTest
    @CsvSource({"0, 0", "45.4, 10.9", "-33.9, 151.2", "60.2, 24.9", "70, -150", "40.44, 180", "-10, -179.999"})
    void agreesWithTheGeodesicToMillimetresWithinTwoKilometres(double latDeg, double lonDeg) {
        LocalFrame frame = new LocalFrame(latDeg, lonDeg);
        for (double azimuthDeg = 0; azimuthDeg < 360; azimuthDeg += 15) {
            for (double distanceM : new double[] {1, 100, 600, 2000}) {
                GeodesicData there = Geodesic.WGS84.Direct(latDeg, lonDeg, azimuthDeg, distanceM);
                double eastM = distanceM * Math.sin(Math.toRadians(azimuthDeg));
                double northM = distanceM * Math.cos(Math.toRadians(azimuthDeg));

                assertThat(frame.eastM(there.lat2, there.lon2)).isCloseTo(eastM, within(0.005));
                assertThat(frame.northM(there.lat2, there.lon2)).isCloseTo(northM, within(0.005));
                assertThat(frame.distanceM(there.lat2, there.lon2)).isCloseTo(distanceM, within(0.005));
            }
        }
    }

    @Test
    void distancesBetweenAnyTwoPlacesAreTrueToCentimetres() {
        SplittableRandom random = new SplittableRandom(5);
        LocalFrame frame = new LocalFrame(45.4, 10.9);
        for (int i = 0; i < 500; i++) {
            double[] at = random.doubles(4, -1400, 1400).toArray();
            double planeM = Math.hypot(at[2] - at[0], at[3] - at[1]);
            double trueM = Geodesic.WGS84.Inverse(
                            frame.latDeg(at[0], at[1]),
                            frame.lonDeg(at[0], at[1]),
                            frame.latDeg(at[2], at[3]),
                            frame.lonDeg(at[2], at[3]))
                    .s12;

            assertThat(planeM).isCloseTo(trueM, within(0.01));
        }
    }

    @ParameterizedTest
    @CsvSource({"0, 0", "45.4, 10.9", "-33.9, 151.2", "70, 180", "-70, -180"})
    void leadsThereAndBack(double latDeg, double lonDeg) {
        SplittableRandom random = new SplittableRandom(6);
        LocalFrame frame = new LocalFrame(latDeg, lonDeg);
        for (int i = 0; i < 500; i++) {
            double eastM = random.nextDouble(-2000, 2000);
            double northM = random.nextDouble(-2000, 2000);
            double lat = frame.latDeg(eastM, northM);
            double lon = frame.lonDeg(eastM, northM);

            assertThat(lon).isBetween(-180.0, 180.0);
            assertThat(frame.eastM(lat, lon)).isCloseTo(eastM, within(1e-6));
            assertThat(frame.northM(lat, lon)).isCloseTo(northM, within(1e-6));
        }
    }

    @Test
    void refusesThePolesAndNonsense() {
        assertThatThrownBy(() -> new LocalFrame(89, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new LocalFrame(Double.NaN, 0)).isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> new LocalFrame(0, 181)).isInstanceOf(IllegalArgumentException.class);
    }
}
