package org.sami.spn.engine;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.sami.spn.model.Action;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.protocol.Token;

/** One out requirement on sub-mission tokens: the tokens in the end places of instances on the in places. */
final class ReturnedTokens {
    private final Rules rules;
    private final TransitionState t;
    private final CompiledTransition.Out out;
    private final OutRequirement requirement;
    private final Selection.Selected result;
    private final List<Token> added;
    private final long firing;
    private final long edge;
    private final long pick;
    private final List<Selection.UsedReturn> used = new ArrayList<>(0);
    private int left;

    ReturnedTokens(
            Rules rules,
            TransitionState t,
            CompiledTransition.Out out,
            OutRequirement requirement,
            Selection.Selected result,
            List<Token> added,
            long firing,
            long edge) {
        this.rules = rules;
        this.t = t;
        this.out = out;
        this.requirement = requirement;
        this.result = result;
        this.added = added;
        this.firing = firing;
        this.edge = edge;
        this.pick = ++rules.state.stamp;
        this.left = requirement.takesAll() ? Integer.MAX_VALUE : requirement.n();
    }

    void select(Pool.Reach reach) {
        for (CompiledPlace place : t.transition.inPlaces) {
            PlaceState state = t.mission.places[place.index];
            if (state != null) {
                selectReturns(state, reach);
                for (Visit v : state.instanceVisits().values()) {
                    if (v.complete()) {
                        selectVisit(v);
                    }
                }
            }
        }
        if (!requirement.takesAll() && left > 0) {
            result.shortOf.add((requirement.n() - left) + " of " + requirement.n() + " sub-mission tokens");
        }
    }

    private void selectReturns(PlaceState state, Pool.Reach reach) {
        if (state.shared.length == 0) {
            return;
        }
        List<Entry> entries = rules.pool.returned(state);
        for (SharedRun run : state.shared) {
            SharedRun.Return oldest = run.returns.peek();
            if (oldest == null || reach == Pool.Reach.ALL) {
                continue;
            }
            for (Token token : oldest.tokens()) {
                Entry standing = null;
                for (Entry e : entries) {
                    if (e.token.equals(token) && e.pickedBy != pick) {
                        standing = e;
                        break;
                    }
                }
                use(run.instance, token, standing);
            }
        }
    }

    private void selectVisit(Visit v) {
        for (Instance instance : v.instances) {
            for (Token token : instance.returned) {
                use(instance, token, standing(v, token));
            }
        }
    }

    private Entry standing(Visit v, Token token) {
        for (Entry e = v.first; e != null; e = e.nextOfVisit) {
            if (e.pickedBy != pick && e.token.equals(token)) {
                return e;
            }
        }
        return null;
    }

    private void use(Instance instance, Token token, Entry standing) {
        if (left == 0) {
            return;
        }
        left--;
        if (standing != null) {
            standing.pickedBy = pick;
            Selection.use(standing, requirement.action(), out, result, added, firing, edge);
            return;
        }
        if (requirement.action() != Action.ADD) {
            useUp(new Selection.UsedReturn(instance, token));
        }
        if (requirement.action() != Action.CONSUME && (token.equals(Token.GENERIC) || !added.contains(token))) {
            Selection.make(token, out, result, added);
        }
    }

    /** Each requirement selects from the same tokens: what several select is used up once. */
    private void useUp(Selection.UsedReturn token) {
        used.add(token);
        if (Collections.frequency(result.usedReturns, token) < Collections.frequency(used, token)) {
            result.usedReturns.add(token);
        }
    }
}
