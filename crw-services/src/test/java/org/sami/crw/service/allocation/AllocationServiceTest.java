package org.sami.crw.service.allocation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.choice.Criterion;
import org.sami.spn.value.GeoPoint;

/** Which algorithm is chosen by which criterion, and that its result is better by that criterion than those of the others. */
class AllocationServiceTest {
    private final AllocationService service = AllocationService.STANDARD;

    @Test
    void forComputationTimeTheAuctionWhichMeasuresFewestDistances() {
        AllocationProblem problem = scene(12, 5, 40);

        Division chosen = best(problem, Criterion.COMPUTATION_TIME);

        assertThat(chosen.method()).isEqualTo("Sequential single-item auction");
        assertThat(chosen.legsMeasured() * 5)
                .isLessThan(best(problem, Criterion.EXECUTION_TIME).legsMeasured())
                .isLessThan(best(problem, Criterion.EXECUTION_EFFICIENCY).legsMeasured());
    }

    @Test
    void forExecutionTimeTheBalancedDivisionWhoseLongestPathIsShortest() {
        AllocationProblem problem = scene(12, 5, 40);

        Division chosen = best(problem, Criterion.EXECUTION_TIME);

        assertThat(chosen.method()).isEqualTo("Balanced division");
        assertThat(chosen.longestM() * 1.05)
                .isLessThan(best(problem, Criterion.COMPUTATION_TIME).longestM())
                .isLessThan(best(problem, Criterion.EXECUTION_EFFICIENCY).longestM());
    }

    @Test
    void forExecutionEfficiencyTheLeastTotalAndTheOptimumWhereItIsSolvable() {
        AllocationProblem problem = scene(12, 5, 40);

        Division chosen = best(problem, Criterion.EXECUTION_EFFICIENCY);

        assertThat(chosen.method()).isEqualTo("Least total division");
        assertThat(chosen.totalM() * 1.05)
                .isLessThan(best(problem, Criterion.COMPUTATION_TIME).totalM())
                .isLessThan(best(problem, Criterion.EXECUTION_TIME).totalM());
        assertThat(best(scene(12, 3, 10), Criterion.EXECUTION_EFFICIENCY).method())
                .isEqualTo("Optimal division");
    }

    @Test
    void forExecutionSafetyPathsThatDoNotCross() {
        AllocationProblem problem = scene(12, 5, 40);

        Division chosen = best(problem, Criterion.EXECUTION_SAFETY);

        assertThat(chosen.method()).isEqualTo("Least total division");
        assertThat(chosen.crossings()).isZero();
        assertThat(best(problem, Criterion.COMPUTATION_TIME).crossings()).isPositive();
        assertThat(best(scene(12, 6, 4), Criterion.EXECUTION_SAFETY).method()).isEqualTo("Optimal assignment");
    }

    @Test
    void withoutACriterionTheAuctionIsTheStandard() {
        AllocationService.Options options = service.solve(scene(1, 3, 5), Optional.empty(), 1);

        assertThat(options.best().method()).isEqualTo("Sequential single-item auction");
        assertThat(options.reason()).contains("standard");
    }

    @Test
    void theReasonSaysWhatEachDeclaresAndWhyOthersCannot() {
        AllocationService.Options options = service.solve(scene(1, 5, 40), Optional.of(Criterion.EXECUTION_TIME), 1);

        assertThat(options.reason())
                .startsWith("Balanced division, best for execution time")
                .contains("Sequential single-item auction is good for it")
                .contains("not Optimal division: 40 locations")
                .contains("not Optimal assignment: 40 locations for 5 boats");
    }

    @Test
    void severalOptionsAreDifferentAndRankedByWhatIsMeasured() {
        List<Division> options = service.solve(scene(12, 5, 40), Optional.of(Criterion.EXECUTION_TIME), 3)
                .divisions();

        assertThat(options).hasSize(3).isSortedAccordingTo(Division.by(Criterion.EXECUTION_TIME));
        assertThat(options).extracting(Division::paths).doesNotHaveDuplicates();
        assertThat(service.solve(scene(12, 1, 1), Optional.empty(), 9).divisions())
                .as("there is but one way")
                .hasSize(1);
        assertThatThrownBy(() -> service.solve(scene(1, 1, 1), Optional.empty(), 0))
                .hasMessageContaining("0");
    }

    @Test
    void eachOptionSaysWhyItIsThere() {
        AllocationService.Options options = service.solve(scene(12, 5, 40), Optional.of(Criterion.EXECUTION_TIME), 3);

        assertThat(options.reasons()).hasSize(3).contains(options.reason());
        for (int i = 0; i < 3; i++) {
            assertThat(options.reasons().get(i))
                    .startsWith(options.divisions().get(i).method());
        }
        assertThat(service.solve(scene(12, 5, 40), Optional.empty(), 2)
                        .reasons()
                        .get(1))
                .isEqualTo(
                        "Balanced division; offered beside Sequential single-item auction, as several options were wanted");
    }

    @Test
    void whenABoatLeavesTheOthersKeepWhatTheyHaveBegun() {
        Map<String, List<WorkItem>> paths = new LinkedHashMap<>();
        paths.put("west", List.of(visit("a", -100, 0), visit("b", -100, 50)));
        paths.put("middle", List.of(visit("c", 0, 40), visit("d", 0, 90)));
        paths.put("east", List.of(visit("e", 100, 0), visit("f", 100, 60)));
        List<Candidate> present = List.of(
                new Candidate("west", at(-100, -20), java.util.Set.of(), List.of(visit("a", -100, 0))),
                new Candidate("east", at(100, -20), java.util.Set.of(), List.of(visit("e", 100, 0))));

        Division anew = service.solve(Reassignment.of(present, paths), Optional.of(Criterion.EXECUTION_EFFICIENCY), 1)
                .best();

        assertThat(anew.paths().get("west").get(0).name()).isEqualTo("a");
        assertThat(anew.paths().get("east").get(0).name()).isEqualTo("e");
        assertThat(anew.paths().values().stream().flatMap(List::stream).map(WorkItem::name))
                .containsExactlyInAnyOrder("a", "b", "c", "d", "e", "f");
    }

    @Test
    void aBoatThatReturnsGetsAShareOfWhatIsNotBegun() {
        Map<String, List<WorkItem>> paths =
                Map.of("west", List.of(visit("a", -100, 0), visit("b", -100, 50), visit("c", 100, 0)));
        List<Candidate> present = List.of(
                new Candidate("west", at(-100, -20), java.util.Set.of(), List.of(visit("a", -100, 0))),
                Candidate.at("east", at(100, -20)));

        Division anew = service.solve(Reassignment.of(present, paths), Optional.of(Criterion.EXECUTION_TIME), 1)
                .best();

        assertThat(anew.paths().get("west")).extracting(WorkItem::name).containsExactly("a", "b");
        assertThat(anew.paths().get("east")).extracting(WorkItem::name).containsExactly("c");
    }

    private Division best(AllocationProblem problem, Criterion criterion) {
        return service.solve(problem, Optional.of(criterion), 1).best();
    }

    private static AllocationProblem scene(long seed, int boats, int locations) {
        AreaOfTest area = new AreaOfTest(seed);
        return AllocationProblem.ofVisits(area.boats(boats), area.points(locations));
    }

    private static WorkItem visit(String name, double eastM, double northM) {
        return WorkItem.visit(name, at(eastM, northM));
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(AreaOfTest.CENTRE, eastM, northM);
    }
}
