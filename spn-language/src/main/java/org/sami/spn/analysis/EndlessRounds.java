package org.sami.spn.analysis;

import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.analysis.PlanContext.PlacedOutput;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventFlag;

/**
 * A task whose command is carried out comes to an end when all goes well, where a way leads to an end at all: a round that only a failure
 * leaves is probably a loop that leads too far back. Robots without a task may go round by intention: to keep a station, to patrol.
 */
final class EndlessRounds implements PlanCheck {
    private static final Set<TokenType> TASKS = EnumSet.of(TokenType.TASK);

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                "W-GOES-ROUND",
                "The tasks are done again and again: the mission ends only when something fails.",
                "Lead one transition of the round to a place on the way to the end."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        Set<String> told = new HashSet<>();
        for (PlacedOutput output : plan.outputs()) {
            Place place = output.place();
            if (output.type().flags().contains(EventFlag.COMMAND)
                    && plan.flow().at(place).contains(TokenType.TASK)
                    && plan.parents().isEmpty()
                    && !told.contains(place.id())) {
                Set<String> well = plan.flow().reached(Set.of(place.id()), TASKS, t -> !isFailure(plan, t));
                if (well.contains(place.id())
                        && !ends(plan, well)
                        && ends(plan, plan.flow().reached(Set.of(place.id()), TASKS, t -> true))) {
                    told.addAll(well);
                    report.accept(Finding.warning(
                            "W-GOES-ROUND",
                            plan.at(place),
                            "Tasks in the " + plan.name(place) + " return there forever, unless"
                                    + " something fails: lead a transition of the round on to the end",
                            place.id()));
                }
            }
        }
    }

    private static boolean isFailure(PlanContext plan, Transition t) {
        return plan.inputsOf(t).stream().anyMatch(i -> i.type().flags().contains(EventFlag.FAILURE));
    }

    private static boolean ends(PlanContext plan, Set<String> places) {
        return plan.plan().places().stream().anyMatch(p -> p.end() && places.contains(p.id()));
    }
}
