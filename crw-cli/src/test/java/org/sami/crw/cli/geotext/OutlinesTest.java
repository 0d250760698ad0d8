package org.sami.crw.cli.geotext;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

class OutlinesTest {
    @Test
    void areasAreMeasuredInSquareMetres() {
        GeoPoint corner = GeoPoint.of(45, 10);
        GeoPoint east = Geodesy.offset(corner, 100, 0);
        GeoPoint north = Geodesy.offset(corner, 0, 50);
        GeoPoint far = GeoPoint.of(north.latDeg(), east.lonDeg());

        assertThat(Outlines.squareMetres(new GeoArea(List.of(corner, east, far, north), List.of())))
                .isCloseTo(5000, within(1.0));
    }
}
