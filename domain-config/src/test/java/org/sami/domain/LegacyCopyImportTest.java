package org.sami.domain;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.legacy.CountedKind;
import org.sami.spn.legacy.LegacyImport;
import org.sami.spn.model.MissionTreeNode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.value.PlanReference;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** Copies of plans in an export become references, where nothing is lost by it. */
class LegacyCopyImportTest extends LegacyImportFixture {
    private void copyWith(String copiesVariable, String copiesSecondVariable) {
        document.plan("p1", "Parent").place("start").runs("p2", false);
        document.plan("p2", "x.Child")
                .instance("p1")
                .place("start", assemble(copiesVariable))
                .transition("t", response(copiesSecondVariable))
                .in("start", "t", "None - 0");
        document.plan("p3", "Child")
                .place("start", assemble("@goal"))
                .transition("t", response("@found"))
                .in("start", "t", "None - 0");
    }

    private static String assemble(String variable) {
        return output(
                "crw.event.output.service.AssembleLocationRequest",
                "'readVariables': {'assemblyLocation': '" + variable
                        + "'}, 'fieldValues': {'spacing': {'type': 'double', 'value': 3.0}}");
    }

    private static String response(String variable) {
        return event(
                "crw.event.input.service.AssembleLocationResponse",
                "input",
                "'writeVariables': {'proxyPoints': '" + variable + "'}");
    }

    @Test
    void aTrueCopyBecomesAReferenceWithItsVariables() {
        copyWith("@x.goal", "@x.found");

        LegacyImport.Result result = result();

        Project project = result.project().orElseThrow();
        assertThat(project.plans()).extracting(Plan::id).containsExactly("p1", "p3");
        assertThat(project.plans().get(0).places().get(0).subMissions())
                .singleElement()
                .satisfies(s -> {
                    assertThat(s.plan()).isEqualTo("p3");
                    assertThat(s.variables()).isEqualTo(Map.of("@goal", "@x.goal", "@found", "@x.found"));
                });
        assertThat(project.plans().get(0).variables())
                .extracting(VariableSpec::name)
                .containsExactlyInAnyOrder("@x.goal", "@x.found");
        assertThat(result.explained().of(CountedKind.PLANS)).isEqualTo(1);
        assertThat(codes(result)).contains("N-COPY-FOLDED");
        assertThat(project.missionTree().get(0).children())
                .extracting(MissionTreeNode::plan)
                .containsExactly(java.util.Optional.of("p1"), java.util.Optional.of("p3"));
    }

    @Test
    void aCopyThatWasChangedStaysAPlanOfItsOwn() {
        copyWith("@x.goal", "@x.found");
        ((ObjectNode) document.root.at("/plans/1/vertices/0")).put("name", "Changed");

        LegacyImport.Result result = result();

        assertThat(result.project().orElseThrow().plans()).hasSize(3);
        assertThat(codes(result)).contains("N-COPY-KEPT");
    }

    @Test
    void aCopyInWhichTwoVariablesAreOneIsNoTrueCopy() {
        copyWith("@x.found", "@x.found");

        assertThat(result().project().orElseThrow().plans()).hasSize(3);
    }

    private static String check(String subMission) {
        return event(
                "sami.event.CheckReturn",
                "input",
                "'fieldValues': {'variableValue': {'type': 'string', 'value': 'done'}, 'subMission': " + subMission
                        + "}");
    }

    private static String planRef(String plan) {
        return "{'type': 'plan-ref', 'plan': '" + plan + "', 'planName': 'x.Child'}";
    }

    private void checkedParent(String subMission) {
        document.plan("p1", "Parent")
                .place("start")
                .runs("p2", false)
                .transition("t", check(subMission))
                .in("start", "t", "None - 0");
        document.plan("p2", "x.Child").instance("p1").place("start", returned("done"));
        document.plan("p3", "Child").place("start", returned("done"));
    }

    private static String returned(String value) {
        return output(
                "sami.event.ReturnValue", "'fieldValues': {'value': {'type': 'string', 'value': '" + value + "'}}");
    }

    private static Map<String, Value> checkedFields(LegacyImport.Result result) {
        return result.project()
                .orElseThrow()
                .plans()
                .get(0)
                .transitions()
                .get(0)
                .inputs()
                .get(0)
                .fields();
    }

    @Test
    void aCheckOfAReturnValueNamesThePlanThatRunsInsteadOfTheCopy() {
        checkedParent(planRef("p2"));

        LegacyImport.Result result = result();

        assertThat(checkedFields(result))
                .isEqualTo(Map.of("value", new TextValue("done"), "subMission", new PlanReference("p3")));
        assertThat(codes(result)).containsExactly("N-COPY-FOLDED");
    }

    @Test
    void aCheckOfAReturnValueNamesTheCopyThatStaysAPlanOfItsOwn() {
        checkedParent(planRef("p2"));
        ((ObjectNode) document.root.at("/plans/1/vertices/0")).put("name", "Changed");

        assertThat(checkedFields(result()))
                .isEqualTo(Map.of("value", new TextValue("done"), "subMission", new PlanReference("p2")));
    }

    @Test
    void aCheckOfAReturnValueWithoutASubMissionNamesNone() {
        checkedParent("null");

        LegacyImport.Result result = result();

        assertThat(checkedFields(result)).isEqualTo(Map.of("value", new TextValue("done")));
        assertThat(codes(result)).containsExactly("N-COPY-FOLDED");
    }

    @Test
    void aCheckOfAReturnValueOfAPlanThatIsNotThereNamesNoneAndSaysSo() {
        checkedParent(planRef("p9"));

        LegacyImport.Result result = result();

        assertThat(checkedFields(result)).isEqualTo(Map.of("value", new TextValue("done")));
        assertThat(codes(result)).containsExactlyInAnyOrder("N-COPY-FOLDED", "W-VALUE");
    }
}
