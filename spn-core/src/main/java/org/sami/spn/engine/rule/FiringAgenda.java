package org.sami.spn.engine.rule;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.TransitionState;

/**
 * The engine's one work list: transitions to look at, first in first out, none twice. Whether a transition is
 * enabled is found out when it is taken from the list, just before it fires.
 *
 * <p>Implements R-LOOK-1, R-LOOK-2, R-LOOK-3, R-LOOK-5, R-LOOK-6.
 */
final class FiringAgenda {
    private final Consumer<TransitionState> look;
    private final ArrayDeque<TransitionState> list = new ArrayDeque<>(4);
    private final List<PlaceState> withdrawnFrom = new ArrayList<>();

    /**
     * An empty list.
     *
     * @param look looks at a transition whose mission runs
     */
    FiringAgenda(Consumer<TransitionState> look) {
        this.look = look;
    }

    void add(TransitionState t) {
        if (!t.queued) {
            t.queued = true;
            list.add(t);
        }
    }

    /** Occasion (a): tokens, or nobody, entered; or (c): a sub-mission completed or returned. */
    void entered(PlaceState place) {
        for (CompiledTransition t : place.place.outTransitions) {
            addIfWaiting(place.mission, t);
        }
    }

    /** Occasion (b): tokens left. */
    void left(PlaceState place) {
        for (CompiledTransition t : place.place.outTransitions) {
            if (t.hasInputs() || t.inhibitedBy(place.place.index)) {
                addIfWaiting(place.mission, t);
            }
        }
    }

    /** Occasion (b) in an instance: tokens were taken out of it because they left its parent's place. */
    void withdrawn(PlaceState place) {
        withdrawnFrom.add(place);
    }

    /** Transitions of instances that lost tokens, in the order in which the instances lost them, from the outside inwards. */
    void addWithdrawn() {
        withdrawnFrom.forEach(this::left);
        withdrawnFrom.clear();
    }

    /** Transitions of places that a dropped robot left in a mission, by any cause; those of other missions wait for their turn. */
    void addDropped(MissionState mission) {
        for (PlaceState place : withdrawnFrom) {
            if (place.mission == mission) {
                left(place);
            }
        }
        withdrawnFrom.removeIf(place -> place.mission == mission);
    }

    private void addIfWaiting(MissionState mission, CompiledTransition t) {
        if (!t.hasInputs()) {
            add(mission.transition(t.index));
        } else {
            TransitionState state = mission.transitions[t.index];
            if (state != null && state.pending > 0) {
                add(state);
            }
        }
    }

    /** Whether nothing is left to look at. */
    boolean isDone() {
        return list.isEmpty() && withdrawnFrom.isEmpty();
    }

    void run() {
        for (TransitionState t = list.poll(); t != null; t = list.poll()) {
            t.queued = false;
            if (t.mission.runs()) {
                look.accept(t);
            }
        }
    }
}
