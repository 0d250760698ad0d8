package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.EditHistory;
import org.sami.spn.edit.EditResult;
import org.sami.spn.edit.FieldEdit;
import org.sami.spn.edit.PlanBuilder;
import org.sami.spn.edit.VariableEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.ValueType;
import org.sami.spn.wiring.DataSource;
import org.sami.spn.wiring.FieldProposal;
import org.sami.spn.wiring.ReachingData;
import org.sami.spn.wiring.SourceWords;
import org.sami.spn.wiring.Wires;
import org.sami.spn.wizard.AddEvent;
import org.sami.spn.wizard.EventTarget;

/** Which data reaches a field, and what an addition reads from where, with the events of the boats. */
class WiringTest {
    private static final DomainLibrary BOATS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final ValueType POINTS = new ValueType.ListOf(ValueType.Simple.POINT);

    private final EditHistory history = new EditHistory(
            new Project("project", "", "crw", List.of(), List.of(), List.of(new PlanBuilder("p").build())),
            BOATS.vocabulary(),
            100);

    private Plan plan() {
        return history.project().plans().get(0);
    }

    private EditResult.Done done(Edit edit) {
        EditResult result = history.apply(edit);
        assertThat(result).as("%s", result).isInstanceOf(EditResult.Done.class);
        return (EditResult.Done) result;
    }

    private EditResult.Done add(String event, EventTarget target) {
        return done(AddEvent.usual("p", event, target, Mode.NOMINAL, BOATS.authoring()));
    }

    private void first(String event) {
        add(event, new EventTarget.Free(Optional.of(new LayoutPoint(60, 200))));
    }

    private void behind(String answer, String event) {
        add(event, new EventTarget.OnVertex(placeBehind(answer)));
    }

