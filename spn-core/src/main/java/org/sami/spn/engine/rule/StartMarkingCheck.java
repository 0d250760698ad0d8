package org.sami.spn.engine.rule;

import java.util.HashSet;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.StartMarking;

/** Whether a plan can start with a marking: its places are there and not end places, its robots are known, its tasks are the plan's. */
final class StartMarkingCheck {
    private StartMarkingCheck() {}

    /** Why a plan cannot start with a marking, in one sentence; empty where it can. */
    static Optional<String> problem(StartMarking marking, Plan plan, Set<String> known) {
        Set<String> seen = new HashSet<>();
        for (StartMarking.Tokens at : marking.places()) {
            Optional<Place> place = plan.place(at.place());
            if (place.isEmpty()) {
                return Optional.of("The plan '" + plan.name() + "' has no place '" + at.place() + "'");
            }
            if (place.get().end()) {
                return Optional.of("'" + at.place() + "' is an end place: a mission that stands there is over");
            }
            if (!seen.add(at.place())) {
                return Optional.of("The place '" + at.place() + "' is named twice in the start marking");
            }
            Optional<String> problem = problem(at, plan, known);
            if (problem.isPresent()) {
                return problem;
            }
        }
        return marking.places().isEmpty() ? Optional.of("The start marking names no place") : Optional.empty();
    }

    private static Optional<String> problem(StartMarking.Tokens at, Plan plan, Set<String> known) {
        for (String proxy : at.proxies()) {
            if (!known.contains(proxy)) {
                return Optional.of("No robot '" + proxy + "' is known that could stand in '" + at.place() + "'");
            }
        }
        for (String task : at.tasks()) {
            if (plan.tasks().stream().noneMatch(t -> t.name().equals(task))) {
                return Optional.of("The plan '" + plan.name() + "' has no task '" + task + "' that could stand in '"
                        + at.place() + "'");
            }
        }
        return Optional.empty();
    }
}
