package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.protocol.Token;

/**
 * Which tokens a firing removes and adds: every out requirement selects on its own from one pool, before anything
 * moves (thesis 4.1.3).
 *
 * <p>Implements R-TOK-3, R-OUT-1, R-OUT-3, R-OUT-4, R-OUT-5.
 */
final class Selection {
    private final Enabling enabling;
    private final TokenPool pool;
    private final List<PlacedToken> picked = new ArrayList<>();
    private final PickedTokens removedOnce = new PickedTokens();
    private final PickedTokens addedByEdge = new PickedTokens();

    Selection(Enabling enabling, TokenPool pool) {
        this.enabling = enabling;
        this.pool = pool;
    }

    SelectedTokens select(TransitionState t, RelevantTokens relevant, FiringScope scope) {
        SelectedTokens result = new SelectedTokens(removedOnce, addedByEdge);
        for (CompiledTransition.Out out : t.transition.outs) {
            List<Token> added = new ArrayList<>(2);
            result.nextEdge();
            for (OutRequirement r : out.requirements()) {
                select(t, out, r, relevant, scope, result, added);
            }
            result.added.add(added);
        }
        removedOnce.clear();
        addedByEdge.clear();
        return result;
    }

    private void select(
            TransitionState t,
            CompiledTransition.Out out,
            OutRequirement r,
            RelevantTokens relevant,
            FiringScope scope,
            SelectedTokens result,
            List<Token> added) {
        boolean adds = r.action() == Action.ADD;
        if (r.kind() == TokenKind.UNCONDITIONAL) {
            return;
        }
        if (adds && r.kind() == TokenKind.GENERIC && !r.takesAll()) {
            for (int i = 0; i < r.n(); i++) {
                result.make(Token.GENERIC, out, added);
            }
            return;
        }
        if (adds && r.kind() == TokenKind.RELEVANT) {
            addRelevant(r, relevant, out, result, added);
            return;
        }
        if (r.kind() == TokenKind.SUB_MISSION_TOKENS) {
            new ReturnedTokens(pool, t, out, r, result, added).select(scope);
            return;
        }
        picked.clear();
        if (r.kind() == TokenKind.RELEVANT) {
            pickRelevant(t, r, relevant, scope, result);
        } else {
            pick(t, r, scope, result);
        }
        for (PlacedToken e : picked) {
            result.use(e, r.action(), out, added);
        }
        picked.clear();
    }

    private void pick(TransitionState t, OutRequirement r, FiringScope scope, SelectedTokens result) {
        int wanted = r.takesAll() ? Integer.MAX_VALUE : r.n();
        int found = 0;
        for (CompiledPlace place : t.transition.inPlaces) {
            PlaceState state = t.mission.places[place.index];
            if (state != null && found < wanted) {
                found += pickIn(state, r, wanted - found, scope);
            }
        }
        if (!r.takesAll() && found < wanted) {
            result.shortOf.add(found + " of " + wanted + " " + words(r));
        }
    }

    private int pickIn(PlaceState state, OutRequirement r, int limit, FiringScope scope) {
        return switch (r.kind()) {
            case GENERIC -> pool.collect(state, PlacedToken.GENERIC, limit, scope, null, picked);
            case ANY_PROXY -> pool.collect(state, PlacedToken.PROXY, limit, scope, null, picked);
            case ANY_TASK -> pool.collect(state, PlacedToken.TASK, limit, scope, null, picked);
            case TASK -> pool.collect(state, PlacedToken.TASK, limit, scope, enabling.isTask(r.task()), picked);
            default -> pool.collectAny(state, limit, scope, picked);
        };
    }

    /** Makes a token for each of the first names, even if such a token stands elsewhere. */
    private static void addRelevant(
            OutRequirement r,
            RelevantTokens relevant,
            CompiledTransition.Out out,
            SelectedTokens result,
            List<Token> added) {
        int wanted = r.takesAll() ? Integer.MAX_VALUE : r.n();
        List<Token> chosen = new ArrayList<>();
        for (NamedToken n : relevant.names) {
            if (chosen.size() < wanted && !chosen.contains(n.token)) {
                chosen.add(n.token);
                if (!added.contains(n.token)) {
                    result.make(n.token, out, added);
                }
            }
        }
        if (!r.takesAll() && chosen.size() < wanted) {
            result.shortOf.add(chosen.size() + " of " + wanted + " relevant tokens");
        }
    }

    private void pickRelevant(
            TransitionState t, OutRequirement r, RelevantTokens relevant, FiringScope scope, SelectedTokens result) {
        CompiledPlace[] places = t.transition.inPlaces;
        for (Token token : relevant.tokens) {
            for (CompiledPlace place : places) {
                PlaceState state = t.mission.places[place.index];
                if (state != null) {
                    pool.collectCopies(state, token, scope, picked);
                }
            }
        }
        if (picked.size() > 1) {
            picked.sort(Comparator.comparingInt((PlacedToken e) -> indexOf(places, e.place().place))
                    .thenComparingLong(PlacedToken::order));
        }
        if (picked.isEmpty()) {
            result.shortOf.add("none of the relevant tokens");
        } else if (!r.takesAll() && picked.size() < r.n()) {
            result.shortOf.add(picked.size() + " of " + r.n() + " relevant tokens");
        } else if (!r.takesAll() && picked.size() > r.n()) {
            picked.subList(r.n(), picked.size()).clear();
        }
    }

    private static int indexOf(CompiledPlace[] places, CompiledPlace place) {
        int i = 0;
        while (places[i] != place) {
            i++;
        }
        return i;
    }

    private static String words(OutRequirement r) {
        return switch (r.kind()) {
            case GENERIC -> "generic tokens";
            case ANY_PROXY -> "proxy tokens";
            case ANY_TASK -> "task tokens";
            case TASK -> "tokens of task '" + r.task() + "'";
            default -> "tokens";
        };
    }
}