    private String placeBehind(String answer) {
        String transition = plan().transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(answer)))
                .findFirst()
                .orElseThrow()
                .id();
        return plan().outEdgesOf(transition).get(0).place();
    }

    private OutputEventSpec output(String type) {
        return plan().places().stream()
                .flatMap(p -> p.outputs().stream())
                .filter(o -> o.type().equals(type))
                .findFirst()
                .orElseThrow();
    }

    private List<String> offered(String type, String field) {
        String place = plan().places().stream()
                .filter(p -> p.outputs().stream().anyMatch(o -> o.type().equals(type)))
                .findFirst()
                .orElseThrow()
                .id();
        return new ReachingData(history.project(), plan(), BOATS.vocabulary())
                        .of(
                                place,
                                BOATS.vocabulary()
                                        .event(type)
                                        .orElseThrow()
                                        .field(field)
                                        .orElseThrow())
                        .stream()
                        .map(s -> SourceWords.of(s, BOATS.vocabulary()))
                        .toList();
    }

    @Test
    void locationsOfTasksAreReadFromTheOperatorsAnswer() {
        first("OperatorCreateLocations");

        behind("OperatorCreatesLocations", "GenerateTasks");

        assertThat(output("GenerateTasks").fields())
                .containsEntry("locations", new FieldSource.FromVariable("@locations"))
                .doesNotContainKey("taskClass");
        assertThat(plan().variables()).containsExactly(new VariableSpec("@locations", POINTS, Optional.empty()));
        assertThat(plan().transitions().get(0).inputs().get(0).writes()).isEqualTo(Map.of("locations", "@locations"));
    }

    @Test
    void additionSaysFromWhereItReadsAndIsTakenBackAsOne() {
        first("OperatorCreateLocations");
        Plan before = plan();

        EditResult.Done done = add("GenerateTasks", new EventTarget.OnVertex(placeBehind("OperatorCreatesLocations")));

        assertThat(done.remarks())
                .contains("locations is read from Operator Creates Locations: locations, 1 step before");
        history.undo();
        assertThat(plan()).isEqualTo(before);
    }

    @Test
    void wholePanoramaPlanIsWiredByItsAdditions() {
        first("OperatorCreateLocations");
        behind("OperatorCreatesLocations", "GenerateTasks");
        behind("TasksGenerated", "AllocationRequest");
        behind("AllocationResponse", "OperatorAllocationOptions");
        behind("OperatorAcceptedAllocation", "ApplyAllocation");
        add("TaskStarted", new EventTarget.Behind(placeBehind("OperatorAcceptedAllocation")));
        behind("TaskStarted", "ProxyGotoLatLon");

        assertThat(output("AllocationRequest").fields()).isEmpty();
        assertThat(output("OperatorAllocationOptions").fields())
                .isEqualTo(Map.of("options", new FieldSource.FromVariable("@allocations")));
        assertThat(output("ApplyAllocation").fields())
                .isEqualTo(Map.of("allocation", new FieldSource.FromVariable("@allocation")));
        assertThat(output("ProxyGotoLatLon").fields()).isEqualTo(Map.of("location", new FieldSource.FromTask()));
    }

    @Test
    void nearestAnswerComesFirstAndVariablesThatNothingWroteLast() {
        first("OperatorCreateLocations");
        done(new VariableEdit.AddVariable(Optional.of("p"), new VariableSpec("@idle", POINTS, Optional.empty())));
        done(new VariableEdit.AddVariable(
                Optional.of("p"),
                new VariableSpec(
                        "@harbour", POINTS, Optional.of(new ListValue(List.of(new GeoPoint(43.6, -79.4, 0)))))));
        behind("OperatorCreatesLocations", "OperatorCreateLocations");
        String second = plan().transitions().get(1).inputs().get(0).id();
        done(new FieldEdit.SetWrite("p", second, "locations", "@later"));
        String last = plan().outEdgesOf(plan().transitions().get(1).id()).get(0).place();
        add("GenerateTasks", new EventTarget.OnVertex(last));

        assertThat(offered("GenerateTasks", "locations"))
                .containsExactly(
                        "Operator Creates Locations: locations (@later), 1 step before",
                        "Operator Creates Locations: locations, 2 steps before",
                        "@harbour, its first value",
                        "@idle, written by nothing before");
    }

    @Test
    void taskIsOfferedOnlyWhereATaskComesAndHasSuchAField() {
        first("OperatorCreateLocations");
        behind("OperatorCreatesLocations", "ProxyGotoLatLon");
        assertThat(offered("ProxyGotoLatLon", "location")).isEmpty();

        behind("ProxyPathCompleted", "GenerateTasks");
        behind("TasksGenerated", "TakeMeasurement");

        assertThat(offered("TakeMeasurement", "sensor")).noneMatch(s -> s.contains("@task"));
        behind("MeasurementTaken", "ProxyGotoLatLon");
        assertThat(plan().places().stream()
                        .flatMap(p -> p.outputs().stream())
                        .filter(o -> o.type().equals("ProxyGotoLatLon"))
                        .map(OutputEventSpec::fields))
                .containsExactly(Map.of(), Map.of("location", new FieldSource.FromTask()));
    }

    @Test
    void answerThatComesAfterwardsReachesNothing() {
        first("GenerateTasks");
        behind("TasksGenerated", "OperatorCreateLocations");

        assertThat(offered("GenerateTasks", "locations")).isEmpty();
    }

    @Test
    void textIsOfferedToAnyTextButProposedOnlyUnderItsName() {
        first("TakeMeasurement");
        behind("MeasurementFailed", "TakeMeasurement");
        String second = plan().places().stream()
                .filter(p -> p.id().equals(placeBehind("MeasurementFailed")))
                .findFirst()
                .orElseThrow()
                .outputs()
                .get(0)
                .id();

        List<FieldProposal> proposals = FieldProposal.of(history.project(), "p", second, BOATS.vocabulary(), Set.of());

        assertThat(proposals)
                .singleElement()
                .satisfies(p -> assertThat(p.sources()).hasSize(1))
                .satisfies(p -> assertThat(p.proposed()).isEmpty());
    }

    @Test
    void authorLeavesAFieldOpenOrChoosesAnotherSource() {
        first("OperatorCreateLocations");
        String place = placeBehind("OperatorCreatesLocations");
        AddEvent usual =
                AddEvent.usual("p", "GenerateTasks", new EventTarget.OnVertex(place), Mode.NOMINAL, BOATS.authoring());

        done(usual.withWires(Wires.PROPOSED.with("locations", Optional.empty())));
        assertThat(output("GenerateTasks").fields()).isEmpty();
        history.undo();

        done(new VariableEdit.AddVariable(
                Optional.of("p"), new VariableSpec("@harbour", POINTS, Optional.of(new ListValue(List.of())))));
        done(usual.withWires(Wires.PROPOSED.with(
                "locations",
                Optional.of(new DataSource.Variable("@harbour", DataSource.Origin.FIRST_VALUE, DataSource.FAR)))));
        assertThat(output("GenerateTasks").fields())
                .isEqualTo(Map.of("locations", new FieldSource.FromVariable("@harbour")));
    }
}
