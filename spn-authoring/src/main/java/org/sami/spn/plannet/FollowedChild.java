package org.sami.spn.plannet;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.sami.spn.model.Place;

/** A sub-mission that the net follows on a place of its parent. Where that ends, the place is left open: its mark says so, and from then on all is possible. */
abstract class FollowedChild implements StartedChild {
    private final MissionPlaces parent;
    private final String place;
    private final ChildMission mission;
    private final int open;
    private final Map<PlanToken, Integer> back = new LinkedHashMap<>();

    /**
     * A child that is ready to be followed.
     *
     * @param place of the parent's plan
     * @param mission the child's
     * @param returning the robots of which it is followed whether the child brought them back
     */
    FollowedChild(MissionPlaces parent, String place, ChildMission mission, List<PlanToken> returning) {
        this.parent = parent;
        this.place = place;
        this.mission = mission;
        open = parent.control(place + ".open", place + ": its sub-mission is not followed", 0);
        returning.forEach(token -> back.put(token, parent.back(place, token)));
    }

    MissionPlaces parent() {
        return parent;
    }

    String place() {
        return place;
    }

    ChildMission mission() {
        return mission;
    }

    /** The place of the net that is marked while the sub-mission is not followed. */
    int open() {
        return open;
    }

    /** Whether a token came back; empty for one of which that is not followed. */
    Optional<Integer> back(PlanToken token) {
        return Optional.ofNullable(back.get(token));
    }

    /** Whether it can bring a token back to its place. */
    boolean mayReturn(PlanToken token) {
        return true;
    }

    /** How the place can be while a transition out of it fires. */
    abstract List<SubMode> modes();

    /** What a firing out of the place supposes of it. */
    abstract void suppose(SubMode mode, CaseArcs arcs);

    /** The child has entered an end place with these tokens, and is over. */
    abstract void completed(CaseArcs arcs, EndTokens atEnd);

    /**
     * The child has entered end places that do not end it.
     *
     * @param ends the numbers of the out edges that lead there
     */
    abstract void returned(CaseArcs arcs, Set<Integer> ends, EndTokens atEnd);

    /** The child's mission starts, with nobody in it. */
    final void start(CaseArcs arcs) {
        arcs.add(mission.places().running(), 1);
        mission.children().forEach(child -> child.parentStarts(arcs));
    }

    /** Who enters the place enters the child's start place; what runs there is not told. */
    final void join(CaseArcs arcs) {
        String start = startPlace();
        MissionPlaces child = mission.places();
        child.in(start).forEach((token, at) -> {
            OptionalInt here = parent.of(place, token);
            int entering = here.isPresent() ? arcs.added(here.getAsInt()) : 0;
            arcs.add(at, entering);
            child.counting(start, token).forEach(counter -> arcs.add(counter, entering));
        });
        child.occasions(mission.plan(), start, true, arcs);
    }

    /** What runs in the child's start place. */
    final Optional<? extends StartedChild> atStart() {
        return mission.child(startPlace());
    }

    private String startPlace() {
        return mission.plan().startPlace().map(Place::id).orElseThrow();
    }

    /** It is no longer followed what the child does. */
    final void leaveOpen(CaseArcs arcs) {
        forget(arcs);
        arcs.set(open);
    }

    /** Nothing is left of the child, nor of what it brought back. */
    void forget(CaseArcs arcs) {
        empty(arcs);
        back.values().forEach(arcs::clear);
        arcs.clear(open);
    }

    /** Nothing stands in the child's places any longer. */
    final void empty(CaseArcs arcs) {
        mission.owned().forEach(arcs::clear);
    }

    /** These tokens came back. */
    final void bringBack(CaseArcs arcs, List<PlanToken> brought) {
        back.forEach((token, at) -> {
            if (brought.contains(token)) {
                arcs.set(at);
            }
        });
    }
}
