package org.sami.spn.engine.rule;

import java.util.function.Predicate;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.net.Reach;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.TokenKind;
import org.sami.spn.protocol.Token;

/**
 * Whether a transition can fire: requirements of its in edges, and sub-missions on its in places (thesis, Algorithm
 * 1).
 *
 * <p>Implements R-IN-1, R-IN-2, R-IN-3, R-IN-4, R-IN-5, R-OCC-7, R-SUB-3, R-SUB-6.
 */
public final class Enabling {
    private final RuleStep step;
    private final TokenPool pool;

    Enabling(RuleStep step, TokenPool pool) {
        this.step = step;
        this.pool = pool;
    }

    public boolean isEnabled(TransitionState t, RelevantTokens relevant, FiringScope scope) {
        return isReady(t, scope) && meetsPlain(t, scope) && meetsRelevant(t, relevant, scope);
    }

    /** Whether no in place makes it wait for a sub-mission. */
    public boolean isReady(TransitionState t, FiringScope scope) {
        if (scope.reach == Reach.ALL) {
            return true;
        }
        for (CompiledPlace place : t.transition.inPlaces) {
            if (!isReady(t, place, scope)) {
                return false;
            }
        }
        return !t.transition.wantsSubTokens || somethingReturned(t, scope);
    }

    /** Whether an in place has a completion for a transition that speaks of sub-mission tokens: it fires for each once. */
    public boolean somethingReturned(TransitionState t, FiringScope scope) {
        boolean possible = false;
        for (CompiledPlace place : t.transition.inPlaces) {
            if (scope.reach != Reach.FREE || !place.shared.isEmpty()) {
                return true; // its return is the completion
            }
            possible |= !place.dynamic.isEmpty();
        }
        return !possible || anyVisit(t, scope, v -> v.complete() && (!v.used || v.hasSubTokens()));
    }

    private static boolean anyVisit(TransitionState t, FiringScope scope, Predicate<Visit> test) {
        for (CompiledPlace place : t.transition.inPlaces) {
            PlaceState state = t.mission.places[place.index];
            if (state != null && anyVisit(state, scope, test)) {
                return true;
            }
        }
        return false;
    }

    private static boolean anyVisit(PlaceState place, FiringScope scope, Predicate<Visit> test) {
        Visit bound = scope.visitIn(place);
        for (Visit v : place.instanceVisits().values()) {
            if ((bound == null || bound == v) && test.test(v)) {
                return true;
            }
        }
        return false;
    }

    public boolean isReady(TransitionState t, CompiledPlace place, FiringScope scope) {
        PlaceState state = t.mission.places[place.index];
        if (!place.shared.isEmpty()
                && (state == null
                        || state.shared.length < place.shared.size()
                        || PairedReturns.in(state, scope) == null)) {
            return false;
        }
        return state == null || state.instanceVisits().isEmpty() || anyVisit(state, scope, v -> isOver(v, scope));
    }

    private static boolean isOver(Visit v, FiringScope scope) {
        return v.complete() || (scope.reach == Reach.ABORTED && v.leftByAborted());
    }

