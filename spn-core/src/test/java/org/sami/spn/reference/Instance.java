package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.model.Place;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.protocol.Token;

/** A sub-mission that was started: of one visit (dynamic) or of the parent mission (static) (SEMANTICS, Sub-missions). */
final class Instance {
    enum State {
        RUNNING,
        COMPLETE,
        ABORTED
    }

    final SubMissionSpec spec;
    final Mission parent;
    final Place place;
    /** Empty for a static one. */
    final Optional<Visit> visit;

    Mission child;
    State state = State.RUNNING;
    /** Dynamic: the tokens of the end places that can still be taken. */
    final List<Token> back = new ArrayList<>();
    /** Static: what joined it and has not returned. */
    final List<Token> joined = new ArrayList<>();
    /** Static: completions not yet used by an out-transition, oldest first. */
    final List<Returned> returns = new ArrayList<>();

    Instance(SubMissionSpec spec, Mission parent, Place place, Optional<Visit> visit) {
        this.spec = spec;
        this.parent = parent;
        this.place = place;
        this.visit = visit;
    }
}
