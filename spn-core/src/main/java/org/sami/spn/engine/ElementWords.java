package org.sami.spn.engine;

import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.model.Plan;
import org.sami.spn.naming.ElementNames;
import org.sami.spn.vocabulary.Vocabulary;

/** What explanations call places and events: the author's name, else what the place does; an event's title. Never an id. */
final class ElementWords {
    private final NetState state;

    ElementWords(NetState state) {
        this.state = state;
    }

    /** A place in the middle of a sentence: {@code 'Go'}, {@code the place of Proxy Execute Path}, {@code place 3}. */
    String place(MissionState mission, CompiledPlace place) {
        if (!place.place.name().isBlank()) {
            return "'" + place.place.name() + "'";
        }
        Plan plan = mission.plan.plan;
        return new ElementNames(plan, vocabulary()).inSentence(place.place);
    }

    /** The title of an input event, with the name of the interrupt or the value of the return that it waits for. */
    String event(CompiledInput input) {
        String title = vocabulary().title(input.spec.type());
        return input.selector == null ? title : title + " '" + input.selector + "'";
    }

    private Vocabulary vocabulary() {
        return state.newest().vocabulary;
    }
}
