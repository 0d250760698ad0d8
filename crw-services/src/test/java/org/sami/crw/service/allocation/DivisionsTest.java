package org.sami.crw.service.allocation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/** What all allocation algorithms keep, and what each is better at. */
@Tag("long")
class DivisionsTest {
    private static final List<String> SKILLS = List.of("camera", "temperature", "winch");

    static Stream<AllocationAlgorithm> algorithms() {
        return AllocationService.STANDARD.algorithms().stream();
    }

    @ParameterizedTest
    @MethodSource("algorithms")
    void eachWorkIsOnOnePathOfABoatThatCanDoItOrNamedAsUnallocated(AllocationAlgorithm algorithm) {
        int solved = 0;
        for (long seed = 1; seed <= 60; seed++) {
            AllocationProblem problem = withSkills(seed);
            if (algorithm.whyNot(problem).isPresent()) {
                continue;
            }
            solved++;

            Division division = algorithm.divide(problem);

            List<WorkItem> done = new ArrayList<>();
            for (Candidate boat : problem.boats()) {
                List<WorkItem> path = division.paths().get(boat.boat());
                assertThat(path.subList(0, boat.begun().size())).isEqualTo(boat.begun());
                List<WorkItem> fresh = path.subList(boat.begun().size(), path.size());
                assertThat(fresh).allSatisfy(work -> assertThat(boat.offers()).containsAll(work.needs()));
                done.addAll(fresh);
            }
            division.unallocated().forEach(one -> done.add(one.work()));
            assertThat(done).as("seed %s", seed).containsExactlyInAnyOrderElementsOf(problem.work());
            assertLengths(division);
        }
        assertThat(solved).isGreaterThan(10);
    }

    private static void assertLengths(Division division) {
        double[] lengths = division.problem().boats().stream()
                .mapToDouble(boat -> Geodesy.lengthM(
                        boat.at(),
                        division.paths().get(boat.boat()).stream()
                                .map(WorkItem::location)
                                .toList()))
                .toArray();
        assertThat(division.totalM()).isCloseTo(java.util.Arrays.stream(lengths).sum(), within(1e-6));
        assertThat(division.longestM())
                .isCloseTo(java.util.Arrays.stream(lengths).max().orElse(0), within(1e-6));
    }

    @Test
    void noDivisionHasASmallerSumThanTheOptimalOne() {
        for (long seed = 1; seed <= 60; seed++) {
            AllocationProblem problem = problem(seed, 1 + (int) (seed % 3), 1 + (int) (seed % 6));

            Division optimal = new OptimalDivision().divide(problem);

            assertThat(optimal.totalM()).as("seed %s", seed).isCloseTo(leastOf(problem, true), within(0.01));
        }
    }

    @Test
    void noDivisionOfFewLocationsHasAShorterLongestPathThanTheBalancedOne() {
        for (long seed = 1; seed <= 60; seed++) {
            AllocationProblem problem = problem(seed, 1 + (int) (seed % 3), 1 + (int) (seed % 6));

            Division balanced = new BalancedDivision().divide(problem);

            assertThat(balanced.longestM()).as("seed %s", seed).isCloseTo(leastOf(problem, false), within(0.01));
        }
    }

