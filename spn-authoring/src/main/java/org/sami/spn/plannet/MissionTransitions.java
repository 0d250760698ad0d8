package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;

/** The transitions of a mission and of its sub-missions that are followed. The places of all of them are made before the first transition. For one use. */
final class MissionTransitions {
    private final PlanNetWork work;
    private final Map<Transition, List<CaseArcs>> conditions = new LinkedHashMap<>();
    private final List<MissionTransitions> children = new ArrayList<>();

    MissionTransitions(PlanNetWork work, AbstractionList abstractions) {
        this.work = work;
        Plan plan = work.plan();
        InConditions in = new InConditions(work.places(), work.possible(), abstractions);
        boolean startsAtFirst = plan.startPlace()
                .filter(start -> work.places().startsWith(start.id()))
                .isPresent();
        for (Transition t : plan.transitions()) {
            conditions.put(t, in.of(t, plan.inEdgesOf(t.id())));
            boolean atStart = startsAtFirst
                    && plan.inEdgesOf(t.id()).stream()
                            .anyMatch(edge -> plan.place(edge.place())
                                    .filter(Place::start)
                                    .isPresent());
            if (TransitionLooks.mayFireLater(plan, work.possible(), work.vocabulary(), t)) {
                work.places().addHeard(t.id(), atStart);
            }
            if (t.inputs().isEmpty() && !TransitionLooks.looksAgain(plan, work.possible(), t)) {
                work.places().addOccasion(t.id(), atStart);
            }
        }
        work.missions().forEach(child -> children.add(new MissionTransitions(child, abstractions)));
        new AbstractionsOfPlan(work, abstractions).list();
    }

    /** The cases of the plan's own transitions, as they are where no sub-mission is followed. */
    Map<Transition, TransitionCases> ofPlan() {
        Map<Transition, TransitionCases> cases = new LinkedHashMap<>();
        conditions.forEach((t, alternatives) -> {
            if (isPlain(t)) {
                cases.put(t, new TransitionCases(work, t, alternatives, Map.of()));
            }
        });
        return cases;
    }

    private boolean isPlain(Transition t) {
        return SubMissionCases.modes(work, t).equals(List.of(Map.of()));
    }

    /** Adds the transitions for which it matters how sub-missions are, and those of the sub-missions. */
    void addOfChildren() throws PlanNetTooLargeException {
        for (Map.Entry<Transition, List<CaseArcs>> each : conditions.entrySet()) {
            if (!isPlain(each.getKey())) {
                for (Map<String, SubMode> modes : SubMissionCases.modes(work, each.getKey())) {
                    new TransitionCases(work, each.getKey(), each.getValue(), modes).add(Optional.empty());
                }
            }
        }
        for (MissionTransitions child : children) {
            for (TransitionCases each : child.ofPlan().values()) {
                each.add(Optional.empty());
            }
            child.addOfChildren();
        }
    }
}
