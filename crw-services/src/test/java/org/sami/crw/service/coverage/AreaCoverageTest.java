package org.sami.crw.service.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.sami.crw.service.coverage.PlainGeometry.at;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

class AreaCoverageTest {
    private static final double SPACING_M = 10;

    @Test
    void oneTrackAlongTheMiddleCoversAStripOfTheSpacing() {
        AreaCoverage.Left left = open(box(0, 0, 100, 40)).left(List.of(List.of(at(-60, 0), at(60, 0))));

        assertThat(left.areaM2()).isCloseTo(100 * 30, within(1.0));
        assertThat(left.parts()).hasSize(2);
        assertThat(left.inLargest())
                .hasValueSatisfying(
                        place -> assertThat(Geodesy.distanceM(place, at(0, 0))).isGreaterThan(5));
    }

    @Test
    void aBoatThatHasNotMovedCoversNothing() {
        AreaCoverage area = open(box(0, 0, 100, 40));

        assertThat(area.left(List.of(List.of(), List.of(at(0, 0)))).areaM2()).isEqualTo(area.areaM2());
        assertThat(area.left(List.of()).inLargest()).isPresent();
    }

    @Test
    void whatMayNotBeEnteredIsNotToBeCovered() {
        AreaCoverage area = AreaCoverage.of(
                box(0, 0, 100, 40), SPACING_M, List.of(box(0, 0, 20, 20)), Optional.of(box(-25, 0, 50, 100)));

        assertThat(area.areaM2()).isCloseTo(50 * 40 - 10 * 20, within(1.0));
    }

    @Test
    void areaThatCrossesItselfIsRefused() {
        GeoArea crossed = new GeoArea(List.of(at(0, 0), at(10, 10), at(10, 0), at(0, 10)), List.of());

        assertThatThrownBy(() -> open(crossed))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("crosses");
    }

    /** Tracks that wander, as boats' positions do: compared with counting single points. */
    @Test
    void agreesWithCountingPoints() {
        Random random = new Random(5);
        GeoArea box = box(0, 0, 120, 90);
        List<List<GeoPoint>> tracks = new ArrayList<>();
        List<double[]> places = new ArrayList<>();
        double driftM = 0;
        for (int lane = 0; lane < 9; lane++) {
            List<GeoPoint> track = new ArrayList<>();
            for (double x = -60; x <= 60; x += 1.5) {
                driftM = 0.93 * driftM + 0.8 * random.nextGaussian();
                double y = -40 + 10 * lane + driftM;
                track.add(at(x, y));
                places.add(new double[] {x, y});
            }
            tracks.add(track);
        }

        double leftM2 = open(box).left(tracks).areaM2();

        int points = 0;
        for (double x = -59.75; x < 60; x += 0.5) {
            for (double y = -44.75; y < 45; y += 0.5) {
                points += isNear(x, y, places) ? 0 : 1;
            }
        }
        assertThat(leftM2).isBetween(300.0, 2500.0).isCloseTo(points * 0.25, within(0.05 * leftM2));
    }

    /** As boats that wait for one another in rough water do: measured in one piece, such tracks took gigabytes. */
    @Test
    @Timeout(900)
    void tracksThatStayAtOnePlaceForLongAreMeasuredSoon() {
        Random random = new Random(7);
        List<List<GeoPoint>> tracks = new ArrayList<>();
        for (int boat = 0; boat < 4; boat++) {
            List<GeoPoint> track = new ArrayList<>();
            double x = 0;
            double y = 0;
            for (int i = 0; i < 3000; i++) {
                x = 0.95 * x + 0.8 * random.nextGaussian();
                y = 0.95 * y + 0.8 * random.nextGaussian();
                track.add(at(x, y));
            }
            tracks.add(track);
        }

        double leftM2 = open(box(0, 0, 120, 90)).left(tracks).areaM2();

        double radiusM = Math.sqrt((120 * 90 - leftM2) / Math.PI);
        assertThat(radiusM).isBetween(3 * 2.56 + 3, 5 * 2.56 + 5); // three to five deviations, and half the spacing
    }

    private static boolean isNear(double x, double y, List<double[]> places) {
        return places.stream()
                .anyMatch(place -> Math.hypot(place[0] - x, place[1] - y) <= Math.hypot(SPACING_M / 2, 0.2));
    }

    private static AreaCoverage open(GeoArea area) {
        return AreaCoverage.of(area, SPACING_M, List.of(), Optional.empty());
    }

    private static GeoArea box(double x, double y, double width, double height) {
        return new GeoArea(
                List.of(
                        at(x - width / 2, y - height / 2),
                        at(x + width / 2, y - height / 2),
                        at(x + width / 2, y + height / 2),
                        at(x - width / 2, y + height / 2)),
                List.of());
    }
}
