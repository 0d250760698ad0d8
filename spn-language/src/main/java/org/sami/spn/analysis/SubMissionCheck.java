package org.sami.spn.analysis;

import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.edit.RemoveElements;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** Sub-missions exist, do not contain themselves, and can come to an end where somebody waits for it (thesis 3.1). */
final class SubMissionCheck implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(
                new Advice(
                        "E-UNKNOWN-PLAN",
                        "There is no such plan in the project: the sub-mission cannot begin.",
                        "Correct the id, or add the plan to the project."),
                new Advice(
                        "E-RECURSION",
                        "The sub-mission would start itself without end.",
                        "Take the sub-mission out of the plan that it leads back to."),
                new Advice(
                        "W-SUB-MISSION-ENDLESS",
                        "The sub-mission never ends by itself: what waits for its end waits forever.",
                        "Give the plan of the sub-mission an end that can be reached, or abort it from here."),
                new Advice(
                        "W-SHARED-AT-START",
                        "The shared sub-mission gets every token as the mission begins, also those that it is not "
                                + "meant for.",
                        "Put the sub-mission on a place after the start."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Place place : plan.plan().places()) {
            for (int i = 0; i < place.subMissions().size(); i++) {
                check(plan, place, place.subMissions().get(i), plan.at(place) + "/subMissions/" + i, report);
            }
            if (place.start() && place.subMissions().stream().anyMatch(SubMissionSpec::shared)) {
                report.accept(Finding.warning(
                        "W-SHARED-AT-START",
                        plan.at(place),
                        "A shared sub-mission on the start " + plan.name(place) + " gets every token there is",
                        place.id()));
            }
        }
    }

    private static void check(
            PlanContext plan, Place place, SubMissionSpec s, String pointer, Consumer<Finding> report) {
        Optional<Plan> child = plan.child(s);
        if (child.isEmpty()) {
            Finding finding = Finding.error(
                    "E-UNKNOWN-PLAN",
                    pointer,
                    "The " + plan.name(place) + " runs the plan \"" + s.plan() + "\", which is not there",
                    s.id());
            report.accept(
                    plan.outTransitions(place).stream().anyMatch(t -> movesSubMissionTokens(plan, t))
                            ? finding
                            : finding.fixedBy(
                                    "Run nothing there",
                                    new RemoveElements(plan.plan().id(), Set.of(s.id()))));
            return;
        }
        if (contains(plan, child.get(), plan.plan().id(), new HashSet<>())) {
            report.accept(Finding.error(
                    "E-RECURSION",
                    pointer,
                    "The " + plan.name(place) + " runs \"" + plan.title(s) + "\", which runs \""
                            + plan.plan().title() + "\" again, without end",
                    s.id()));
        }
        List<Place> ends = child.get().places().stream().filter(Place::end).toList();
        if (ends.isEmpty() && !plan.outTransitions(place).isEmpty()) {
            report.accept(Finding.warning(
                    "W-SUB-MISSION-ENDLESS",
                    pointer,
                    "Transitions after the " + plan.name(place) + " wait for the end of \"" + plan.title(s)
                            + "\", which has no end place",
                    s.id()));
        }
    }

    private static boolean contains(PlanContext plan, Plan child, String wanted, Set<String> seen) {
        if (child.id().equals(wanted)) {
            return true;
        }
        return seen.add(child.id())
                && VariableScope.subMissions(child)
                        .map(plan::child)
                        .flatMap(Optional::stream)
                        .anyMatch(grandchild -> contains(plan, grandchild, wanted, seen));
    }

    private static boolean movesSubMissionTokens(PlanContext plan, Transition t) {
        return plan.outEdges(t).stream()
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS);
    }
}
