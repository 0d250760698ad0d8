package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;

/** What a transition with input events needs to listen to them. */
final class WakenedCases {
    private final PlanNetWork work;
    private final Transition t;
    private final List<InEdge> ins;

    WakenedCases(PlanNetWork work, Transition t) {
        this.work = work;
        this.t = t;
        ins = work.plan().inEdgesOf(t.id());
    }

    /**
     * A transition with input events listens only while one of its in places is marked, or visited by nobody; its answer ends that visit. What came then may wait, and let
     * it fire when all are gone.
     */
    List<CaseArcs> of(CaseArcs arcs) {
        if (t.inputs().isEmpty() || ins.isEmpty() || comesDirectly()) {
            return List.of(arcs);
        }
        List<CaseArcs> awake = new ArrayList<>();
        List<String> inPlaces = ins.stream().map(InEdge::place).distinct().toList();
        boolean isAwake = inPlaces.stream()
                .anyMatch(place -> work.places().allIn(place).stream().anyMatch(arcs::needs));
        if (isAwake) {
            awake.add(arcs);
        }
        if (!isAwake) {
            work.places().heard(t.id()).ifPresent(heard -> {
                CaseArcs before = arcs.copy();
                before.atLeast(heard, 1);
                awake.add(before);
            });
        }
        for (String place : inPlaces) {
            if (!isAwake) {
                for (int at : work.places().in(place).values()) {
                    CaseArcs more = arcs.copy();
                    more.atLeast(at, 1);
                    awake.add(more);
                }
            }
            work.places().nobody(place).ifPresent(nobody -> {
                boolean asks = asks(place);
                if (!isAwake && !(asks && !mayBeNews())) {
                    CaseArcs more = arcs.copy();
                    more.atLeast(nobody, 1);
                    awake.add(more);
                }
                if (asks) {
                    CaseArcs more = arcs.copy();
                    more.remove(nobody, 1);
                    awake.add(more);
                }
            });
        }
        return awake;
    }

    /** Whether an event of a place asks for one of its input events. */
    private boolean asks(String place) {
        return work.plan().place(place).stream()
                .flatMap(p -> p.outputs().stream())
                .flatMap(output -> work.vocabulary().event(output.type()).stream())
                .anyMatch(type ->
                        t.inputs().stream().anyMatch(input -> type.answers().contains(input.type())));
    }

    private boolean mayBeNews() {
        return t.inputs().stream()
                .anyMatch(input -> work.vocabulary()
                        .event(input.type())
                        .filter(type -> type.flags().contains(EventFlag.NEWS))
                        .isPresent());
    }

    /** Whether an input event comes to it directly, wherever tokens are. */
    private boolean comesDirectly() {
        return t.inputs().stream()
                .flatMap(input -> work.vocabulary().event(input.type()).stream())
                .anyMatch(
                        type -> type.role() == EventRole.SUB_MISSION_ABORTED || type.role() == EventRole.CHECK_RETURN);
    }
}
