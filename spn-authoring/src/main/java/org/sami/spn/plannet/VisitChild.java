package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A dynamic sub-mission that the net follows: one visit of its place at a time, from its start to what it brought back (R-SUB-1 to R-SUB-6). Where there may be more than
 * that, the place is left open until it is empty.
 */
final class VisitChild extends FollowedChild {
    private final boolean knowsReturns;
    /** The places of the net of which one is marked while somebody stands in the place. */
    private final List<Integer> visitors = new ArrayList<>();

    private final int complete;
    private final int unused;

    /**
     * A child that is ready to be followed.
     *
     * @param place of the parent's plan
     * @param mission the child's
     * @param robots each with a token of its own
     * @param loose the robots of which several may stand in the place: of these it is followed whether any do
     * @param knowsReturns whether the child can only bring back what was given to it, and all of it is taken at once
     */
    VisitChild(
            MissionPlaces parent,
            String place,
            ChildMission mission,
            List<PlanToken> robots,
            Set<PlanToken> loose,
            boolean knowsReturns) {
        super(parent, place, mission, knowsReturns ? robots : List.of());
        this.knowsReturns = knowsReturns;
        if (!loose.containsAll(parent.in(place).keySet())) {
            visitors.add(parent.counter(place, "visitors", token -> !loose.contains(token)));
        }
        parent.in(place).forEach((token, at) -> {
            if (loose.contains(token)) {
                visitors.add(at);
            }
        });
        complete = parent.control(place + ".complete", place + ": its sub-mission is complete", 0);
        unused = parent.control(place + ".unused", place + ": its completion is not used yet", 0);
    }

    /** Whether it is known what came back: all of it was there before. */
    boolean knowsReturns() {
        return knowsReturns;
    }

    @Override
    List<SubMode> modes() {
        return List.of(SubMode.VACANT, SubMode.COMPLETE, SubMode.OPEN);
    }

    @Override
    void suppose(SubMode mode, CaseArcs arcs) {
        switch (mode) {
            case VACANT -> {
                visitors.forEach(at -> arcs.below(at, 1));
                parent().nobody(place()).ifPresent(nobody -> arcs.below(nobody, 1));
            }
            case COMPLETE -> arcs.atLeast(complete, 1);
            default -> arcs.atLeast(open(), 1);
        }
    }

    /** A firing that speaks of sub-mission tokens, and finds none, is the first for the completion. */
    void useNew(CaseArcs arcs) {
        arcs.remove(unused, 1);
    }

    /** The completion is used. */
    void use(CaseArcs arcs) {
        arcs.empty(unused);
    }

    @Override
    public List<CaseArcs> changed(CaseArcs arcs, int edges, boolean isByNobody, boolean isPulled) {
        if (edges == 0) {
            leaveOpen(arcs);
            return List.of(arcs);
        }
        List<CaseArcs> cases = new ArrayList<>();
        CaseArcs first = arcs.copy();
        suppose(SubMode.VACANT, first);
        if (edges > 1 || isByNobody) {
            leaveOpen(first);
        } else {
            enteredFirst(first);
        }
        cases.add(first);
        for (int at : visitors) {
            CaseArcs second = arcs.copy();
            second.atLeast(at, 1);
            leaveOpen(second);
            cases.add(second);
        }
        parent().nobody(place()).ifPresent(nobody -> {
            CaseArcs third = arcs.copy();
            visitors.forEach(at -> third.below(at, 1));
            third.atLeast(nobody, 1);
            leaveOpen(third);
            cases.add(third);
        });
        return cases;
    }

    @Override
    public void parentStarts(CaseArcs arcs) {}

    @Override
    public void enteredFirst(CaseArcs arcs) {
        forget(arcs);
        start(arcs);
        join(arcs);
        atStart().ifPresent(child -> child.enteredFirst(arcs));
    }

    @Override
    void forget(CaseArcs arcs) {
        super.forget(arcs);
        arcs.clear(complete);
        arcs.clear(unused);
    }

    @Override
    void returned(CaseArcs arcs, Set<Integer> ends, EndTokens atEnd) {
        throw new IllegalStateException("Each end place ends the sub-mission of one visit of '" + place() + "'");
    }

    @Override
    void completed(CaseArcs arcs, EndTokens atEnd) {
        empty(arcs);
        arcs.set(complete);
        arcs.set(unused);
        bringBack(arcs, atEnd.tokens());
    }
}
