package org.sami.crw.service.allocation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.testing.AllocationScene;

/** How short the longest path of a balanced division is. */
@Tag("long")
class BalancedDivisionTest {
    private static final double PROMISED = 1.05;

    /**
     * The last number is what {@code LongestPathAnnealer} found in eight seconds, in metres; kept, as it takes so long. {@code ./gradlew
     * :crw-sim:benchmark -Ponly=service.balance} finds such numbers again.
     */
    @ParameterizedTest
    @CsvSource({
        "2,12,false,false,1,896.0",
        "3,12,true,true,2,854.6",
        "3,20,false,false,1,784.9",
        "3,20,true,false,1,1481.2",
        "5,20,true,true,1,683.7",
        "10,20,false,false,2,227.3",
        "2,30,false,true,1,1352.5",
        "5,40,false,false,2,627.2",
        "5,40,true,true,1,1172.2",
        "3,50,false,true,1,1127.8",
        "10,50,true,false,1,418.4",
        "20,50,false,true,1,621.5",
        "3,100,true,false,1,2415.6",
        "5,100,false,false,1,967.4",
        "10,100,true,false,2,702.0",
        "20,100,false,false,2,314.9"
    })
    void theLongestPathIsAsShortAsAnAnnealerFindsInEightSeconds(
            int boats, int locations, boolean skills, boolean quay, long seed, double annealedM) {
        AllocationProblem problem = new AllocationScene(boats, locations, skills, quay, seed).problem();

        Division balanced = new BalancedDivision().divide(problem);

        assertThat(balanced.longestM()).isLessThanOrEqualTo(PROMISED * annealedM);
    }

    @ParameterizedTest
    @ValueSource(ints = {11, 40, 200, 1200})
    void noDivisionIsWorseThanTheAuctions(int locations) {
        AllocationProblem problem = new AllocationScene(6, locations, true, false, 3).problem();

        double balancedM = new BalancedDivision().divide(problem).longestM();

        assertThat(balancedM)
                .isLessThan(new SequentialSingleItemAuction().divide(problem).longestM());
    }

    @Test
    void equalProblemsHaveEqualAnswers() {
        AllocationProblem problem = new AllocationScene(5, 40, true, false, 4).problem();

        assertThat(new BalancedDivision().divide(problem).paths())
                .isEqualTo(new BalancedDivision().divide(problem).paths());
    }

    @Test
    void paysNoHeedToTheOrderInWhichLocationsAreGiven() {
        AllocationProblem problem = new AllocationScene(4, 30, false, false, 5).problem();
        List<WorkItem> backwards = new ArrayList<>(problem.work());
        java.util.Collections.reverse(backwards);

        double forwardsM = new BalancedDivision().divide(problem).longestM();
        double backwardsM = new BalancedDivision()
                .divide(new AllocationProblem(problem.boats(), backwards))
                .longestM();

        assertThat(backwardsM).isBetween(0.98 * forwardsM, 1.02 * forwardsM);
    }

    @Test
    void aWeakBoatGetsWhatItsChargeLastsForAndTheOthersShareTheRestEvenly() {
        AllocationProblem free = new AllocationScene(4, 40, false, false, 6).problem();
        List<Candidate> boats = new ArrayList<>(free.boats());
        boats.set(0, boats.get(0).within(200));

        Division balanced = new BalancedDivision().divide(new AllocationProblem(boats, free.work()));

        assertThat(lengthM(balanced, boats.get(0))).isLessThan(200);
        assertThat(balanced.shortfall()).isEmpty();
        double shortestM = boats.stream()
                .filter(boat -> boat.rangeM().equals(OptionalDouble.empty()))
                .mapToDouble(boat -> lengthM(balanced, boat))
                .min()
                .orElseThrow();
        assertThat(shortestM).isGreaterThan(0.9 * balanced.longestM());
    }

    private static double lengthM(Division division, Candidate boat) {
        return org.sami.crw.service.Geodesy.lengthM(
                boat.at(),
                division.paths().get(boat.boat()).stream()
                        .map(WorkItem::location)
                        .toList());
    }
}
