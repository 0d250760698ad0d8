package org.sami.spn.analysis;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.edit.RenameElement;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/** Findings speak of vertices and events as people do, also where the author gave no names. */
class FindingWordsTest {
    private static final String ID = "zz";

    static List<PlanCheckCase> cases() {
        return PlanCheckCases.all().stream()
                .filter(c -> !c.code().equals("E-DANGLING")) // renaming its edge's missing vertex would make it sound
                .toList();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void noFindingAboutVerticesWithoutNamesSpeaksOfAnId(PlanCheckCase c) {
        Project nameless = nameless(c.bad(), c.words());

        List<Finding> findings = PlanChecks.check(nameless, c.words());

        assertThat(findings).extracting(Finding::code).contains(c.code());
        assertThat(findings).allSatisfy(finding -> {
            assertThat(finding.message()).doesNotContain(ID);
            assertThat(finding.fixes())
                    .allSatisfy(fix -> assertThat(fix.label()).doesNotContain(ID));
        });
    }

    /** The same with ids that mean nothing, as far as what is wrong with it lets them be changed, and without names of vertices. */
    private static Project nameless(Project project, Vocabulary vocabulary) {
        Project renamed = project;
        int number = 0;
        for (Plan plan : project.plans()) {
            for (String id : ids(plan)) {
                renamed = new RenameElement(plan.id(), id, ID + number++)
                        .apply(renamed, vocabulary)
                        .project()
                        .orElse(renamed);
            }
        }
        return renamed.withPlans(renamed.plans().stream()
                .map(plan -> plan.withPlaces(plan.places().stream()
                                .map(place -> place.withName(""))
                                .toList())
                        .withTransitions(plan.transitions().stream()
                                .map(transition -> transition.withName(""))
                                .toList()))
                .toList());
    }

    private static List<String> ids(Plan plan) {
        List<String> ids = new ArrayList<>();
        plan.places().stream().map(Place::id).forEach(ids::add);
        plan.transitions().stream().map(Transition::id).forEach(ids::add);
        plan.inEdges().stream().map(InEdge::id).forEach(ids::add);
        plan.outEdges().stream().map(OutEdge::id).forEach(ids::add);
        plan.places().forEach(place -> {
            place.outputs().stream().map(OutputEventSpec::id).forEach(ids::add);
            place.subMissions().stream().map(SubMissionSpec::id).forEach(ids::add);
        });
        plan.transitions()
                .forEach(transition ->
                        transition.inputs().stream().map(InputEventSpec::id).forEach(ids::add));
        return ids;
    }
}
