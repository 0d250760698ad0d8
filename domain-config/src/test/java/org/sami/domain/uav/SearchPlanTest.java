package org.sami.domain.uav;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseView;

/** The search of an area by aircraft: its phase chart is that of the thesis's Figures 5.7 to 5.10. */
class SearchPlanTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/uav").orThrow();
    private static final Plan PLAN = DOMAIN.projectOf("search")
            .flatMap(project -> project.plan("search"))
            .orElseThrow();
    private static final PhaseChart CHART = PhaseChart.of(PLAN, DOMAIN.vocabulary());

    /** What a person reads off a phase: row by row, with the column of each box. */
    private static Stream<String> boxes(PhaseView view) {
        return view.boxes().stream()
                .map(box -> view.actors().get(box.row()) + " " + box.column() + " "
                        + box.action().label());
    }

    private static List<String> buttons(String action) {
        return CHART.options(action).stream().map(PhaseAction::label).toList();
    }

    @Test
    void phasesAreLocationsAssignmentAndExecution() {
        assertThat(CHART.phases()).containsExactly("Get locations", "Task assignment", "Task execution");
        assertThat(CHART.branchesOfNothing()).isEmpty();
    }

    @Test
    void locationsAreCreatedByTheOperatorAndMadeTasks() {
        PhaseView view = CHART.view("Get locations", Map.of());

        assertThat(boxes(view)).containsExactly("OPERATOR 0 Create locations", "SAMI 1 Generate tasks");
        assertThat(view.next()).containsExactly("Task assignment");
    }

    @Test
    void operatorsChoiceOfAnAllocationHasAButtonForYesAndOneForNo() {
        assertThat(buttons("ask-choice")).containsExactly("Yes", "No");

        PhaseView yes = CHART.view("Task assignment", Map.of());
        PhaseView no = CHART.view("Task assignment", Map.of("ask-choice", "rejected-event"));

        assertThat(yes.actors()).containsExactly("SAMI", "OPERATOR");
        assertThat(boxes(yes))
                .containsExactly(
                        "SAMI 0 Compute allocations",
                        "OPERATOR 1 Operator chooses allocation",
                        "OPERATOR 2 Yes",
                        "SAMI 3 Apply allocation");
        assertThat(yes.next()).containsExactly("Task execution");
        assertThat(boxes(no))
                .containsExactly(
                        "SAMI 0 Compute allocations", "OPERATOR 1 Operator chooses allocation", "OPERATOR 2 No");
        assertThat(no.next()).as("back to its own beginning").isEmpty();
    }

    @Test
    void executionBranchesByWhatAnAircraftSeesAndTheOperatorSays() {
        assertThat(buttons("fly-there")).containsExactly("It arrives", "It cannot", "It is lost");
        assertThat(buttons("search-there")).containsExactly("Target seen", "Nothing seen", "It cannot", "It is lost");
        assertThat(buttons("ask-target")).containsExactly("Yes", "No");
        assertThat(buttons("ask-retry")).containsExactly("Allocate anew", "Leave it out", "No aircraft can");

        PhaseView found = CHART.view("Task execution", Map.of());
        PhaseView nothing = CHART.view("Task execution", Map.of("search-there", "unseen-event"));
        PhaseView cannot =
                CHART.view("Task execution", Map.of("fly-there", "cannot-event", "ask-retry", "give-up-event"));

        assertThat(found.actors()).containsExactly("UAV", "OPERATOR", "SAMI");
        assertThat(boxes(found))
                .containsExactly(
                        "UAV 0 Fly to location",
                        "UAV 1 It arrives",
                        "UAV 2 Search",
                        "UAV 3 Target seen",
                        "OPERATOR 4 Confirm target",
                        "OPERATOR 5 Yes",
                        "SAMI 6 Report target",
                        "UAV 7 Return home");
        assertThat(found.next()).as("the last phase").isEmpty();
        assertThat(boxes(nothing))
                .containsExactly(
                        "UAV 0 Fly to location",
                        "UAV 1 It arrives",
                        "UAV 2 Search",
                        "UAV 3 Nothing seen",
                        "UAV 4 Return home");
        assertThat(boxes(cannot)).contains("UAV 1 It cannot", "OPERATOR 2 Not searched", "OPERATOR 3 Leave it out");
        assertThat(CHART.view("Task execution", Map.of("fly-there", "lost-flying-event"))
                        .next())
                .containsExactly("Task assignment");
    }
}
