package org.sami.crw.service.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;

class TourDivisionTest {
    /** Ten lanes of 100 m, 10 m apart, from the west end of the lowest: 1,090 m. */
    private static final TourPlaces TOUR = new TourPlaces(lanes());

    @Test
    void chargesThatLastGiveEqualPieces() {
        TourDivision.Cuts cuts = cuts(new double[] {9e9, 2000, 2000}, false, 0, 0, 0, 0, 0, 0);

        assertThat(IntStream.range(0, 3).mapToDouble(cuts::lengthM).toArray())
                .containsExactly(new double[] {1090 / 3.0, 1090 / 3.0, 1090 / 3.0}, within(0.2));
        assertThat(cuts.beyondM()).isZero();
    }

    @Test
    void boatsOfDifferentSpeedsTakeEquallyLongForTheirPieces() {
        TourDivision.Cuts cuts =
                cuts(new double[] {9e9, 2000, 2000}, new double[] {0.5, 1, 0.25}, false, 0, 0, 0, 0, 0, 0);

        assertThat(cuts.lengthM(pieceOf(0, cuts))).isCloseTo(1090 * 2 / 7.0, within(0.5));
        assertThat(cuts.lengthM(pieceOf(1, cuts))).isCloseTo(1090 * 4 / 7.0, within(0.5));
        assertThat(cuts.lengthM(pieceOf(2, cuts))).isCloseTo(1090 / 7.0, within(0.5));
        assertThat(cuts.endM()).isCloseTo(1090, within(0.1));
    }

    /** Of 18 right angles of the tour each costs 0.57 m for each metre of radius. */
    @Test
    void boatWithATurningCircleHasTheShorterPieceAndBothTakeEquallyLong() {
        double radiusM = 10;
        TourDivision.Cuts cuts =
                cuts(new double[] {9e9, 9e9}, new double[] {1, 1}, new double[] {radiusM, 0}, false, 0, 0, 0, 0);

        int wide = pieceOf(0, cuts);
        double turnsM = radiusM * TOUR.turns(cuts.fromM(wide), cuts.fromM(wide + 1));
        assertThat(turnsM).isBetween(30.0, 60.0);
        assertThat(cuts.lengthM(wide) + turnsM).isCloseTo(cuts.lengthM(1 - wide), within(0.5));
        assertThat(cuts.endM()).isCloseTo(1090, within(0.1));
    }

    @Test
    void turnsOfATourAreThoseBetweenTwoPlaces() {
        double rightAngle = Math.PI / 2 - 1;

        assertThat(TOUR.turns(0, 1090)).isCloseTo(18 * rightAngle, within(1e-9));
        assertThat(TOUR.turns(0, 100)).isZero();
        assertThat(TOUR.turns(0, 100.1)).isCloseTo(rightAngle, within(1e-9));
        assertThat(TOUR.turns(100, 110)).isZero();
        assertThat(TOUR.turns(50, 220.5)).isCloseTo(4 * rightAngle, within(1e-9));
    }

    @Test
    void aSlowWeakBoatHasWhatItsChargeLastsFor() {
        TourDivision.Cuts cuts =
                cuts(new double[] {100, 2000, 2000}, new double[] {0.5, 1, 1}, false, 0, 0, 0, 0, 0, 0);

        assertThat(cuts.lengthM(pieceOf(0, cuts))).isLessThanOrEqualTo(100.001);
        assertThat(cuts.endM()).isCloseTo(1090, within(0.1));
    }

    @Test
    void aWeakBoatHasWhatItsChargeLastsForAndTheOthersHaveTheRestEvenly() {
        TourDivision.Cuts cuts = cuts(new double[] {150, 2000, 2000}, false, -50, 0, -50, 0, -50, 0);

        int piece = pieceOf(0, cuts);
        assertThat(wayM(piece, cuts, new Coordinate(-50, 0)) + cuts.lengthM(piece))
                .isBetween(149.0, 150.001);
        assertThat(cuts.endM()).isCloseTo(1090, within(0.1));
        assertThat(cuts.lengthM(pieceOf(1, cuts))).isCloseTo(cuts.lengthM(pieceOf(2, cuts)), within(1.0));
    }

    @Test
    void whatChargesDoNotLastForIsLeftUnlessBatteriesAreSwapped() {
        double[] ranges = {300, 400};

        TourDivision.Cuts without = cuts(ranges, false, 0, 0, 0, 0);
        TourDivision.Cuts swapped = cuts(ranges, true, 0, 0, 0, 0);

        assertThat(without.beyondM()).isZero();
        assertThat(without.endM()).isBetween(1090 - 600.0, 1090 - 389.9);
        assertThat(swapped.endM()).isCloseTo(1090, within(0.1));
        assertThat(swapped.beyondM()).isBetween(194.9, 300.0);
    }

    /** Whatever the charges are: nobody has more than its own lasts for, and as much is driven as any order allows, or nearly. */
    @Test
    void noBoatHasMoreThanItsChargeLastsFor() {
        Random random = new Random(11);
        for (int seed = 0; seed < 100; seed++) {
            int boats = 2 + random.nextInt(4);
            double[] ranges = random.doubles(boats, 50, 900).toArray();
            double[] at = random.doubles(2L * boats, -100, 200).toArray();

            TourDivision.Cuts cuts = cuts(ranges, false, at);

            for (int piece = 0; piece < boats; piece++) {
                int boat = cuts.boat(piece);
                double drivenM =
                        wayM(piece, cuts, new Coordinate(at[2 * boat], at[2 * boat + 1])) + cuts.lengthM(piece);
                if (cuts.lengthM(piece) > 1) {
                    assertThat(drivenM).as("seed %s", seed).isLessThanOrEqualTo(ranges[boat] + 1);
                }
            }
        }
    }

    private static double wayM(int piece, TourDivision.Cuts cuts, Coordinate boat) {
        return Math.min(boat.distance(TOUR.at(cuts.fromM(piece))), boat.distance(TOUR.at(cuts.fromM(piece + 1))));
    }

    private static int pieceOf(int boat, TourDivision.Cuts cuts) {
        return IntStream.range(0, 3)
                .filter(piece -> cuts.boat(piece) == boat)
                .findFirst()
                .orElseThrow();
    }

    private static TourDivision.Cuts cuts(double[] ranges, boolean swapped, double... at) {
        return cuts(
                ranges, IntStream.range(0, ranges.length).mapToDouble(boat -> 1).toArray(), swapped, at);
    }

    private static TourDivision.Cuts cuts(double[] ranges, double[] paces, boolean swapped, double... at) {
        return cuts(ranges, paces, new double[ranges.length], swapped, at);
    }

    private static TourDivision.Cuts cuts(
            double[] ranges, double[] paces, double[] radiiM, boolean swapped, double... at) {
        return new TourDivision(TOUR, ranges, paces, radiiM, swapped, (boat, end, other) -> {
                    Coordinate place = new Coordinate(at[2 * boat], at[2 * boat + 1]);
                    return Math.min(place.distance(end), place.distance(other));
                })
                .from(IntStream.range(0, ranges.length).toArray());
    }

    private static List<Coordinate> lanes() {
        List<Coordinate> lanes = new ArrayList<>();
        for (int lane = 0; lane < 10; lane++) {
            lanes.add(new Coordinate(lane % 2 == 0 ? 0 : 100, 10 * lane));
            lanes.add(new Coordinate(lane % 2 == 0 ? 100 : 0, 10 * lane));
        }
        return lanes;
    }
}
