package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Supplier;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;

/**
 * A dynamic sub-mission that the net follows: one visit of its place at a time, from its start to what it brought back (R-SUB-1 to R-SUB-6). Where there may be more than
 * that, the place is left open: its mark says so, and from then on all is possible until the place is empty.
 */
final class FollowedChild {
    private final MissionPlaces parent;
    private final Plan plan;
    private final MissionPlaces child;
    private final Supplier<List<Integer>> owned;
    private final boolean knowsReturns;
    private final String place;
    private final int count;
    private final int complete;
    private final int unused;
    private final int open;
    private final Map<PlanToken, Integer> back = new LinkedHashMap<>();

    /**
     * A child that is ready to be followed.
     *
     * @param place of the parent's plan
     * @param robots each with a token of its own
     * @param plan the child's
     * @param owned all places of the net that stand for the child and its own children
     * @param knowsReturns whether the child can only bring back what was given to it
     */
    FollowedChild(
            MissionPlaces parent,
            String place,
            List<PlanToken> robots,
            Plan plan,
            MissionPlaces child,
            Supplier<List<Integer>> owned,
            boolean knowsReturns) {
        this.parent = parent;
        this.place = place;
        this.plan = plan;
        this.child = child;
        this.owned = owned;
        this.knowsReturns = knowsReturns;
        MissionPlaces places = parent;
        count = places.counter(place, "visitors", token -> true);
        complete = places.control(place + ".complete", place + ": its sub-mission is complete", 0);
        unused = places.control(place + ".unused", place + ": its completion is not used yet", 0);
        open = places.control(place + ".open", place + ": its sub-mission is not followed", 0);
        if (knowsReturns) {
            robots.forEach(token -> back.put(token, places.back(place, token)));
        }
    }

    String place() {
        return place;
    }

    /** The place of the net that is marked while the sub-mission is not followed. */
    int open() {
        return open;
    }

    /** Whether a token came back; empty for one of which that is not followed. */
    Optional<Integer> back(PlanToken token) {
        return Optional.ofNullable(back.get(token));
    }

    /** Whether it is known what came back: all of it was there before. */
    boolean knowsReturns() {
        return knowsReturns;
    }

    /** What a firing out of the place supposes of it. */
    void suppose(SubMode mode, CaseArcs arcs) {
        switch (mode) {
            case VACANT -> {
                arcs.below(count, 1);
                parent.nobody(place).ifPresent(nobody -> arcs.below(nobody, 1));
            }
            case COMPLETE -> arcs.atLeast(complete, 1);
            case OPEN -> arcs.atLeast(open, 1);
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

    /** The cases of a firing by whose edges tokens, or nobody, enter the place. */
    List<CaseArcs> entered(CaseArcs arcs, int edges, boolean isByNobody) {
        List<CaseArcs> cases = new ArrayList<>();
        CaseArcs first = arcs.copy();
        suppose(SubMode.VACANT, first);
        if (edges > 1 || isByNobody) {
            leaveOpen(first);
        } else {
            start(first);
        }
        cases.add(first);
        CaseArcs second = arcs.copy();
        second.atLeast(count, 1);
        leaveOpen(second);
        cases.add(second);
        parent.nobody(place).ifPresent(nobody -> {
            CaseArcs third = arcs.copy();
            third.below(count, 1);
            third.atLeast(nobody, 1);
            leaveOpen(third);
            cases.add(third);
        });
        return cases;
    }

    private void start(CaseArcs arcs) {
        forget(arcs);
        arcs.add(child.running(), 1);
        Place start = plan.startPlace().orElseThrow();
        child.in(start.id()).forEach((token, at) -> {
            OptionalInt here = parent.of(place, token);
            int entering = here.isPresent() ? arcs.added(here.getAsInt()) : 0;
            arcs.add(at, entering);
            child.counting(start.id(), token).forEach(counter -> arcs.add(counter, entering));
        });
        child.occasions(plan, start.id(), true, arcs);
    }

    /** No longer one visit whose instance is known. */
    void leaveOpen(CaseArcs arcs) {
        forget(arcs);
        arcs.set(open);
    }

    private void forget(CaseArcs arcs) {
        owned.get().forEach(arcs::clear);
        back.values().forEach(arcs::clear);
        arcs.clear(complete);
        arcs.clear(unused);
        arcs.clear(open);
    }

    /** The child has entered an end place with these tokens. */
    void completed(CaseArcs arcs, List<PlanToken> brought) {
        owned.get().forEach(arcs::clear);
        arcs.set(complete);
        arcs.set(unused);
        back.forEach((token, at) -> {
            if (brought.contains(token)) {
                arcs.set(at);
            }
        });
    }
}