    /** Locations 100 m apart in a line, twice as many to the east as to the west of two boats, one of twice the other's speed. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void boatOfTwiceTheSpeedGetsTheLongerWay(boolean few) {
        GeoPoint middle = AreaOfTest.CENTRE;
        List<WorkItem> work = new ArrayList<>();
        int each = few ? 3 : 15;
        for (int i = 1; i <= each; i++) {
            work.add(WorkItem.visit("west " + i, Geodesy.offset(middle, -100.0 * i, 0)));
            work.add(WorkItem.visit("east " + i, Geodesy.offset(middle, 100.0 * i, 0)));
            work.add(WorkItem.visit("far east " + i, Geodesy.offset(middle, 100.0 * (each + i), 0)));
        }
        Candidate slow = Candidate.at("slow", middle).atSpeed(1);
        Candidate fast = Candidate.at("fast", middle).atSpeed(2);

        Division division = new BalancedDivision().divide(new AllocationProblem(List.of(slow, fast), work));

        assertThat(division.paths().get("slow")).extracting(WorkItem::name).allMatch(name -> name.startsWith("west"));
        assertThat(division.paths().get("fast")).hasSize(2 * each);
        assertThat(division.longestM()).isCloseTo(200.0 * each, within(0.5));
        assertThat(division.latestM()).isCloseTo(200.0 * each, within(0.5));
    }

    @Test
    void boatsOfOneSpeedAreDividedAsBoatsWithoutOne() {
        for (long seed = 1; seed <= 5; seed++) {
            AllocationProblem unknown = problem(seed, 3, 12);
            AllocationProblem known = new AllocationProblem(
                    unknown.boats().stream().map(boat -> boat.atSpeed(0.7)).toList(), unknown.work());

            for (AllocationAlgorithm algorithm : List.of(new SequentialSingleItemAuction(), new BalancedDivision())) {
                assertThat(algorithm.divide(known).paths())
                        .isEqualTo(algorithm.divide(unknown).paths());
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"2,10", "3,10", "5,9"})
    void theLeastTotalIsWithinAPercentOfTheOptimum(int boats, int locations) {
        for (long seed = 1; seed <= 10; seed++) {
            AllocationProblem problem = problem(seed, boats, locations);

            double ratio = new LeastTotalDivision().divide(problem).totalM()
                    / new OptimalDivision().divide(problem).totalM();

            assertThat(ratio).as("seed %s", seed).isBetween(1 - 1e-6, 1.01);
        }
    }

    @Test
    void theLeastTotalLeavesNoPathsThatCross() {
        for (long seed = 1; seed <= 8; seed++) {
            assertThat(new LeastTotalDivision().divide(problem(seed, 5, 40)).crossings())
                    .as("seed %s", seed)
                    .isZero();
        }
    }

    @Test
    void theOptimalAssignmentLeavesNoPathsThatCross() {
        for (long seed = 1; seed <= 100; seed++) {
            assertThat(new OptimalAssignment().divide(problem(seed, 8, 8)).crossings())
                    .as("seed %s", seed)
                    .isZero();
        }
    }

    @Test
    void theOptimalAssignmentGivesEachBoatAtMostOneAndHasTheLeastSumOfThose() {
        for (long seed = 1; seed <= 30; seed++) {
            AllocationProblem problem = problem(seed, 6, 5);

            Division assignment = new OptimalAssignment().divide(problem);

            assertThat(assignment.paths().values())
                    .allSatisfy(path -> assertThat(path).hasSizeLessThanOrEqualTo(1));
            assertThat(assignment.totalM()).isCloseTo(leastAssignment(problem, 0, 0), within(0.01));
        }
    }

    @Test
    void whatIsMissingForWorkThatNobodyCanDoIsNamed() {
        GeoPoint here = AreaOfTest.CENTRE;
        Candidate diver = new Candidate("diver", here, Set.of("winch"), List.of());
        Candidate looker = new Candidate("looker", here, Set.of("camera"), List.of());
        WorkItem sonar = new WorkItem("sonar image", here, Set.of("sonar", "winch"));
        WorkItem both = new WorkItem("deep picture", here, Set.of("camera", "winch"));
        WorkItem easy = new WorkItem("picture", here, Set.of("camera"));
        AllocationProblem problem = new AllocationProblem(List.of(diver, looker), List.of(sonar, both, easy));

        Division division = new SequentialSingleItemAuction().divide(problem);

        assertThat(division.unallocated().stream().map(Unallocated::words))
                .containsExactly(
                        "sonar image is unallocated: no boat offers sonar",
                        "deep picture is unallocated: no boat offers camera and winch together");
        assertThat(division.boatOf()).containsOnly(Map.entry("picture", "looker"));
    }

    private static AllocationProblem problem(long seed, int boats, int locations) {
        AreaOfTest area = new AreaOfTest(seed);
        return AllocationProblem.ofVisits(area.boats(boats), area.points(locations));
    }

    /** Boats with some skills and work begun, work that needs some. */
    private static AllocationProblem withSkills(long seed) {
        AreaOfTest area = new AreaOfTest(seed);
        Random random = new Random(seed);
        List<Candidate> boats = new ArrayList<>();
        for (int b = 0; b <= random.nextInt(6); b++) {
            List<WorkItem> begun =
                    random.nextInt(3) == 0 ? List.of(WorkItem.visit("begun " + b, area.point())) : List.of();
            boats.add(new Candidate("boat-" + b, area.point(), some(random), begun));
        }
        List<WorkItem> work = new ArrayList<>();
        for (int w = 0; w < random.nextInt(seed % 2 == 0 ? 7 : 25); w++) {
            work.add(new WorkItem("work " + w, area.point(), random.nextInt(3) == 0 ? some(random) : Set.of()));
        }
        return new AllocationProblem(boats, work);
    }

    private static Set<String> some(Random random) {
        Set<String> some = new java.util.TreeSet<>();
        SKILLS.stream().filter(skill -> random.nextBoolean()).forEach(some::add);
        return some;
    }

    /** The least sum, or the least longest, of all divisions in all orders. */
    private static double leastOf(AllocationProblem problem, boolean sum) {
        return least(problem, new ArrayList<>(problem.work()), 0, 0, sum);
    }

    private static double least(AllocationProblem problem, List<WorkItem> left, int boat, double soFar, boolean sum) {
        if (boat == problem.boats().size()) {
            return left.isEmpty() ? soFar : Double.POSITIVE_INFINITY;
        }
        return extend(problem, left, boat, soFar, sum, problem.boats().get(boat).at(), 0);
    }

    private static double extend(
            AllocationProblem problem,
            List<WorkItem> left,
            int boat,
            double soFar,
            boolean sum,
            GeoPoint at,
            double length) {
        double joined = sum ? soFar + length : Math.max(soFar, length);
        double least = least(problem, left, boat + 1, joined, sum);
        for (int i = 0; i < left.size(); i++) {
            WorkItem next = left.remove(i);
            double leg = Geodesy.distanceM(at, next.location());
            least = Math.min(least, extend(problem, left, boat, soFar, sum, next.location(), length + leg));
            left.add(i, next);
        }
        return least;
    }

    private static double leastAssignment(AllocationProblem problem, int work, int used) {
        if (work == problem.work().size()) {
            return 0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int boat = 0; boat < problem.boats().size(); boat++) {
            if ((used & 1 << boat) == 0) {
                double leg = Geodesy.distanceM(
                        problem.boats().get(boat).at(), problem.work().get(work).location());
                least = Math.min(least, leg + leastAssignment(problem, work + 1, used | 1 << boat));
            }
        }
        return least;
    }
}
