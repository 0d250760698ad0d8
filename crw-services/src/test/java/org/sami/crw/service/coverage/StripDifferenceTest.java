package org.sami.crw.service.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.operation.overlayng.OverlayNG;
import org.locationtech.jts.operation.overlayng.OverlayNGRobust;

class StripDifferenceTest {
    private static final GeometryFactory FACTORY = new GeometryFactory();
    private static final double SIDE_M = 400;

    @ParameterizedTest
    @CsvSource({"100, 30, 5", "1200, 30, 5", "1200, 5, 30", "2500, 20, 20"})
    void shapesTakenOffStripByStripLeaveTheSamePartsAsTakenOffAtOnce(int count, double widthM, double heightM) {
        Geometry region = box(0, 0, SIDE_M, SIDE_M);
        List<Geometry> shapes = shapes(count, widthM, heightM);
        Geometry atOnce = OverlayNGRobust.overlay(region, OverlayNGRobust.union(shapes), OverlayNG.DIFFERENCE);

        Geometry rest = StripDifference.of(region, shapes);

        assertThat(rest.isValid()).isTrue();
        assertThat(rest.getNumGeometries()).isEqualTo(atOnce.getNumGeometries());
        assertThat(rest.getArea()).isCloseTo(atOnce.getArea(), within(1e-6));
        assertThat(OverlayNGRobust.overlay(rest, atOnce, OverlayNG.SYMDIFFERENCE)
                        .getArea())
                .isCloseTo(0, within(1e-6));
    }

    @ParameterizedTest
    @CsvSource({"40, 1", "1, 40"})
    void aRegionThatShapesCoverLeavesNothing(int columns, int rows) {
        List<Geometry> shapes = new ArrayList<>();
        for (int i = 0; i < 1000; i++) {
            double x = SIDE_M / columns * (i % columns);
            double y = SIDE_M / rows * (i % rows);
            shapes.add(box(x - 1, y - 1, SIDE_M / columns + 2, SIDE_M / rows + 2));
        }

        assertThat(StripDifference.of(box(0, 0, SIDE_M, SIDE_M), shapes).isEmpty())
                .isTrue();
    }

    private static List<Geometry> shapes(int count, double widthM, double heightM) {
        Random random = new Random(7);
        List<Geometry> shapes = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            shapes.add(box(random.nextDouble() * SIDE_M, random.nextDouble() * SIDE_M, widthM, heightM));
        }
        return shapes;
    }

    private static Geometry box(double x, double y, double widthM, double heightM) {
        return FACTORY.toGeometry(new Envelope(x, x + widthM, y, y + heightM));
    }
}
