package org.sami.crw.service.allocation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.LocalPlane;
import org.sami.spn.value.GeoPoint;

/** No path is longer than its boat's charge lasts, where somebody else has charge left. */
class RangeRepairTest {
    private static final LocalPlane PLANE = new LocalPlane(GeoPoint.of(45.4, 10.9));

    static Stream<AllocationAlgorithm> algorithms() {
        return AllocationService.STANDARD.algorithms().stream();
    }

    @ParameterizedTest
    @MethodSource("algorithms")
    void boatWithLittleChargeGetsAPathThatItLastsFor(AllocationAlgorithm algorithm) {
        boolean shortened = false; // in one problem at least, of which further ones are not asked
        for (long seed = 1; seed <= 40; seed++) {
            Random random = new Random(seed);
            List<WorkItem> work = new ArrayList<>();
            for (int i = 0; i < 9; i++) {
                work.add(WorkItem.visit("w" + i, at(600 * random.nextDouble(), 600 * random.nextDouble())));
            }
            List<Candidate> boats = List.of(
                    boat("full", 290).within(3180),
                    boat("weak", 300).within(320),
                    boat("other", 310).within(3180));
            AllocationProblem problem = new AllocationProblem(boats, work);
            if (algorithm.whyNot(problem).isPresent()) {
                return;
            }

            Division division = algorithm.divide(problem);

            for (Candidate boat : boats) {
                assertThat(lengthM(boat, division))
                        .as("seed %d, %s", seed, boat.boat())
                        .isLessThanOrEqualTo(boat.rangeM().getAsDouble() + 0.5);
            }
            assertThat(division.boatOf()).hasSize(work.size());
            assertThat(division.shortfall()).isEmpty();
            shortened = shortened || isLongerWithoutItsCharge(algorithm, work);
        }
        assertThat(shortened).as("it would have got more in a problem").isTrue();
    }

    private static boolean isLongerWithoutItsCharge(AllocationAlgorithm algorithm, List<WorkItem> work) {
        List<Candidate> unknown = List.of(boat("full", 290), boat("weak", 300), boat("other", 310));
        Division free = algorithm.divide(new AllocationProblem(unknown, work));
        return lengthM(unknown.get(1), free) > 320;
    }

    @Test
    void whatIsTooFarForEverybodyIsSaid() {
        List<Candidate> boats =
                List.of(boat("anna", 0).within(500), boat("bert", 10).within(300));
        AllocationProblem problem = new AllocationProblem(boats, List.of(WorkItem.visit("far", at(0, 800))));

        Division division = new SequentialSingleItemAuction().divide(problem);

        assertThat(division.boatOf()).containsOnlyKeys("far");
        assertThat(division.shortfall())
                .hasValueSatisfying(words -> assertThat(words)
                        .contains("anna is to go 820 m, and its charge is sure to last for 500 m")
                        .contains("swapped on the way"));
    }

    /** 400 m out and 400 m home: 500 m last for the one, and not for both. */
    @Test
    void boatGetsNoPathFromWhichItDoesNotComeHomeWhereAnotherDoes() {
        List<WorkItem> far = List.of(WorkItem.visit("far", at(0, 400)));
        Candidate weak = boat("weak", 0).within(500);
        Candidate full = boat("full", 30).within(3000);

        Division out = new SequentialSingleItemAuction().divide(new AllocationProblem(List.of(weak, full), far));
        Division home = new SequentialSingleItemAuction()
                .divide(new AllocationProblem(List.of(weak.returning(weak.at()), full.returning(full.at())), far));

        assertThat(out.boatOf()).containsEntry("far", "weak");
        assertThat(home.boatOf()).containsEntry("far", "full");
        assertThat(home.shortfall()).isEmpty();
    }

    @Test
    void pathsAreAsWithoutWaysHomeWhereChargesDoNotLastForThose() {
        List<WorkItem> far = List.of(WorkItem.visit("far", at(0, 400)));
        Candidate weak = boat("weak", 0).within(500);
        Candidate other = boat("other", 30).within(600);

        Division home = new SequentialSingleItemAuction()
                .divide(new AllocationProblem(List.of(weak.returning(weak.at()), other.returning(other.at())), far));

        assertThat(home.boatOf()).containsEntry("far", "weak");
        assertThat(home.shortfall()).isEmpty();
    }

    @Test
    void workStaysWithABoatThatAloneCanDoIt() {
        Candidate weak = new Candidate("weak", at(0, 0), Set.of("camera"), List.of()).within(100);
        Candidate full = boat("full", 10).within(3000);
        WorkItem picture = new WorkItem("picture", at(0, 400), Set.of("camera"));
        WorkItem visit = WorkItem.visit("visit", at(0, 420));
        AllocationProblem problem = new AllocationProblem(List.of(weak, full), List.of(picture, visit));

        Division division = new LeastTotalDivision().divide(problem);

        assertThat(division.boatOf()).isEqualTo(Map.of("picture", "weak", "visit", "full"));
        assertThat(division.shortfall()).isPresent();
    }

    private static Candidate boat(String name, double eastM) {
        return Candidate.at(name, at(eastM, -20));
    }

    private static GeoPoint at(double eastM, double northM) {
        return PLANE.point(eastM, northM);
    }

    private static double lengthM(Candidate boat, Division division) {
        return Geodesy.lengthM(
                boat.at(),
                division.paths().get(boat.boat()).stream()
                        .map(WorkItem::location)
                        .toList());
    }
}
