package org.sami.crw.service.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoPoint;

class SampledFieldTest {
    private static final GeoPoint ORIGIN = GeoPoint.of(45.6, 10.68);

    private final LocalPlane plane = new LocalPlane(ORIGIN);
    private final SampledField field = new SampledField(plane);

    /** A value that grows by one each metre to the east. */
    private void sampleSlope(int metres) {
        for (int east = 0; east < metres; east++) {
            for (int north = 0; north < metres; north++) {
                field.add(plane.point(east + 0.5, north + 0.5), east);
            }
        }
    }

    @Test
    void cellsHaveTheMeanOfTheirSamples() {
        field.add(plane.point(0.2, 0.2), 1);
        field.add(plane.point(0.7, 0.7), 3);

        FieldGrid grid = field.grid().orElseThrow();

        assertThat(grid.columns()).isEqualTo(1);
        assertThat(grid.value(0, 0)).hasValue(2);
        assertThat(Geodesy.distanceM(grid.centre(0, 0), plane.point(0.5, 0.5))).isLessThan(0.01);
    }

    @Test
    void gapsAreFilledFromNearByAndLeftOpenFarAway() {
        field.add(plane.point(0.5, 0.5), 10);
        field.add(plane.point(4.5, 0.5), 20);
        field.add(plane.point(30.5, 0.5), 30);

        FieldGrid grid = field.grid().orElseThrow();

        assertThat(grid.value(2, 0)).hasValue(15);
        assertThat(grid.value(1, 0).orElseThrow()).isCloseTo(11, within(0.01)); // weights 1 and 1/9
        assertThat(grid.value(15, 0)).isEmpty();
        assertThat(grid.least()).isEqualTo(10);
        assertThat(grid.greatest()).isEqualTo(30);
    }

    @Test
    void anHourOfReadingsKeepsTheGridSmallAndItsMeanRight() {
        SplittableRandom random = new SplittableRandom(3);
        for (int i = 0; i < 50_000; i++) {
            double east = random.nextDouble(1000);
            field.add(plane.point(east, random.nextDouble(1000)), east);
        }

        FieldGrid grid = field.grid().orElseThrow();

        assertThat(grid.columns()).isBetween(30, 100);
        assertThat(grid.rows()).isBetween(30, 100);
        assertThat(grid.value(0, 10).orElseThrow()).isCloseTo(grid.cellM() / 2, within(grid.cellM() / 4));
    }

    @Test
    void readingsOfABoatThatDoesNotKnowWhereItIsAreLeftOut() {
        field.add(ORIGIN, 1);
        field.add(GeoPoint.of(0, 0), 5);
        field.add(ORIGIN, Double.NaN);

        assertThat(field.grid().orElseThrow().greatest()).isEqualTo(1);
    }

    @Test
    void fieldsOfTwoBoatsAreJoinedWhateverTheirCells() {
        sampleSlope(70); // more cells than fit: they are two metres wide now
        SampledField other = new SampledField(plane);
        other.add(plane.point(100.5, 0.5), 500);

        FieldGrid grid = field.and(other).grid().orElseThrow();

        assertThat(grid.cellM()).isEqualTo(2);
        assertThat(grid.greatest()).isEqualTo(500);
        assertThat(grid.value(0, 0)).hasValue(0.5);
    }

    @Test
    void aContourOfASlopeIsAStraightLineAcrossIt() {
        sampleSlope(20);

        ContourLine line = ContourLine.of(field.grid().orElseThrow(), 7.25);

        assertThat(line.segments()).hasSize(19);
        assertThat(line.segments())
                .allSatisfy(piece -> List.of(piece.from(), piece.to())
                        .forEach(point -> assertThat(plane.x(point)).isCloseTo(7.75, within(0.01))));
    }

    @Test
    void aContourStopsWhereNothingIsKnown() {
        field.add(plane.point(0.5, 0.5), 0);
        field.add(plane.point(1.5, 1.5), 10);
        field.add(plane.point(40.5, 0.5), 20);

        assertThat(ContourLine.of(field.grid().orElseThrow(), 15).segments()).isEmpty();
    }

    @Test
    void legendMarksRoundValues() {
        sampleSlope(20);

        Legend legend = Legend.of(field.grid().orElseThrow(), "m");

        assertThat(legend.least()).isZero();
        assertThat(legend.greatest()).isEqualTo(19);
        assertThat(legend.marks()).containsExactly(0.0, 5.0, 10.0, 15.0);
    }
}
