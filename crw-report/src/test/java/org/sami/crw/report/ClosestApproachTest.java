package org.sami.crw.report;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;

class ClosestApproachTest {
    private static final LinkResult LINK = new LinkResult("in-process", "b", 0, 0, LinkResult.Uploads.NONE, "");

    @Test
    void boatsThatCrossAreNearestBetweenTheirPoints() {
        BoatResult north = boat("north", at(0, 0, -100), at(100_000, 0, 100));
        BoatResult east = boat("east", at(0, -97, 0), at(100_000, 103, 0));

        Approach nearest = ClosestApproach.of(List.of(north, east)).ever().orElseThrow();

        // (2t - 100, 0) and (0, 2t - 97): least where both are as far from the crossing
        assertThat(nearest.boat()).isEqualTo("north");
        assertThat(nearest.other()).isEqualTo("east");
        assertThat(nearest.atMillis()).isEqualTo(49_250);
        assertThat(nearest.distanceM()).isCloseTo(3 / Math.sqrt(2), within(1e-9));
        assertThat(nearest.where().eastM()).isCloseTo(0.75, within(1e-6));
        assertThat(nearest.where().northM()).isCloseTo(-0.75, within(1e-6));
        assertThat(nearest.where().latDeg()).isCloseTo(45 - 0.75e-5, within(1e-9));
    }

    /** 2.83 m/s by one another at 2.12 m: 4.24 m of the way of 200 m are within 3 m. */
    @Test
    void howLongPairsAreNearIsThatBetweenTheirPointsToo() {
        BoatResult north = boat("north", at(0, 0, -100), at(100_000, 0, 100));
        BoatResult east = boat("east", at(0, -97, 0), at(100_000, 103, 0));
        BoatResult beside = boat("beside", at(0, 1, -100), at(50_000, 1, 0), at(100_000, 200, 0));

        assertThat(ClosestApproach.of(List.of(north, east)).nearMillis()).isEqualTo(1500);
        assertThat(ClosestApproach.of(List.of(north, beside)).nearMillis()).isBetween(50_000L, 51_000L);
        assertThat(ClosestApproach.of(List.of(north, boat("far", at(0, 9, 0), at(100_000, 9, 0))))
                        .nearMillis())
                .isZero();
    }

    @Test
    void everyPairThatComesNearIsNamedWhereItWasNearest() {
        BoatResult west = boat("west", at(0, 0, 0), at(10_000, 0, 100));
        BoatResult middle = boat("middle", at(0, 20, 0), at(10_000, 2.5, 100));
        BoatResult east = boat("east", at(0, 40, 0), at(10_000, 3.5, 100));
        BoatResult far = boat("far", at(0, 9, 0), at(10_000, 9, 100));

        ClosestApproach closest = ClosestApproach.of(List.of(west, middle, east, far));

        assertThat(closest.near())
                .extracting(near -> near.boat() + " " + near.other() + " " + near.atMillis())
                .containsExactly("middle far 6286", "east far 8493", "middle east 10000", "west middle 10000");
        assertThat(closest.near().get(0)).isEqualTo(closest.ever().orElseThrow());
        assertThat(closest.near()).allMatch(near -> near.distanceM() < 3);
    }

    @Test
    void heightsCountBetweenCoptersAndOverBoats() {
        BoatResult boat = boat("boat", at(0, 0, -100), at(100_000, 0, 100));
        BoatResult over = boat("over", flown(0, -97, 40), flown(100_000, 103, 40));
        BoatResult landing = boat("landing", flown(0, 6, 40), flown(10_000, 6, 0), flown(100_000, 6, 0));

        assertThat(ClosestApproach.of(List.of(boat, over)).ever().orElseThrow().distanceM())
                .isCloseTo(Math.hypot(40, 3 / Math.sqrt(2)), within(1e-9));
        assertThat(ClosestApproach.of(List.of(boat, over)).near()).isEmpty();
        assertThat(ClosestApproach.of(List.of(boat, landing))
                        .ever()
                        .orElseThrow()
                        .distanceM())
                .isCloseTo(6, within(1e-9));
        assertThat(ClosestApproach.of(List.of(landing, boat("under", at(0, 6, 0), at(10_000, 6, 0))))
                        .nearMillis())
                .as("the last 3 m of the descent, at 4 m/s")
                .isEqualTo(750);
    }

    @Test
    void boatsThatUseOnePlaceAtDifferentTimesAreNotNear() {
        BoatResult first = boat("first", at(0, 0, 0), at(10_000, 10, 0), at(20_000, 110, 0));
        BoatResult second = boat("second", at(0, 0, 200), at(10_000, 0, 200), at(20_000, 0, 0));

        assertThat(ClosestApproach.of(List.of(first, second))
                        .ever()
                        .orElseThrow()
                        .distanceM())
                .isGreaterThan(90);
    }

