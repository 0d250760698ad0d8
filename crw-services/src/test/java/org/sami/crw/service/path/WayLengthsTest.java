package org.sami.crw.service.path;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Lengths of ways that are measured all at once are those of the ways that boats are sent on one by one. */
class WayLengthsTest {
    @Test
    void areAsLongAsTheWaysThatBoatsDrive() {
        int around = 0;
        for (long seed = 1; seed <= 4; seed++) {
            Water water =
                    Water.of(AreaOfTest.CENTRE, rocks(seed), Optional.empty()).drivenWith(CrossTrackError.CALM);
            List<GeoPoint> points = new AreaOfTest(seed).points(10);

            WayLengths lengths = WayLengths.between(points, water);

            for (GeoPoint from : points) {
                for (GeoPoint to : points.subList(0, points.indexOf(from))) {
                    List<GeoPoint> way =
                            new ArrayList<>(Detour.between(from, to, water).orElseThrow());
                    around += way.isEmpty() ? 0 : 1;
                    way.add(to);
                    assertThat(lengths.lengthM(from, to))
                            .as("seed %s, %s to %s", seed, from, to)
                            .isCloseTo(Geodesy.lengthM(from, way), within(0.5));
                }
            }
        }
        assertThat(around).isGreaterThan(40);
    }

    @Test
    void noWayIsInfinitelyLong() {
        GeoArea lagoon = new GeoArea(
                box(-100, -100, 100, 100).outline(),
                List.of(box(-50, -50, 50, 50).outline()));
        Water water = Water.of(AreaOfTest.CENTRE, List.of(lagoon), Optional.empty());

        WayLengths lengths = WayLengths.between(List.of(at(0, 0), at(20, 0), at(200, 0)), water);

        assertThat(lengths.lengthM(at(0, 0), at(20, 0))).isCloseTo(20, within(0.01));
        assertThat(lengths.lengthM(at(0, 0), at(200, 0))).isInfinite();
    }

    @Test
    void aPointInWhatIsForbiddenIsComeToOnTheShortestWay() {
        Water water = Water.of(AreaOfTest.CENTRE, List.of(box(-50, -50, 50, 50)), Optional.empty());

        WayLengths lengths = WayLengths.between(List.of(at(40, 0), at(150, 0), at(-150, 0)), water);

        assertThat(lengths.lengthM(at(150, 0), at(40, 0))).isCloseTo(110, within(0.5));
        assertThat(lengths.lengthM(at(-150, 0), at(40, 0))).isGreaterThan(220);
    }

    @Test
    void aGapIsTakenWhereKeepingTheMarginCostsTooMuch() {
        Water water = Water.of(AreaOfTest.CENTRE, List.of(box(-5, -900, 5, -4), box(-5, 4, 5, 900)), Optional.empty())
                .drivenWith(CrossTrackError.of(2, 0));

        WayLengths lengths = WayLengths.between(List.of(at(-100, 0), at(100, 0)), water);

        assertThat(lengths.lengthM(at(-100, 0), at(100, 0))).isCloseTo(200, within(1.0));
    }

    @Test
    void tooManyPointsAreMeasuredStraightAndThatIsSaid() {
        Water water = Water.of(AreaOfTest.CENTRE, List.of(box(-50, -50, 50, 50)), Optional.empty());
        List<GeoPoint> points = new AreaOfTest(1).points(WayLengths.MOST_POINTS + 1);

        WayLengths lengths = WayLengths.between(points, water);

        assertThat(lengths.lengthM(points.get(0), points.get(1)))
                .isEqualTo(Geodesy.distanceM(points.get(0), points.get(1)));
        assertThat(lengths.shortfall())
                .hasValueSatisfying(words ->
                        assertThat(words).contains("distances are straight").contains("251"));
    }

    private static List<GeoArea> rocks(long seed) {
        Random random = new Random(seed);
        List<GeoArea> rocks = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            double west = random.nextDouble() * 570 - 300;
            double south = random.nextDouble() * 570 - 300;
            rocks.add(box(west, south, west + 30, south + 30));
        }
        for (int i = 0; i < 3; i++) {
            double west = random.nextDouble() * 400 - 300;
            double south = random.nextDouble() * 600 - 300;
            rocks.add(box(west, south, west + 200, south + 8));
        }
        return rocks;
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(east, south), at(east, north), at(west, north)), List.of());
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(AreaOfTest.CENTRE, eastM, northM);
    }
}
