package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.model.Place;
import org.sami.spn.model.SubMissionSpec;

/** A place with its out-transitions in the order in which they are looked at. */
final class CompiledPlace {
    final int index;
    final Place place;
    /** Its id, as moves of tokens speak of it. */
    final Optional<String> inMoves;

    final CompiledOutput[] outputs;
    final List<SubMissionSpec> dynamic = new ArrayList<>();
    final List<SubMissionSpec> shared = new ArrayList<>();
    CompiledTransition[] outTransitions = {};
    /** Transitions that wait for all and watch this place. */
    CompiledTransition[] barriers = {};
    /** Whether an answer to an ended visit can still be for a transition: one of them has another in place. */
    boolean answersOutliveVisits;

    CompiledPlace(CompiledProject project, int index, Place place) {
        this.index = index;
        this.place = place;
        this.inMoves = Optional.of(place.id());
        this.outputs = place.outputs().stream()
                .map(o -> new CompiledOutput(project, o))
                .toArray(CompiledOutput[]::new);
        place.subMissions().forEach(s -> (s.shared() ? shared : dynamic).add(s));
    }

    boolean isEnd() {
        return place.end();
    }

    String id() {
        return place.id();
    }

    @Override
    public String toString() {
        return place.name().isEmpty() ? place.id() : place.name();
    }
}
