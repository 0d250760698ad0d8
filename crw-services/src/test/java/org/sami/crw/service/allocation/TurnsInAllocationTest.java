package org.sami.crw.service.allocation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.path.TurningCircle;
import org.sami.crw.testing.AllocationScene;
import org.sami.spn.value.GeoPoint;

/** Boats with turning circles get less of what has sharp turns. */
class TurnsInAllocationTest {
    private static final GeoPoint CENTRE = GeoPoint.of(45.7, 10.72);
    private static final List<AllocationAlgorithm> BY_TIME =
            List.of(new SequentialSingleItemAuction(), new BalancedDivision());

    private static WorkItem visit(String name, double eastM, double northM) {
        return WorkItem.visit(name, at(eastM, northM));
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(CENTRE, eastM, northM);
    }

    /** To the east a straight row, to the west a zigzag of the same length: whichever boat comes first, the one that turns on the spot has the zigzag. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void boatWithAWideCircleHasTheStraightWay(boolean wideFirst) {
        List<WorkItem> work = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            work.add(visit("zigzag " + i, -20 - 6 * i, i % 2 == 0 ? 0 : 10));
            work.add(visit("row " + i, 20 + 11.66 * i, 0));
        }
        Candidate wide = Candidate.at("wide", at(0, 0)).turningIn(20);
        Candidate narrow = Candidate.at("narrow", at(0, 0));
        List<Candidate> boats = wideFirst ? List.of(wide, narrow) : List.of(narrow, wide);

        Division division = new BalancedDivision().divide(new AllocationProblem(boats, work));

        assertThat(division.paths().get("wide"))
                .hasSize(6)
                .extracting(WorkItem::name)
                .allMatch(name -> name.startsWith("row"));
        assertThat(division.latestM()).isCloseTo(division.longestM(), within(0.5));
    }

    /** Two columns of locations: a zigzag between them is the shortest way, up the one and down the other is the way with few turns. */
    @Test
    void balancedPathOfABoatWithAWideCircleTurnsLess() {
        List<WorkItem> work = new ArrayList<>();
        for (int i = 0; i < 8; i++) {
            work.add(visit("left " + i, 0, 8.0 * i));
            work.add(visit("right " + i, 6, 8.0 * i + 4));
        }
        Candidate boat = Candidate.at("boat", at(0, -12));

        Division narrow = new BalancedDivision().divide(new AllocationProblem(List.of(boat), work));
        Division wide = new BalancedDivision().divide(new AllocationProblem(List.of(boat.turningIn(5)), work));

        assertThat(turns(wide)).isLessThan(0.5 * turns(narrow));
        assertThat(wide.longestM()).isGreaterThan(narrow.longestM());
        assertThat(wide.latestM()).isLessThan(narrow.longestM() + 5 * turns(narrow));
    }

    private static double turns(Division division) {
        List<GeoPoint> way =
                new ArrayList<>(List.of(division.problem().boats().get(0).at()));
        division.paths().get("boat").forEach(one -> way.add(one.location()));
        return TurningCircle.perRadius(way);
    }

    /** The way of 90 m is within the charge, and its turn takes as long as 31 m: still sooner than the other boat from afar. */
    @Test
    void turnsTakeTimeAndNoCharge() {
        List<WorkItem> work = List.of(visit("behind", -30, 0), visit("ahead", 30, 0));
        Candidate near = Candidate.at("near", at(0, 0)).turningIn(10).within(95);
        Candidate far = Candidate.at("far", at(155, 0));

        Division division = new BalancedDivision().divide(new AllocationProblem(List.of(near, far), work));

        assertThat(division.paths().get("near")).hasSize(2);
        assertThat(division.shortfall()).isEmpty();
    }

    /** The time of a division is that of the way with its turns; its lengths are those of the legs. */
    @Test
    void latestCountsTurnsAndLengthsDoNot() {
        List<WorkItem> work = List.of(visit("corner", 100, 0), visit("end", 100, 100));
        Candidate boat = Candidate.at("boat", at(0, 0)).turningIn(10);

        for (AllocationAlgorithm algorithm : BY_TIME) {
            Division division = algorithm.divide(new AllocationProblem(List.of(boat), work));

            assertThat(division.longestM()).isCloseTo(200, within(0.1));
            assertThat(division.latestM()).isCloseTo(200 + 10 * (Math.PI / 2 - 1), within(0.1));
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {9, 40, 300})
    void balancedDivisionIsNeverLaterThanWithoutALookAtTurns(int locations) {
        AllocationProblem problem = new AllocationScene(4, locations, true, false, 7).problem();
        AllocationProblem wide = new AllocationProblem(
                problem.boats().stream().map(boat -> boat.turningIn(12)).toList(), problem.work());

        Division looked = new BalancedDivision().divide(wide);

        Map<String, List<WorkItem>> blind =
                new BalancedDivision().divide(problem).paths();
        double blindM = wide.boats().stream()
                .mapToDouble(boat -> withTurnsM(boat, blind.get(boat.boat())))
                .max()
                .orElseThrow();
        assertThat(looked.latestM()).isLessThan(blindM + 0.01);
        assertThat(looked.paths().values().stream().mapToInt(List::size).sum()).isEqualTo(locations);
    }

    private static double withTurnsM(Candidate boat, List<WorkItem> path) {
        List<GeoPoint> way = new ArrayList<>(List.of(boat.at()));
        path.forEach(one -> way.add(one.location()));
        return Geodesy.lengthM(boat.at(), way) + boat.turningRadiusM() * TurningCircle.perRadius(way);
    }

    @Test
    void auctionGivesFewerLocationsToTheBoatWithTheWideCircle() {
        AllocationProblem problem = new AllocationScene(3, 60, false, true, 5).problem();
        AllocationProblem wide = new AllocationProblem(
                List.of(
                        problem.boats().get(0).turningIn(40),
                        problem.boats().get(1),
                        problem.boats().get(2)),
                problem.work());
        String boat = problem.boats().get(0).boat();

        List<WorkItem> before =
                new SequentialSingleItemAuction().divide(problem).paths().get(boat);
        List<WorkItem> now =
                new SequentialSingleItemAuction().divide(wide).paths().get(boat);

        assertThat(now.size()).isBetween(1, before.size() - 1);
    }

    /** What a search without turns has measured is no work of the auction with turns. */
    @Test
    void auctionWithTurnsGoesToItsOwnLimitWhateverTheSearchHasMeasured() {
        AllocationProblem problem = new AllocationScene(3, 40, false, true, 5).problem();
        AllocationProblem wide = new AllocationProblem(
                problem.boats().stream().map(boat -> boat.turningIn(12)).toList(), problem.work());
        TravelCosts alone = new TravelCosts(wide);
        new SequentialSingleItemAuction().shares(wide, alone);
        TravelCosts justEnough = new TravelCosts(wide);
        justEnough.count(SequentialSingleItemAuction.LIMIT - alone.measured());

        new BalancedDivision().shares(wide, justEnough);

        assertThat(justEnough.measured()).isGreaterThan(SequentialSingleItemAuction.LIMIT);
        assertThat(justEnough.shortfall()).isEmpty();
    }
}