    @Test
    void aBoatThatJoinsLateIsComparedFromThenOn() {
        BoatResult early = boat("early", at(0, 0, 0), at(60_000, 60, 0));
        BoatResult late = boat("late", at(50_000, 0, 0), at(60_000, 0, 0));

        Approach nearest = ClosestApproach.of(List.of(early, late)).ever().orElseThrow();

        assertThat(nearest.atMillis()).isEqualTo(50_000);
        assertThat(nearest.distanceM()).isCloseTo(50, within(1e-9));
    }

    @Test
    void boatsThatWereNeverThereTogetherHaveNone() {
        BoatResult gone = boat("gone", at(0, 0, 0), at(10_000, 1, 0));
        BoatResult late = boat("late", at(20_000, 0, 0), at(30_000, 0, 0));

        assertThat(ClosestApproach.of(List.of(gone, late)).ever()).isEmpty();
        assertThat(ClosestApproach.of(List.of(gone)).ever()).isEmpty();
        assertThat(ClosestApproach.of(List.of(gone, boat("never"))).ever()).isEmpty();
    }

    @Test
    void boatsThatBeginSideBySideAreAlsoComparedUnderWay() {
        BoatResult one = boat("one", at(0, 0, 0), at(10_000, 0, 100), at(20_000, 0, 200));
        BoatResult two = boat("two", at(0, 5, 0), at(10_000, 55, 100), at(20_000, 8, 200));

        ClosestApproach closest = ClosestApproach.of(List.of(one, two));

        assertThat(closest.ever().orElseThrow().atMillis()).isZero();
        assertThat(closest.ever().orElseThrow().distanceM()).isEqualTo(5);
        assertThat(closest.underWay().orElseThrow().atMillis()).isEqualTo(20_000);
        assertThat(closest.underWay().orElseThrow().distanceM()).isEqualTo(8);
    }

    @Test
    void agreesWithLookingEveryTenthOfASecond() {
        Random random = new Random(11);
        for (int round = 0; round < 20; round++) {
            List<BoatResult> boats = List.of(wandering("a", random), wandering("b", random), wandering("c", random));

            Optional<Approach> nearest = ClosestApproach.of(boats).ever();

            double least = Double.MAX_VALUE;
            for (long t = 0; t <= 100_000; t += 100) {
                for (int i = 0; i < boats.size(); i++) {
                    for (int j = i + 1; j < boats.size(); j++) {
                        least = Math.min(
                                least,
                                distance(boats.get(i).track(), boats.get(j).track(), t));
                    }
                }
            }
            assertThat(nearest.map(Approach::distanceM).orElse(Double.MAX_VALUE))
                    .isLessThanOrEqualTo(least + 1e-9)
                    .isGreaterThan(least - 0.6);
        }
    }

    private static BoatResult wandering(String id, Random random) {
        List<TrackPoint> track = new ArrayList<>();
        for (long t = 1000L * random.nextInt(30); t < 100_000; t += 500 + random.nextInt(15_000)) {
            track.add(at(t, 40 * random.nextDouble(), 40 * random.nextDouble()));
        }
        return new BoatResult(id, LINK, 0, 100, 0, 0, track);
    }

    private static double distance(List<TrackPoint> one, List<TrackPoint> other, long atMillis) {
        double[] a = where(one, atMillis);
        double[] b = where(other, atMillis);
        return a.length == 0 || b.length == 0 ? Double.MAX_VALUE : Math.hypot(a[0] - b[0], a[1] - b[1]);
    }

    private static double[] where(List<TrackPoint> track, long atMillis) {
        for (int i = 0; i + 1 < track.size(); i++) {
            TrackPoint from = track.get(i);
            TrackPoint to = track.get(i + 1);
            if (from.atMillis() <= atMillis && atMillis <= to.atMillis()) {
                double part = (double) (atMillis - from.atMillis()) / (to.atMillis() - from.atMillis());
                return new double[] {
                    from.eastM() + part * (to.eastM() - from.eastM()),
                    from.northM() + part * (to.northM() - from.northM())
                };
            }
        }
        return new double[0];
    }

    private static BoatResult boat(String id, TrackPoint... track) {
        return new BoatResult(id, LINK, 0, 100, 0, 0, List.of(track));
    }

    private static TrackPoint flown(long millis, double eastM, double altM) {
        return new TrackPoint(millis, eastM, 0, 45, 10 + eastM * 1e-5, 1, 100, altM);
    }

    private static TrackPoint at(long millis, double eastM, double northM) {
        return new TrackPoint(millis, eastM, northM, 45 + northM * 1e-5, 10 + eastM * 1e-5, 1, 100);
    }
}
