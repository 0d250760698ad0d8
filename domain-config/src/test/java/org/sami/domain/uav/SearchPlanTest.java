package org.sami.domain.uav;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.Plan;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.phase.PhaseProgress;
import org.sami.spn.phase.PhaseProgress.Status;
import org.sami.spn.phase.PhaseView;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Outcome;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;

/** The search of an area by aircraft: its phase chart is that of the thesis's Figures 5.7 to 5.10, and simulated aircraft fly it to its end. */
class SearchPlanTest {
    private static final Plan PLAN = UavSession.DOMAIN
            .projectOf("search")
            .flatMap(project -> project.plan("search"))
            .orElseThrow();
    private static final PhaseChart CHART = PhaseChart.of(PLAN, UavSession.DOMAIN.vocabulary());
    private static final GeoPoint MEADOW = new GeoPoint(45.601, 10.68, 40);
    private static final GeoPoint WOOD = new GeoPoint(45.602, 10.681, 40);
    private static final GeoPoint SUMMIT = new GeoPoint(45.602, 10.682, 400);

    private final SimulatedUav kite = new SimulatedUav(45.6, 10.68);
    private final SimulatedUav gull = new SimulatedUav(45.6, 10.6801);
    private final UavSession session = new UavSession(inOrder());

    private Map<String, SimulatedUav> inOrder() {
        Map<String, SimulatedUav> aircraft = new LinkedHashMap<>();
        aircraft.put("kite", kite);
        aircraft.put("gull", gull);
        return aircraft;
    }

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
        assertThat(buttons("search-there")).containsExactly("Target seen", "Nothing seen", "It is lost");
        assertThat(buttons("ask-target")).containsExactly("Yes", "No");
        assertThat(buttons("ask-retry")).containsExactly("Allocate anew", "Leave it out");

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
        assertThat(boxes(cannot)).contains("UAV 1 It cannot", "OPERATOR 2 Not reached", "OPERATOR 3 Leave it out");
        assertThat(CHART.view("Task execution", Map.of("fly-there", "lost-flying-event"))
                        .next())
                .containsExactly("Task assignment");
    }

    @Test
    void aircraftSearchTheirLocationsOneAfterAnotherAndReturn() {
        PhaseProgress progress = new PhaseProgress(CHART, PLAN, 1);
        session.follow(progress);
        session.flight().addTarget(new GeoPoint(WOOD.latDeg() + 0.0001, WOOD.lonDeg(), 0));
        begin(MEADOW, WOOD, new GeoPoint(45.601, 10.681, 40));
        assertThat(progress.status("ask-choice")).isEqualTo(Status.ACTIVE);
        session.answer(new Answer.Option(0));
        assertThat(progress.taken()).containsEntry("ask-choice", "accepted-event");
        session.fly(140);

        assertThat(session.decisions())
                .singleElement()
                .extracting(decision -> decision.question())
                .isEqualTo(new Question.Approve());
        assertThat(progress.status("ask-target")).isEqualTo(Status.ACTIVE);
        assertThat(progress.status("say-target")).isEqualTo(Status.AHEAD);
        session.answer(new Answer.YesNo(true));
        session.fly(120);

        assertThat(session.outcomes()).containsExactly(Outcome.ENDED);
        assertThat(progress.executions("fly-there")).isEqualTo(1);
        assertThat(progress.executions("search-there")).isEqualTo(3);
        assertThat(CHART.actions())
                .filteredOn(action -> !action.branch() && !"ask-retry".equals(action.id()))
                .allMatch(action -> progress.status(action.id()) == Status.DONE);
        assertThat(kite.position()).isEqualTo(new GeoPoint(45.6, 10.68, 0));
        assertThat(gull.position()).isEqualTo(new GeoPoint(45.6, 10.6801, 0));
    }

    @Test
    void locationAboveTheCeilingIsLeftOutWhenTheOperatorSaysSo() {
        begin(SUMMIT, MEADOW);
        session.answer(new Answer.Option(0));
        session.answer(new Answer.YesNo(false));
        session.fly(200);

        assertThat(session.outcomes()).containsExactly(Outcome.ENDED);
    }

    @Test
    void taskOfAnAircraftThatIsDroppedIsAllocatedToAnother() {
        begin(MEADOW, WOOD);
        session.answer(new Answer.Option(0));
        session.fly(5);
        session.post(new Input.ProxyDropped("gull", Ids.NONE));
        session.answer(new Answer.Option(0));
        session.fly(250);

        assertThat(session.outcomes()).containsExactly(Outcome.ENDED);
        assertThat(session.effects())
                .filteredOn(Effect.TasksAllocated.class::isInstance)
                .hasSize(3);
    }

    private void begin(GeoPoint... locations) {
        session.start("search", Map.of());
        session.answer(new Answer.Fields(Map.of()));
        List<Value> points = List.of(locations);
        session.answer(new Answer.Fields(Map.of("locations", new ListValue(points))));
    }
}
