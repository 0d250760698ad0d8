package org.sami.crw.service.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.locationtech.jts.geom.Coordinate;

class MeanAxisTest {
    private static final double LANE_M = 100;
    private static final double SPACING_M = 10;

    /** As the lanes of a square area, of which no side is the longer one. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 30, 89, -45, -89})
    void lanesToAndFroWithWaysAcrossToTheNextLeadAlongTheLanes(double degrees) {
        List<Coordinate> track = toAndFro(Math.toRadians(degrees), 0);

        assertThat(Math.toDegrees(MeanAxis.ofRad(List.of(track)))).isCloseTo(degrees, within(1e-6));
    }

    @Test
    void positionsThatErrTurnItLittle() {
        List<Coordinate> track = toAndFro(Math.toRadians(60), 1.4);

        assertThat(Math.toDegrees(MeanAxis.ofRad(List.of(track)))).isCloseTo(60, within(2.0));
    }

    @Test
    void aLongTrackCountsForMoreThanAShortOne() {
        List<List<Coordinate>> tracks = List.of(
                List.of(new Coordinate(0, 0), new Coordinate(50, 0)),
                List.of(new Coordinate(0, 0), new Coordinate(0, -60)));

        assertThat(Math.abs(MeanAxis.ofRad(tracks))).isCloseTo(Math.PI / 2, within(1e-9));
    }

    @Test
    void tracksThatStandStillHaveADirectionTooSoThatTheyAreMeasured() {
        assertThat(MeanAxis.ofRad(List.of(List.of(new Coordinate(3, 4), new Coordinate(3, 4)))))
                .isZero();
    }

    private static List<Coordinate> toAndFro(double directionRad, double errorM) {
        Random random = new Random(3);
        List<Coordinate> track = new ArrayList<>();
        for (int lane = 0; lane < 10; lane++) {
            for (int step = 0; step <= 10; step++) {
                double along = LANE_M / 10 * (lane % 2 == 0 ? step : 10 - step) + errorM * random.nextGaussian();
                double across = SPACING_M * lane + errorM * random.nextGaussian();
                track.add(new Coordinate(
                        along * Math.cos(directionRad) - across * Math.sin(directionRad),
                        along * Math.sin(directionRad) + across * Math.cos(directionRad)));
            }
        }
        return track;
    }
}
