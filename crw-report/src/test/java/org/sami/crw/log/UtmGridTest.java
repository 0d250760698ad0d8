package org.sami.crw.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import net.sf.geographiclib.Geodesic;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.value.GeoPoint;

class UtmGridTest {
    private static final double CENTIMETRE_DEG = 1e-7;

    private final UtmGrid grid = new UtmGrid();

    @ParameterizedTest
    @CsvSource({
        "17North, -81",
        "17T, -81",
        "1North, -177",
        "60North, 177",
        "31North, 3",
    })
    void centralMeridianIsAtHalfAMillionMetres(String zone, double meridianDeg) throws Exception {
        double northingM = 4_482_781.5;

        GeoPoint point = grid.point(zone, 500_000, northingM);

        double alongMeridianM = Geodesic.WGS84.Inverse(0, 0, point.latDeg(), 0).s12;
        assertThat(point.lonDeg()).isCloseTo(meridianDeg, within(CENTIMETRE_DEG));
        assertThat(alongMeridianM * 0.9996).as("metres of the grid").isCloseTo(northingM, within(0.01));
    }

    @ParameterizedTest
    @CsvSource({"17South, -81", "17F, -81"})
    void southernZonesCountFromTenMillionMetres(String zone, double meridianDeg) throws Exception {
        GeoPoint point = grid.point(zone, 500_000, 10_000_000 - 4_482_781.5);
        GeoPoint mirrored = grid.point("17North", 500_000, 4_482_781.5);

        assertThat(point.latDeg()).isCloseTo(-mirrored.latDeg(), within(CENTIMETRE_DEG));
        assertThat(point.lonDeg()).isCloseTo(meridianDeg, within(CENTIMETRE_DEG));
    }

    @Test
    void pointBesideTheMeridianIsWhereItIsKnownToBe() throws Exception {
        // The CN Tower in Toronto: 43 38 33.24 N, 79 23 13.7 W is 17T 630084 4833438.
        GeoPoint tower = grid.point("17T", 630_084, 4_833_438);

        assertThat(tower.latDeg()).isCloseTo(43 + 38 / 60.0 + 33.24 / 3600, within(1e-5));
        assertThat(tower.lonDeg()).isCloseTo(-(79 + 23 / 60.0 + 13.7 / 3600), within(1e-5));
    }

    @ParameterizedTest
    @CsvSource({
        "17North, 99999, 4000000", "17North, 900001, 4000000", "17North, 500000, -1", "17North, 500000, 10000001",
        "17North, NaN, 4000000", "0North, 500000, 4000000", "61North, 500000, 4000000", "17I, 500000, 4000000",
        "North, 500000, 4000000",
    })
    void whatIsNotOnTheGridIsRefused(String zone, double eastingM, double northingM) {
        assertThatThrownBy(() -> grid.point(zone, eastingM, northingM))
                .isInstanceOf(BadLineException.class)
                .hasMessageContaining("UTM grid");
    }
}
