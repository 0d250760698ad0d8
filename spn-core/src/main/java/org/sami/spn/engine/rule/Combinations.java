package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.Reach;
import org.sami.spn.engine.state.Barrier;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.TransitionState;

/**
 * Finds the earliest combination of pending occurrences that enables a transition.
 *
 * <p>Implements R-PEND-5, R-PEND-6, R-PEND-7, R-RET-3.
 */
public final class Combinations {
    /** Occurrences that enable a transition together. */
    public record Found(List<PendingOccurrence> used, RelevantTokens relevant, FiringScope scope) {}

    private final Enabling enabling;

    public Combinations(Enabling enabling) {
        this.enabling = enabling;
    }

    /** The earliest combination that enables a transition; null where there is none. */
    public @Nullable Found find(TransitionState t) {
        for (TransitionState.Queue q : t.queues) {
            if (q.size == 0) {
                return null;
            }
        }
        Reach reach = t.transition.reach();
        if (!t.transition.checksReturns && !isPossible(t, FiringScope.of(reach))) {
            return null;
        }
        if (t.barrier != null) {
            return all(t, t.barrier, reach);
        }
        if (t.queues.length == 1) {
            for (PendingOccurrence p = t.queues[0].first; p != null; p = p.next) {
                Found found = attempt(t, List.of(p), reach);
                if (found != null) {
                    return found;
                }
            }
            return null;
        }
        return search(t, new ArrayList<>(), reach);
    }

    /** Whether the marking allows it, whatever occurrences it uses; returns that it checks bind it to other tokens. */
    private boolean isPossible(TransitionState t, FiringScope scope) {
        return enabling.isReady(t, scope) && enabling.meetsPlain(t, scope);
    }

    private @Nullable Found search(TransitionState t, List<PendingOccurrence> chosen, Reach reach) {
        if (chosen.size() == t.queues.length) {
            return attempt(t, List.copyOf(chosen), reach);
        }
        for (PendingOccurrence p = t.queues[chosen.size()].first; p != null; p = p.next) {
            if (joins(chosen, p)) {
                chosen.add(p);
                Found found = search(t, chosen, reach);
                chosen.remove(chosen.size() - 1);
                if (found != null) {
                    return found;
                }
            }
        }
        return null;
    }

    /** Those that name tokens must name the same ones; those that name none join with any, returns with those of their visit. */
    private static boolean joins(List<PendingOccurrence> chosen, PendingOccurrence p) {
        if (excluded(chosen, p)) {
            return false;
        }
        if (p.names.length == 0) {
            return true;
        }
        for (PendingOccurrence other : chosen) {
            if (other.names.length > 0) {
                return PendingOccurrences.namesSame(other, p);
            }
        }
        return true;
    }

    private static boolean excluded(List<PendingOccurrence> chosen, PendingOccurrence p) {
        if (p.told == null) {
            return false;
        }
        for (PendingOccurrence other : chosen) {
            if (other.told != null && p.told.excludes(other.told)) {
                return true;
            }
        }
        return false;
    }

    /** Waits until every robot or task in the watched places has reported, then uses all reports. */
    private @Nullable Found all(TransitionState t, Barrier barrier, Reach reach) {
        if (barrier.isEmpty()) {
            return null;
        }
        List<PendingOccurrence> used = new ArrayList<>();
        for (int input = 0; input < t.queues.length; input++) {
            if (t.queues[input].naming > 0 && barrier.missing(input) > 0) {
                return null;
            }
        }
        boolean somebody = false;
        for (TransitionState.Queue q : t.queues) {
            for (PendingOccurrence p = q.first; p != null; p = p.next) {
                if ((p.names.length == 0 || stands(barrier, p)) && !excluded(used, p)) {
                    used.add(p);
                    somebody |= p.names.length > 0;
                }
            }
        }
        return somebody ? attempt(t, used, reach) : null;
    }

    private static boolean stands(Barrier barrier, PendingOccurrence p) {
        for (NamedToken n : p.names) {
            for (int i = 0; i < n.tokens.length && !n.struck; i++) {
                if (barrier.stands(n.tokens[i])) {
                    return true;
                }
            }
        }
        return false;
    }

    private @Nullable Found attempt(TransitionState t, List<PendingOccurrence> used, Reach reach) {
        RelevantTokens relevant = RelevantTokens.of(used);
        FiringScope scope = FiringScope.of(reach, used);
        return enabling.isEnabled(t, relevant, scope) ? new Found(used, relevant, scope) : null;
    }
}
