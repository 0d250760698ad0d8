package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Token;

/**
 * What follows when a token leaves a place.
 *
 * <p>Implements R-VIS-3, R-VIS-8.
 */
final class TokenRemoval {
    private final MissionRules rules;

    TokenRemoval(MissionRules rules) {
        this.rules = rules;
    }

    /** Takes tokens out of the marking and emits one effect for neighbours of one visit. */
    void remove(List<PlacedToken> entries) {
        for (int i = 0; i < entries.size(); ) {
            Visit v = entries.get(i).visit;
            List<Token> tokens = new ArrayList<>(entries.size() - i);
            for (; i < entries.size() && entries.get(i).visit == v; i++) {
                takeOut(entries.get(i));
                tokens.add(entries.get(i).token);
            }
            PlaceState place = v.place;
            rules.emit(new Effect.Left(place.mission.id, place.place.id(), v.id, tokens));
        }
    }

    private void takeOut(PlacedToken e) {
        e.place().remove(e);
        if (e.kind() != PlacedToken.GENERIC) {
            for (CompiledTransition t : e.place().place.barriers) {
                e.place().mission.transition(t.index).allReports().left(e.token);
            }
        }
    }

    /**
     * Ends what hung on a token that was taken out; what static instances have of it, {@link SharedInstances#pulled} says.
     *
     * @param before the stamp before the firing: what entered later has a greater order
     * @param withdraw whether it is to be taken out of running instances too (interrupts, abort, complete, dropped robots)
     */
    void left(PlacedToken e, long before, boolean withdraw) {
        Visit v = e.visit;
        if (e.kind() != PlacedToken.GENERIC) {
            rules.timers.tokenLeft(v, e.token);
            rules.pendings.left(e.place(), e.token, before);
        }
        if (v.hasInstances()) {
            for (Instance i : v.instances) {
                i.returned.remove(e.token);
                if (withdraw) {
                    rules.subMissions.withdraw(i, e.token);
                }
            }
        }
        if (v.hasLeft()) {
            rules.visits.end(v);
        }
    }
}
