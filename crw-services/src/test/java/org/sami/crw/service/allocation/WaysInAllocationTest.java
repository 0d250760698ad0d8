package org.sami.crw.service.allocation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.path.WayLengths;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Who gets what where ways lead around something. */
class WaysInAllocationTest {
    /** A wall from north to south, and a boat on either side of it. */
    private static final Water WALL = water(box(-5, -1000, 5, 1000));

    private static final Water LAGOON = water(new GeoArea(
            box(200, -100, 400, 100).outline(), List.of(box(210, -90, 390, 90).outline())));
    private static final Candidate WEST = Candidate.at("west", at(-20, 0));
    private static final Candidate EAST = Candidate.at("east", at(300, 0));

    static Stream<AllocationAlgorithm> algorithms() {
        return AllocationService.STANDARD.algorithms().stream();
    }

    @ParameterizedTest
    @MethodSource("algorithms")
    void aLocationBehindAWallGoesToTheBoatWithTheShorterWay(AllocationAlgorithm algorithm) {
        AllocationProblem problem = new AllocationProblem(List.of(WEST, EAST), List.of(visit("behind", 20, 0)));

        Division straight = algorithm.divide(problem);
        Division around = algorithm.divide(problem.in(WALL));

        assertThat(straight.boatOf()).containsEntry("behind", "west");
        assertThat(around.boatOf()).containsEntry("behind", "east");
        assertThat(around.longestM()).isCloseTo(280, within(0.5));
        assertThat(around.shortfall()).isEmpty();
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 8, 14})
    void aLocationInALagoonGoesToTheBoatInItByAllAlgorithms(int locations) {
        Candidate inside = Candidate.at("inside", at(260, 0));
        Candidate outside = Candidate.at("outside", at(199, 0));
        List<WorkItem> work = new ArrayList<>(List.of(visit("in it", 211, 0)));
        for (int i = 1; i < locations; i++) {
            work.add(visit("far " + i, -10 * i, 30 * i));
        }
        AllocationProblem problem = new AllocationProblem(List.of(outside, inside), work).in(LAGOON);
        int solved = 0;
        for (AllocationAlgorithm algorithm : AllocationService.STANDARD.algorithms()) {
            if (algorithm.whyNot(problem).isEmpty()) {
                solved++;

                Division division = algorithm.divide(problem);

                assertThat(division.paths().get("inside"))
                        .extracting(WorkItem::name)
                        .containsExactly("in it");
                assertThat(division.boatOf()).hasSize(locations);
                assertThat(division.unallocated()).isEmpty();
            }
        }
        assertThat(solved).isGreaterThanOrEqualTo(3);
    }

    @ParameterizedTest
    @MethodSource("algorithms")
    void whatNobodyGetsToIsNamed(AllocationAlgorithm algorithm) {
        AllocationProblem problem = new AllocationProblem(List.of(WEST), List.of(visit("in it", 300, 0))).in(LAGOON);

        Division division = algorithm.divide(problem);

        assertThat(division.boatOf()).isEmpty();
        assertThat(division.unallocated())
                .singleElement()
                .satisfies(one -> assertThat(one.words())
                        .startsWith("in it, at 45.6")
                        .endsWith("is unallocated: no boat that can do it has a way there around no-go areas"));
    }

    @Test
    void aChargeIsSetAgainstTheWayAroundAndNotTheStraightOne() {
        Candidate near = WEST.within(500);
        Candidate far = Candidate.at("far", at(-900, 0)).within(5000);
        AllocationProblem problem = new AllocationProblem(List.of(near, far), List.of(visit("behind", 20, 0)));
        SequentialSingleItemAuction auction = new SequentialSingleItemAuction();

        assertThat(auction.divide(problem).boatOf()).containsEntry("behind", "west");
        assertThat(auction.divide(problem.in(WALL)).boatOf()).containsEntry("behind", "far");
    }

    @Test
    void whereThereAreTooManyDistancesAreStraightAndThatIsSaid() {
        AllocationProblem problem = AllocationProblem.ofVisits(
                        new AreaOfTest(1).boats(2), new AreaOfTest(2).points(WayLengths.MOST_POINTS))
                .in(WALL);

        Division division = new SequentialSingleItemAuction().divide(problem);

        assertThat(division.shortfall())
                .hasValueSatisfying(words -> assertThat(words).startsWith("distances are straight"));
        assertThat(division.boatOf()).hasSize(WayLengths.MOST_POINTS);
    }

    private static Water water(GeoArea avoid) {
        return Water.of(AreaOfTest.CENTRE, List.of(avoid), Optional.empty()).drivenWith(CrossTrackError.CALM);
    }

    private static WorkItem visit(String name, double eastM, double northM) {
        return WorkItem.visit(name, at(eastM, northM));
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(east, south), at(east, north), at(west, north)), List.of());
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(AreaOfTest.CENTRE, eastM, northM);
    }
}
