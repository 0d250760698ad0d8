package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.edit.VertexEdit;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.Place;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.EventFlag;

/**
 * A mission of several robots or tasks does not end when the first of them is done, while the others are out. That it ends when the first
 * fails may be what its author wants.
 */
final class EndsWithFirst implements PlanCheck {
    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-ENDS-WITH-FIRST",
                "The others are left where they are, with their work undone, as soon as the first is back.",
                "Let the transition before the end also ask for none (= 0) in the places where others may "
                        + "still be."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        for (Transition t : plan.plan().transitions()) {
            List<Place> ends = plan.outPlaces(t).stream()
                    .filter(place -> place.end() && ends(plan, place))
                    .toList();
            boolean fails = plan.inputsOf(t).stream()
                    .anyMatch(input -> input.type().flags().contains(EventFlag.FAILURE));
            if (!ends.isEmpty() && !fails && plan.inEdges(t).stream().noneMatch(EndsWithFirst::waitsForAbsence)) {
                check(plan, t, ends.get(0), report);
            }
        }
    }

    /** Whether the mission is over when a place is entered: of an instance that several share only where the place says so. */
    private static boolean ends(PlanContext plan, Place place) {
        return place.endsSharedInstance()
                || plan.parents().stream()
                        .flatMap(VariableScope::subMissions)
                        .filter(s -> s.plan().equals(plan.plan().id()))
                        .noneMatch(SubMissionSpec::shared);
    }

    private static boolean waitsForAbsence(InEdge edge) {
        return edge.requirements().stream().anyMatch(InRequirement::asksForNone);
    }

    private static void check(PlanContext plan, Transition t, Place end, Consumer<Finding> report) {
        List<Place> from = SingleAnswers.from(plan, t);
        if (!from.isEmpty()) {
            Place place = from.get(0);
            report.accept(Finding.warning(
                            "W-ENDS-WITH-FIRST",
                            plan.at(t),
                            plan.transitionName(t.id()) + " ends the mission at the " + plan.name(end)
                                    + " as soon as the first in the " + plan.name(place)
                                    + " answers, while others may be on their way. Lead it into a place of those who"
                                    + " have finished, and end when none is left, or wait for all",
                            t.id(),
                            end.id())
                    .fixedBy(
                            "Wait until all have answered",
                            new VertexEdit.SetWaitFor(plan.plan().id(), t.id(), WaitFor.ALL)));
        } else if (t.inputs().isEmpty()) {
            gathered(plan, t, end, report);
        }
    }

    /** A transition without event that asks for at least 1 in a place into which each comes by itself. */
    private static void gathered(PlanContext plan, Transition t, Place end, Consumer<Finding> report) {
        for (InEdge edge : plan.inEdges(t)) {
            for (InRequirement r : edge.requirements()) {
                Set<TokenType> kinds = TokenType.of(r.kind());
                boolean wants = r.match() == Match.AT_LEAST
                        && (kinds.contains(TokenType.PROXY) || kinds.contains(TokenType.TASK));
                List<Place> before = wants ? SingleAnswers.comeSinglyFrom(plan, edge.place()) : List.of();
                if (!before.isEmpty()
                        && plan.place(edge.place())
                                .filter(p -> p.subMissions().isEmpty())
                                .isPresent()) {
                    report.accept(ForgottenPlaces.askingForNone(
                            plan,
                            t,
                            before,
                            kinds,
                            Finding.warning(
                                    "W-ENDS-WITH-FIRST",
                                    plan.at(t),
                                    plan.transitionName(t.id()) + " ends the mission at the " + plan.name(end)
                                            + " as soon as the first is in the " + plan.placeName(edge.place())
                                            + ", while others may be in the " + plan.name(before.get(0))
                                            + ". Ask for none left (= 0) in each place where somebody may still be",
                                    t.id(),
                                    end.id())));
                    return;
                }
            }
        }
    }
}