    /** Requirements that do not depend on occurrences. */
    public boolean meetsPlain(TransitionState t, FiringScope scope) {
        for (CompiledTransition.In in : t.transition.ins) {
            for (InRequirement r : in.requirements()) {
                if (r.kind() != TokenKind.RELEVANT && !isMet(t, in.place(), r, RelevantTokens.NOBODY, scope)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean meetsRelevant(TransitionState t, RelevantTokens relevant, FiringScope scope) {
        for (CompiledTransition.In in : t.transition.ins) {
            for (InRequirement r : in.requirements()) {
                if (r.kind() == TokenKind.RELEVANT && !isMet(t, in.place(), r, relevant, scope)) {
                    return false;
                }
            }
        }
        return true;
    }

    public boolean isMet(
            TransitionState t, CompiledPlace place, InRequirement r, RelevantTokens relevant, FiringScope scope) {
        if (r.kind() == TokenKind.UNCONDITIONAL) {
            return true;
        }
        PlaceState state = t.mission.places[place.index];
        if (r.match() == Match.ALL) {
            return state == null ? relevant.names.length == 0 : allHere(state, relevant, scope);
        }
        int n = state == null ? 0 : count(state, r, relevant, scope);
        return switch (r.match()) {
            case ZERO -> n == 0;
            case LESS_THAN -> n < r.n();
            case EXACTLY -> n == r.n();
            default -> n >= r.n();
        };
    }

    /** For every name one of its tokens is here. */
    private boolean allHere(PlaceState state, RelevantTokens relevant, FiringScope scope) {
        for (NamedToken n : relevant.names) {
            boolean here = false;
            for (int i = 0; i < n.tokens.length && !here; i++) {
                here = pool.copies(state, n.tokens[i], scope) > 0;
            }
            if (!here) {
                return false;
            }
        }
        return true;
    }

    /** What a requirement counts: the pool where it wants tokens, everything that stands here where it inhibits. */
    public int count(PlaceState state, InRequirement r, RelevantTokens relevant, FiringScope scope) {
        FiringScope counted = r.match() == Match.AT_LEAST ? scope : FiringScope.of(Reach.ALL);
        return switch (r.kind()) {
            case GENERIC -> pool.count(state, PlacedToken.GENERIC, counted);
            case ANY_PROXY -> pool.count(state, PlacedToken.PROXY, counted);
            case ANY_TASK -> pool.count(state, PlacedToken.TASK, counted);
            case ANY_TOKEN ->
                pool.count(state, PlacedToken.GENERIC, counted)
                        + pool.count(state, PlacedToken.PROXY, counted)
                        + pool.count(state, PlacedToken.TASK, counted);
            case TASK -> pool.count(state, PlacedToken.TASK, counted, isTask(r.task()));
            case RELEVANT -> {
                int n = 0;
                for (Token token : relevant.tokens) {
                    n += pool.copies(state, token, counted);
                }
                yield n;
            }
            default -> 0;
        };
    }

    /** Whether a token is the task of a name or of a class. */
    public Predicate<Token> isTask(String nameOrClass) {
        return token -> {
            if (!(token instanceof Token.Task task)) {
                return false;
            }
            if (task.task().name().equals(nameOrClass)) {
                return true;
            }
            TaskState state = step.task(task.task());
            return state != null && state.taskClass.equals(nameOrClass);
        };
    }

    /**
     * Whether a transition asks only that a token is not in one of its in places: an answer about it there is for the
     * transitions that could take it (R-OCC-7).
     *
     * @param named whether the occurrence names the token, so that it is a relevant one
     */
    public boolean wantsAbsence(CompiledTransition t, CompiledPlace place, Token token, boolean named) {
        boolean wantsNone = false;
        for (int i = 0; t.wantsNone && i < t.ins.length; i++) {
            if (t.ins[i].place() == place) {
                for (InRequirement r : t.ins[i].requirements()) {
                    if (r.kind() == TokenKind.UNCONDITIONAL
                            || (CompiledTransition.wantsTokens(r) && speaksOf(r, token, named))) {
                        return false;
                    }
                    wantsNone |= CompiledTransition.wantsNone(r) && speaksOf(r, token, named);
                }
            }
        }
        return wantsNone;
    }

    private boolean speaksOf(InRequirement r, Token token, boolean named) {
        return switch (r.kind()) {
            case GENERIC -> token instanceof Token.Generic;
            case ANY_PROXY -> token instanceof Token.Proxy;
            case ANY_TASK -> token instanceof Token.Task;
            case TASK -> isTask(r.task()).test(token);
            case RELEVANT -> named;
            case ANY_TOKEN, UNCONDITIONAL, SUB_MISSION_TOKENS -> true;
        };
    }

    /** Whether a requirement counts a token that is removed from its place (occasion d). */
    public boolean counts(InRequirement r, PlacedToken e) {
        if (r.match() != Match.AT_LEAST && r.match() != Match.EXACTLY) {
            return false;
        }
        return switch (r.kind()) {
            case GENERIC -> e.kind() == PlacedToken.GENERIC;
            case ANY_PROXY -> e.kind() == PlacedToken.PROXY;
            case ANY_TASK -> e.kind() == PlacedToken.TASK;
            case ANY_TOKEN -> true;
            case TASK -> isTask(r.task()).test(e.token);
            default -> false;
        };
    }
}
