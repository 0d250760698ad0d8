package org.sami.ui.geo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPoint;

class MapFrameTest {
    private static final GeoPoint LAKE = GeoPoint.of(45.70, 10.72);
    private static final MapFrame FRAME =
            new MapFrame(Mercator.x(LAKE.lonDeg()), Mercator.y(LAKE.latDeg()), 256 * Math.pow(2, 18), 800, 600);

    @Test
    void findsThePointOfAPixelAndBack() {
        GeoPoint point = FRAME.point(120, 540);

        assertThat(FRAME.px(point)).isCloseTo(120, within(1e-3));
        assertThat(FRAME.py(point)).isCloseTo(540, within(1e-3));
        assertThat(point.latDeg()).isLessThan(LAKE.latDeg());
        assertThat(point.lonDeg()).isLessThan(LAKE.lonDeg());
    }

    @Test
    void measuresPixelsInMetres() {
        double metres = GeoMeasure.metres(FRAME.point(300, 300), FRAME.point(500, 300));

        assertThat(200 * FRAME.metresPerPixel()).isCloseTo(metres, within(metres / 200)); // sphere against ellipsoid
    }

    @Test
    void snapsToACornerBeforeALine() {
        Snapping snapping = new Snapping();
        GeoPoint a = FRAME.point(100, 100);
        GeoPoint b = FRAME.point(300, 100);
        snapping.addLine(List.of(a, b));

        assertThat(snapping.at(FRAME, 106, 104)).contains(a);
        assertThat(snapping.at(FRAME, 200, 106))
                .hasValueSatisfying(
                        foot -> assertThat(FRAME.distancePx(foot, 200, 100)).isLessThan(0.01));
        assertThat(snapping.at(FRAME, 200, 120)).isEmpty();
    }

    @Test
    void measuresAnArea() {
        List<GeoPoint> square =
                List.of(GeoPoint.of(0, 0), GeoPoint.of(0, 0.001), GeoPoint.of(0.001, 0.001), GeoPoint.of(0.001, 0));

        assertThat(GeoMeasure.squareMetres(square)).isCloseTo(111.32 * 110.57, within(10.0));
        assertThat(GeoMeasure.area(12_345)).isEqualTo("1.23 ha");
        assertThat(GeoMeasure.length(1234)).isEqualTo("1.23 km");
    }
}
