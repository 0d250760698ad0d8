package org.sami.spn.engine.net;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.model.Place;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.vocabulary.Vocabulary;

/** A place with its out-transitions in the order in which they are looked at. */
public final class CompiledPlace {
    public final int index;
    public final Place place;
    /** Its id, as moves of tokens speak of it. */
    public final Optional<String> inMoves;

    public final CompiledOutput[] outputs;
    public final List<SubMissionSpec> dynamic = new ArrayList<>();
    public final List<SubMissionSpec> shared = new ArrayList<>();
    public CompiledTransition[] outTransitions = {};
    /** Transitions that wait for all and watch this place. */
    public CompiledTransition[] barriers = {};
    /** Whether an answer to an ended visit can still be for a transition: one of them has another in place. */
    public boolean answersOutliveVisits;

    public CompiledPlace(Vocabulary vocabulary, int index, Place place) {
        this.index = index;
        this.place = place;
        this.inMoves = Optional.of(place.id());
        this.outputs = place.outputs().stream()
                .map(o -> new CompiledOutput(vocabulary, o))
                .toArray(CompiledOutput[]::new);
        place.subMissions().forEach(s -> (s.shared() ? shared : dynamic).add(s));
    }

    /** The position of one of its output events. */
    public int indexOf(CompiledOutput output) {
        int i = 0;
        while (outputs[i] != output) {
            i++;
        }
        return i;
    }

    public boolean isEnd() {
        return place.end();
    }

    public String id() {
        return place.id();
    }

    @Override
    public String toString() {
        return place.name().isEmpty() ? place.id() : place.name();
    }
}
