package org.sami.ui.geo;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.spn.value.GeoPoint;

class CoordinatesTest {
    /** Published: the CN Tower in Toronto, and the sample reference of the military grid near Honolulu. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "17T 630084 4833438 | 43.642567 | -79.387139 | 2",
                "4QFJ1234567890 | 21.4097 | -157.9161 | 50",
            })
    void readsTheGridsOfMetres(String text, double latDeg, double lonDeg, double offM) {
        assertThat(Coordinates.parse(text))
                .hasValueSatisfying(point -> assertThat(GeoMeasure.metres(point, GeoPoint.of(latDeg, lonDeg)))
                        .isLessThan(offM));
    }

    @Test
    void knowsTheWideZonesOfNorway() {
        assertThat(CoordinateNotation.UTM.format(GeoPoint.of(60.39, 5.32))).startsWith("32V ");
        assertThat(CoordinateNotation.MGRS.format(GeoPoint.of(78.22, 15.63))).startsWith("33X ");
    }

    @Test
    void writesDegreesAndMinutesWithoutSixtyMinutes() {
        assertThat(CoordinateNotation.DEGREES_MINUTES.format(GeoPoint.of(-45.7, 10.99999999)))
                .isEqualTo("45° 42.0000' S, 11° 00.0000' E");
    }

    @ParameterizedTest
    @EnumSource(CoordinateNotation.class)
    void readsWhatItWrites(CoordinateNotation notation) {
        Random random = new Random(11);
        for (int i = 0; i < 500; i++) {
            GeoPoint point = GeoPoint.of(random.nextDouble() * 163 - 79.5, random.nextDouble() * 360 - 180);
            String text = notation.format(point);

            assertThat(Coordinates.parse(text))
                    .as(text)
                    .hasValueSatisfying(
                            read -> assertThat(GeoMeasure.metres(point, read)).isLessThan(1.6));
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "45.7, 10.72",
                "45.7 10.72",
                "45.7; 10.72",
                "45°42'N 10°43.2'E",
                "45° 42' 0\" N, 10° 43' 12\" E",
                "45.7 N 10.72 E"
            })
    void readsWhatPeopleType(String text) {
        assertThat(Coordinates.parse(text))
                .hasValueSatisfying(point -> assertThat(GeoMeasure.metres(point, GeoPoint.of(45.7, 10.72)))
                        .isLessThan(0.01));
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "here",
                "91, 0",
                "0, 181",
                "45° 70' N, 10° E",
                "61T 500000 5000000",
                "32T ZZ 1 2",
                "32I PR 33842 62301"
            })
    void refusesWhatNamesNoPoint(String text) {
        assertThat(Coordinates.parse(text)).isEmpty();
    }
}
