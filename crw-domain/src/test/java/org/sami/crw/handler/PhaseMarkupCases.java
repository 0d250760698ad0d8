package org.sami.crw.handler;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.sami.spn.phase.PhaseAction;
import org.sami.spn.phase.PhaseChart;
import org.sami.spn.value.TextValue;

/** What markups do to the phase chart (thesis 5.2.3). */
final class PhaseMarkupCases {
    private static final List<String> ACTORS = List.of("OPERATOR", "SAMI", "PROXY", "TASK");

    private PhaseMarkupCases() {}

    static void add(MarkupCatalogue catalogue) {
        catalogue.shows("PhaseItem.phaseName", "the action is a box of that phase", () -> {
            PhaseChart chart = chart(asked("OPERATOR"));
            assertThat(chart.phases()).containsExactly("Preparation");
            assertThat(chart.actions()).extracting(PhaseAction::phase).containsExactly("Preparation");
        });
        for (String actor : ACTORS) {
            catalogue.shows("PhaseItem.actor=" + actor, "the action stands in the actor's row", () -> {
                assertThat(chart(asked(actor)).actions())
                        .extracting(PhaseAction::actor)
                        .containsExactly(actor);
            });
            catalogue.shows("PhaseBranch.actor=" + actor, "the option stands in the actor's row", () -> {
                assertThat(branches(branching("Go", actor, "")))
                        .extracting(PhaseAction::actor)
                        .containsExactly(actor);
            });
        }
        catalogue.shows("PhaseBranch.actionName", "the action before it has a button with that text", () -> {
            PhaseChart chart = chart(branching("Go now", "OPERATOR", ""));
            PhaseAction before = chart.actions().get(0);
            assertThat(chart.options(before.id()))
                    .extracting(PhaseAction::label)
                    .containsExactly("Go now");
        });
        catalogue.shows(
                "PhaseBranch.phaseName", "the option belongs to that phase, else to that of the action before", () -> {
                    assertThat(branches(branching("Go", "OPERATOR", "")))
                            .extracting(PhaseAction::phase)
                            .containsExactly("Preparation");
                    assertThat(branches(branching("Go", "OPERATOR", "Execution")))
                            .extracting(PhaseAction::phase)
                            .containsExactly("Execution");
                });
    }

    private static PlanSketch asked(String actor) {
        return new PlanSketch()
                .asks("asking", "OperatorApprove", "question", new TextValue("Go?"))
                .marked("PhaseItem", "phaseName", new TextValue("Preparation"), "actor", actor);
    }

    private static PlanSketch branching(String action, String actor, String phase) {
        PlanSketch plan = asked("OPERATOR").on("asking", "YesOption", "going");
        return phase.isEmpty()
                ? plan.marked("PhaseBranch", "actionName", new TextValue(action), "actor", actor)
                : plan.marked(
                        "PhaseBranch",
                        "actionName",
                        new TextValue(action),
                        "phaseName",
                        new TextValue(phase),
                        "actor",
                        actor);
    }

    private static List<PhaseAction> branches(PlanSketch plan) {
        return chart(plan).actions().stream().filter(PhaseAction::branch).toList();
    }

    private static PhaseChart chart(PlanSketch plan) {
        return PhaseChart.of(plan.project().plans().get(0), TestWorld.VOCABULARY);
    }
}
