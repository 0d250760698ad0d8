package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.protocol.Token;

/**
 * One out requirement on sub-mission tokens: the tokens in the end places of instances on the in places.
 *
 * <p>Implements R-SUB-4.
 */
final class ReturnedTokens {
    private final TokenPool pool;
    private final TransitionState t;
    private final CompiledTransition.Out out;
    private final OutRequirement requirement;
    private final SelectedTokens result;
    private final List<Token> added;
    private final PickedTokens picked = new PickedTokens();
    private final List<SelectedTokens.UsedReturn> used = new ArrayList<>(0);
    private int left;

    ReturnedTokens(
            TokenPool pool,
            TransitionState t,
            CompiledTransition.Out out,
            OutRequirement requirement,
            SelectedTokens result,
            List<Token> added) {
        this.pool = pool;
        this.t = t;
        this.out = out;
        this.requirement = requirement;
        this.result = result;
        this.added = added;
        this.left = requirement.takesAll() ? Integer.MAX_VALUE : requirement.n();
    }

    void select(FiringScope scope) {
        for (CompiledPlace place : t.transition.inPlaces) {
            PlaceState state = t.mission.places[place.index];
            if (state != null) {
                PairedReturns paired = PairedReturns.in(state, scope);
                List<PlacedToken> returned = pool.returned(state, scope, paired);
                if (paired != null && paired.limit() && returned != null) {
                    selectReturned(paired, returned);
                }
                Visit bound = scope.visitIn(state);
                for (Visit v : state.instanceVisits().values()) {
                    if (v.complete() && (bound == null || bound == v)) {
                        selectVisit(v, returned);
                    }
                }
            }
        }
        if (!requirement.takesAll() && left > 0) {
            result.shortOf.add((requirement.n() - left) + " of " + requirement.n() + " sub-mission tokens");
        }
    }

    /** What several static instances brought back is one token. */
    private void selectReturned(PairedReturns paired, List<PlacedToken> entries) {
        for (Token token : paired.tokens) {
            PlacedToken standing = null;
            for (PlacedToken e : entries) {
                if (e.token.equals(token) && !picked.contains(e)) {
                    standing = e;
                    break;
                }
            }
            use(paired.returns.get(0).instance, token, standing);
        }
    }

    private void selectVisit(Visit v, @Nullable List<PlacedToken> free) {
        for (Instance instance : v.instances) {
            for (Token token : instance.returned) {
                use(instance, token, standing(v, token, free));
            }
        }
    }

    private @Nullable PlacedToken standing(Visit v, Token token, @Nullable List<PlacedToken> free) {
        for (PlacedToken e : v.standing()) {
            if (!picked.contains(e) && e.token.equals(token) && (free == null || free.contains(e))) {
                return e;
            }
        }
        return null;
    }

    private void use(Instance instance, Token token, @Nullable PlacedToken standing) {
        if (left == 0) {
            return;
        }
        left--;
        if (standing != null) {
            picked.add(standing);
            result.use(standing, requirement.action(), out, added);
            return;
        }
        if (requirement.action() != Action.ADD) {
            useUp(new SelectedTokens.UsedReturn(instance, token));
        }
        if (requirement.action() != Action.CONSUME && (token.equals(Token.GENERIC) || !added.contains(token))) {
            result.make(token, out, added);
        }
    }

    /** Each requirement selects from the same tokens: what several select is used up once. */
    private void useUp(SelectedTokens.UsedReturn token) {
        used.add(token);
        if (Collections.frequency(result.usedReturns, token) < Collections.frequency(used, token)) {
            result.usedReturns.add(token);
        }
    }
}
