package org.sami.spn.engine.codec;

import java.util.function.ToIntFunction;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;

/** Says what a transition has received and keeps, in order where it does not wait for all. */
final class AlikePending {
    private final AlikeNames names;
    private final LabelledStructure facts;
    private final AlikeValues values;
    private final ToIntFunction<Visit> visits;

    /**
     * Says it in facts.
     *
     * @param visits says a visit and gives its object
     */
    AlikePending(AlikeNames names, LabelledStructure facts, AlikeValues values, ToIntFunction<Visit> visits) {
        this.names = names;
        this.facts = facts;
        this.values = values;
        this.visits = visits;
    }

    void of(int mission, TransitionState t) {
        for (TransitionState.Queue q : t.queues) {
            int turn = 0;
            for (PendingOccurrence p = q.first; p != null; p = p.next) {
                int pending = facts.object(p, "pending " + t.transition.index + "." + p.input.index);
                facts.fact("keeps" + (t.transition.waitsForAll ? "" : " " + turn), mission, pending);
                pending(pending, p);
                turn++;
            }
        }
    }

    private void pending(int pending, PendingOccurrence p) {
        Occurrence o = p.occurrence;
        facts.fact(o.type() + (p.answered != null) + (p.told != null), pending);
        o.proxies().forEach(robot -> facts.fact("names", pending, names.robot(robot)));
        o.tasks().forEach(task -> facts.fact("names", pending, names.task(task)));
        values.all("tells", o.values(), pending);
        if (p.visit() != null) {
            facts.fact("of", pending, visits.applyAsInt(p.visit()));
        }
        if (p.told != null) {
            facts.fact("told " + p.told.value, pending, facts.object(p.told.instance, "told"));
            p.told.tokens.forEach(token -> facts.fact("told", pending, names.token(token)));
        }
        for (NamedToken n : p.names) {
            facts.fact("name " + n.struck + n.stood, pending, names.token(n.token));
            for (Token token : n.tokens) {
                facts.fact("name of", pending, names.token(n.token), names.token(token));
            }
        }
    }
}
