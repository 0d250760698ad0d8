package org.sami.spn.engine.rule;

import java.util.LinkedHashMap;
import java.util.List;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Token;

/**
 * Begins and ends visits.
 *
 * <p>Implements R-VIS-1, R-VIS-5, R-OCC-9.
 */
final class Visits {
    private final MissionRules rules;

    Visits(MissionRules rules) {
        this.rules = rules;
    }

    /** Tokens, or nobody, enter a place. */
    Visit begin(PlaceState place, List<Token> tokens) {
        NetState state = rules.state();
        Visit v = new Visit(++state.lastVisit, place, List.copyOf(tokens));
        place.mission.addVisit(v);
        v.enter(state.stamp + 1);
        state.stamp += tokens.size();
        if (v.byNobody) {
            place.addByNobody(v);
        }
        rules.emit(new Effect.Entered(place.mission.id, place.place.id(), v.id, v.entered));
        return v;
    }

    /** Ends a visit: timers and questions go, later answers are late, instances that still run are aborted. */
    void end(Visit v) {
        if (v.ended) {
            return;
        }
        close(v);
        PlaceState place = v.place;
        place.mission.removeVisit(v);
        if (v.byNobody) {
            place.removeByNobody(v);
            rules.emit(new Effect.Left(place.mission.id, place.place.id(), v.id, List.of()));
        }
        if (v.hasInstances()) {
            place.removeInstanceVisit(v);
            for (Instance i : v.instances) {
                rules.subMissions.visitEnded(i);
            }
        }
        rules.pendings.visitEnded(v);
        if (v.firstSent() != null) {
            if (place.place.answersOutliveVisits && !v.byNobody) {
                remember(v);
            } else {
                forget(v);
            }
        }
    }

    /** Ends what a visit has going on outside the marking: timers, questions, activations. */
    void close(Visit v) {
        v.ended = true;
        for (SentActivation sent = v.firstSent(); sent != null; sent = sent.next()) {
            sent.open = false;
            rules.timers.cancelAll(sent);
            if (sent.decision != Ids.NONE) {
                rules.questions.close(rules.state().decision(sent.decision));
            }
            rules.emit(new Effect.ActivationEnded(sent.activation.id()));
        }
    }

    /** Keeps an ended visit's activations until its robots have ended a later visit to the same place. */
    private void remember(Visit v) {
        PlaceState place = v.place;
        if (place.lastVisits == null) {
            place.lastVisits = new LinkedHashMap<>();
        }
        for (Token token : v.entered) {
            if (PlacedToken.kindOf(token) != PlacedToken.GENERIC) {
                Visit older = place.lastVisits.put(token, v);
                if (older != v) {
                    v.remembered++;
                    if (older != null && --older.remembered == 0) {
                        forget(older);
                    }
                }
            }
        }
        if (v.remembered == 0) {
            forget(v);
        }
    }

    void forget(Visit v) {
        for (SentActivation sent = v.firstSent(); sent != null; sent = sent.next()) {
            rules.state().sent.remove(sent.activation.id());
        }
    }
}
