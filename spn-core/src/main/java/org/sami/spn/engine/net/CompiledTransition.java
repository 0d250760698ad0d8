package org.sami.spn.engine.net;

import java.util.List;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.vocabulary.EventRole;

/** A transition with its edges; what the rules ask of it again and again is worked out here. */
@SuppressWarnings("ArrayRecordComponent") // read in the innermost loops, never compared and never handed out
public final class CompiledTransition {
    /** An in edge. */
    public record In(CompiledPlace place, InRequirement[] requirements) {}

    /** An out edge; unconditional also where it has no requirement at all. */
    public record Out(CompiledPlace place, OutRequirement[] requirements, boolean unconditional) {}

    public final int index;
    public final Transition transition;
    public final CompiledInput[] inputs;
    public final In[] ins;
    public final Out[] outs;
    /** In places, each once, in in-edge order. */
    public final CompiledPlace[] inPlaces;

    private final Reach reach;
    public final boolean waitsForAll;
    /** Places in which every robot must report; empty where it does not wait for all. */
    public final CompiledPlace[] watched;
    /** Whether an in requirement wants relevant tokens to be there. */
    public final boolean mustHaveRelevant;
    /** Whether any requirement speaks of relevant tokens. */
    public final boolean speaksOfRelevant;
    /** Whether an out requirement speaks of sub-mission tokens. */
    public final boolean wantsSubTokens;
    /** Whether an in requirement asks that no token of its kind is there. */
    public final boolean wantsNone;
    /** Whether an input event checks the return value of a sub-mission. */
    public final boolean checksReturns;
    /** Whether an out requirement takes or consumes all tokens of any kind. */
    public final boolean clears;

    public CompiledTransition(int index, Transition transition, CompiledInput[] inputs, In[] ins, Out[] outs) {
        this.index = index;
        this.transition = transition;
        this.inputs = inputs;
        this.ins = ins;
        this.outs = outs;
        this.inPlaces = List.of(ins).stream().map(In::place).distinct().toArray(CompiledPlace[]::new);
        this.reach = reachOf(inputs);
        this.waitsForAll = transition.waitFor() == WaitFor.ALL && inputs.length > 0;
        this.watched = waitsForAll ? watchedPlaces() : new CompiledPlace[0];
        this.mustHaveRelevant = anyIn(r -> r.kind() == TokenKind.RELEVANT && wantsTokens(r));
        this.wantsNone = anyIn(CompiledTransition::wantsNone);
        this.speaksOfRelevant =
                anyIn(r -> r.kind() == TokenKind.RELEVANT) || anyOut(r -> r.kind() == TokenKind.RELEVANT);
        this.wantsSubTokens = anyOut(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS);
        this.checksReturns = List.of(inputs).stream().anyMatch(i -> i.role == EventRole.CHECK_RETURN);
        this.clears = anyOut(
                r -> r.kind() == TokenKind.ANY_TOKEN && r.takesAll() && r.action() != org.sami.spn.model.Action.ADD);
    }

    /** How far its firings reach: what its input events allow. */
    public Reach reach() {
        return reach;
    }

    public boolean hasInputs() {
        return inputs.length > 0;
    }

    public boolean hasInPlace(int place) {
        for (CompiledPlace p : inPlaces) {
            if (p.index == place) {
                return true;
            }
        }
        return false;
    }

    /** Whether fewer tokens in that place can satisfy a requirement. */
    public boolean inhibitedBy(int place) {
        for (In in : ins) {
            if (in.place.index == place) {
                for (InRequirement r : in.requirements) {
                    if (r.match() == Match.ZERO || r.match() == Match.LESS_THAN || r.match() == Match.EXACTLY) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    public String id() {
        return transition.id();
    }

    @Override
    public String toString() {
        return transition.name().isEmpty() ? transition.id() : transition.name();
    }

    private static Reach reachOf(CompiledInput[] inputs) {
        Reach widest = Reach.FREE;
        for (CompiledInput input : inputs) {
            Reach own = Reach.of(input.role);
            widest = own.compareTo(widest) > 0 ? own : widest;
        }
        return widest;
    }

    private CompiledPlace[] watchedPlaces() {
        CompiledPlace[] relevant = List.of(ins).stream()
                .filter(in -> List.of(in.requirements).stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT))
                .map(In::place)
                .distinct()
                .toArray(CompiledPlace[]::new);
        return relevant.length > 0 ? relevant : inPlaces;
    }

    public static boolean wantsTokens(InRequirement r) {
        return r.match() == Match.ALL || ((r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY) && r.n() > 0);
    }

    /** Whether a requirement asks that no token of its kind is there. */
    public static boolean wantsNone(InRequirement r) {
        return r.kind() != TokenKind.UNCONDITIONAL
                && (r.match() == Match.ZERO
                        || (r.match() == Match.LESS_THAN && r.n() <= 1)
                        || (r.match() == Match.EXACTLY && r.n() == 0));
    }

    private boolean anyIn(java.util.function.Predicate<InRequirement> test) {
        for (In in : ins) {
            for (InRequirement r : in.requirements) {
                if (test.test(r)) {
                    return true;
                }
            }
        }
        return false;
    }

    private boolean anyOut(java.util.function.Predicate<OutRequirement> test) {
        for (Out out : outs) {
            for (OutRequirement r : out.requirements) {
                if (test.test(r)) {
                    return true;
                }
            }
        }
        return false;
    }
}
