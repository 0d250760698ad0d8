package org.sami.spn.analysis;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import org.sami.spn.edit.SetDisabled;
import org.sami.spn.finding.Advice;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.Place;
import org.sami.spn.model.Transition;

/** Disabled parts are left out only while the plan is tried: the operator who starts a mission is warned that they run there. */
final class DisabledForTrying implements PlanCheck {
    private static final String CODE = "W-DISABLED";

    @Override
    public List<Advice> advice() {
        return List.of(new Advice(
                CODE,
                "It is left out when the plan is tried, but a mission runs it: the mission does more than "
                        + "what was tried.",
                "Enable it again, or delete it."));
    }

    @Override
    public void check(PlanContext plan, Consumer<Finding> report) {
        String id = plan.plan().id();
        plan.plan().places().stream()
                .filter(Place::disabled)
                .forEach(place -> report.accept(Finding.warning(
                                CODE,
                                plan.at(place),
                                "The " + plan.name(place)
                                        + " is disabled while the plan is tried; a mission sends its events and starts"
                                        + " its sub-missions",
                                place.id())
                        .fixedBy("Enable it", new SetDisabled(id, Set.of(place.id()), false))));
        plan.plan().transitions().stream()
                .filter(Transition::disabled)
                .forEach(transition -> report.accept(Finding.warning(
                                CODE,
                                plan.at(transition),
                                "The " + plan.name(transition)
                                        + " is disabled while the plan is tried; in a mission it fires",
                                transition.id())
                        .fixedBy("Enable it", new SetDisabled(id, Set.of(transition.id()), false))));
    }
}
