package org.sami.crw.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How deep a track goes into a square of 20 m around the origin that is avoided. */
class NoGoDepthTest {
    @ParameterizedTest
    @CsvSource({"0, 10", "9, 1", "-7.5, 2.5", "10.5, 0", "-40, 0"})
    void depthIsThatFromTheEdge(double northM, double deepM) {
        assertThat(NoGoDepth.of(report(northM, MapArea.Kind.AVOIDED)).orElseThrow())
                .isEqualTo(deepM, within(0.15));
    }

    @Test
    void areasOfOtherKindsDoNotCount() {
        assertThat(NoGoDepth.of(report(0, MapArea.Kind.EXPLORED))).isEmpty();
    }

    @Test
    void whatTheOperatorWasToldIsAnnouncedWhereSomethingIsAvoided() {
        OptionalDouble told = OptionalDouble.of(3.5);
        OptionalDouble nothing = OptionalDouble.empty();

        assertThat(NoGoDepth.announced(report(9, MapArea.Kind.AVOIDED, told))).isEqualTo(told);
        assertThat(NoGoDepth.announced(report(9, MapArea.Kind.AVOIDED, nothing)))
                .hasValue(0);
        assertThat(NoGoDepth.announced(report(9, MapArea.Kind.EXPLORED, told))).isEmpty();
    }

    private static RunReport report(double northM, MapArea.Kind kind) {
        return report(northM, kind, OptionalDouble.empty());
    }

    private static RunReport report(double northM, MapArea.Kind kind, OptionalDouble announcedM) {
        RunReport sample = SampleReport.of(1, 1);
        List<TrackPoint> track = List.of(at(0, -50, northM), at(60_000, 50, northM));
        BoatResult boat = new BoatResult("boat1", sample.boats().get(0).link(), 100, 90, 0, 0, track);
        MapArea area =
                new MapArea(kind, List.of(point(-10, -10), point(10, -10), point(10, 10), point(-10, 10)), List.of());
        ClosestApproach closest = new ClosestApproach(Optional.empty(), Optional.empty(), List.of(), 0);
        RunMap map = new RunMap(List.of(area), List.of(), List.of(), closest).announcing(announcedM);
        return new RunReport(
                sample.header(),
                sample.result(),
                List.of(boat),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                List.of(),
                map);
    }

    private static MapPoint point(double eastM, double northM) {
        return new MapPoint(45 + northM / 111_000, 10 + eastM / 78_000, eastM, northM);
    }

    private static TrackPoint at(long atMillis, double eastM, double northM) {
        MapPoint point = point(eastM, northM);
        return new TrackPoint(atMillis, eastM, northM, point.latDeg(), point.lonDeg(), 1.5, 90);
    }
}
