package org.sami.dreamm.compare;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sami.picture.net.NetChange;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.edit.Edit;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Mode;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;

class PlanComparisonTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Project PROJECT = DOMAIN.combined();
    private static final Plan CLV = PROJECT.plan("clv").orElseThrow();

    private static PlanComparison after(Edit... edits) {
        Project project = PROJECT;
        for (Edit edit : edits) {
            project = edit.apply(project, DOMAIN.vocabulary()).project().orElseThrow();
        }
        return PlanComparison.of(CLV, project.plan("clv").orElseThrow(), DOMAIN.vocabulary());
    }

    private static List<String> texts(PlanComparison comparison) {
        return comparison.differences().stream().map(Difference::text).toList();
    }

    @Test
    void equalVersionsDifferInNothing() {
        assertThat(after().isEmpty()).isTrue();
    }

    @Test
    void whatIsNewIsMarkedAndSaid() {
        PlanComparison comparison = after(
                VertexEdit.AddPlace.blank("clv", "wait", Mode.NOMINAL, new LayoutPoint(0, 0)),
                new EdgeEdit.Connect("clv", CLV.transitions().get(0).id(), "wait", Mode.NOMINAL));

        assertThat(comparison.changes()).containsEntry("wait", NetChange.ADDED).hasSize(2);
        assertThat(texts(comparison)).anyMatch(text -> text.equals("The place 13 is new"));
    }

    @Test
    void whatIsGoneLiesWhereItWasWithItsEdges() {
        PlanComparison comparison = after(new RemoveElements("clv", Set.of("execute")));

        assertThat(comparison.changes()).containsEntry("execute", NetChange.REMOVED);
        assertThat(comparison.both().place("execute")).isPresent();
        assertThat(comparison.both().layout())
                .containsEntry("execute", CLV.layout().get("execute"));
        assertThat(comparison.both().inEdges()).hasSameSizeAs(CLV.inEdges());
        assertThat(comparison.both().outEdges()).hasSameSizeAs(CLV.outEdges());
        assertThat(texts(comparison)).contains("The place \"Execute paths\" is gone");
    }

    @Test
    void anotherEventMarksItsVertexAndIsNamed() {
        PlanComparison comparison = after(new RemoveElements("clv", Set.of("ask-boats")));

        assertThat(comparison.changes()).containsExactly(Map.entry("select", NetChange.CHANGED));
        assertThat(texts(comparison))
                .anyMatch(text ->
                        text.startsWith("The place \"Select boats\": the output event ") && text.endsWith(" is gone"));
    }

    @Test
    void anotherRequirementIsSaidInTheWordsOfTheNet() {
        String edge = CLV.inEdges().get(0).id();

        PlanComparison comparison =
                after(new EdgeEdit.SetInRequirements("clv", edge, List.of(InRequirement.unconditional())));

        assertThat(comparison.changes()).containsEntry(edge, NetChange.CHANGED);
        assertThat(texts(comparison)).singleElement().asString().contains("requires No Condition, before ");
    }

    @Test
    void whatOnlyLiesElsewhereIsOneLineAndNoMark() {
        PlanComparison comparison = after(new VertexEdit.MoveVertices(
                "clv", Map.of("select", new LayoutPoint(1, 2), "locations", new LayoutPoint(3, 4))));

        assertThat(comparison.changes()).isEmpty();
        assertThat(texts(comparison)).containsExactly("2 vertices lie elsewhere");
    }

    @Test
    void anIdThatIsAnotherKindOfVertexNowIsBothGoneAndNew() {
        PlanComparison comparison = after(
                new RemoveElements("clv", Set.of("execute")),
                new VertexEdit.AddTransition(
                        "clv",
                        new Transition("execute", "", Mode.NOMINAL, WaitFor.EACH, List.of()),
                        Optional.of(new LayoutPoint(0, 0))));

        assertThat(comparison.changes())
                .containsEntry("execute", NetChange.ADDED)
                .containsEntry("execute before", NetChange.REMOVED);
        assertThat(comparison.both().place("execute before")).isPresent();
    }
}
