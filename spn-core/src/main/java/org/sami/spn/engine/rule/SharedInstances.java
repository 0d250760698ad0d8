package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.state.Instance;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.protocol.MissionStatus;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Token;

/**
 * Static sub-missions: one instance per parent mission, joined by entering tokens, returning through end places.
 *
 * <p>Implements R-SHR-1, R-SHR-2, R-SHR-5, R-SHR-7, R-SHR-8.
 */
final class SharedInstances {
    private final MissionRules rules;

    SharedInstances(MissionRules rules) {
        this.rules = rules;
    }

    /** Starts the static instances of a mission, in the plan's order, before its start marking. */
    void start(MissionState m) {
        if (!m.plan.hasShared) {
            return;
        }
        for (CompiledPlace place : m.plan.places) {
            List<SubMissionSpec> specs = place.shared;
            if (specs.isEmpty()) {
                continue;
            }
            if (m.depth >= 100) {
                rules.missionEnd.halt(m, "100 instances within instances");
                return;
            }
            PlaceState state = m.place(place.index);
            state.shared = new SharedRun[specs.size()];
            for (int i = 0; i < specs.size(); i++) {
                state.shared[i] = new SharedRun(new Instance(null, state, i, List.of()));
            }
            for (int i = 0; i < specs.size(); i++) {
                MissionState child = rules.subMissions.make(state.shared[i].instance, specs.get(i));
                if (child != null) {
                    rules.missionStart.ask(child, rules.missionStart.parametersOf(child.plan));
                }
            }
        }
    }

    /** Tokens, or nobody, that entered the parent's place join the start place. */
    void join(SharedRun run, Visit v) {
        MissionState child = run.instance.child;
        if (child == null || child.status == MissionStatus.HALTED) {
            tellThatItIsOver(run.instance, v);
            return;
        }
        run.instance.starting.addAll(v.entered);
        List<Token> tokens = new ArrayList<>();
        v.entered.forEach(token -> tokens.add(ChildTokens.toChild(child, token)));
        if (child.status == MissionStatus.WAITING) {
            child.addWaiting(tokens);
        } else if (child.runs()) {
            rules.missionStart.enter(child, tokens);
        }
    }

    private void tellThatItIsOver(Instance instance, Visit v) {
        if (!v.byNobody) {
            PlaceState place = v.place;
            rules.note(
                    NoteKind.NOT_RETURNED,
                    place.mission.id,
                    "'" + place.place + "' was entered by " + TokenWords.of(v.entered)
                            + " when its shared sub-mission '"
                            + place.place.shared.get(instance.specIndex).plan()
                            + "' was over: nothing comes back from it; an interrupt or an abort takes them out");
        }
    }

    /** Tokens entered an end place that does not end the instance: they leave it as one completion. */
    void returned(MissionState child, Visit v) {
        List<Token> tokens = new ArrayList<>();
        long before = rules.state().stamp;
        List<PlacedToken> entries = v.standing();
        rules.removal.remove(entries);
        for (PlacedToken e : entries) {
            rules.removal.left(e, before, false);
            Token token = ChildTokens.toParent(child, e.token);
            if (token != null) {
                tokens.add(token);
            }
        }
        rules.visits.end(v);
        give(child.asInstance(), tokens, child.returnValue);
    }

    private void give(Instance instance, List<Token> tokens, String value) {
        tokens.forEach(instance.starting::remove);
        Return r = new Return(instance, tokens, value);
        runOf(instance).returns.add(r);
        rules.subMissions.post(r);
        rules.work.entered(instance.place);
    }

    private static SharedRun runOf(Instance instance) {
        for (SharedRun run : instance.place.shared) {
            if (run.instance == instance) {
                return run;
            }
        }
        throw new IllegalArgumentException("Not a static instance of '" + instance.place.place + "'");
    }

    /** A firing used some tokens of a return: others stay unused, with its value, until every instance has returned them. */
    void used(Return r, List<Token> tokens) {
        List<Token> left = new ArrayList<>(r.tokens);
        tokens.forEach(left::remove);
        if (!left.isEmpty()) {
            Return rest = new Return(r.instance, left, r.value);
            List<Return> returns = runOf(r.instance).returns;
            returns.add(returns.indexOf(r) + 1, rest);
            rules.subMissions.post(rest);
        }
        over(r);
    }

    /** A firing used a return, or it is void. */
    private void over(Return r) {
        runOf(r.instance).returns.remove(r);
        rules.pendings.over(r);
    }

    /**
     * Tokens left a place of static instances other than with a return that brought them back: theirs is void, and who is
     * still in the instance is taken out of it, unless a copy stays in the place. Who enters the place again in the same firing
     * has left it before.
     *
     * @param used returns that the firing used: they brought back what left with them
     * @param before the stamp before the firing: what entered later has a greater order
     */
    void pulled(List<PlacedToken> removed, List<Return> used, long before) {
        List<Return> left = new ArrayList<>();
        used.forEach(r -> left.add(new Return(r.instance, r.tokens, r.value)));
        for (PlacedToken e : removed) {
            for (SharedRun run : e.place().shared) {
                boolean broughtBack =
                        left.stream().anyMatch(r -> r.instance == run.instance && r.tokens.remove(e.token));
                if (!broughtBack) {
                    pulled(run, e.token, before);
                }
            }
        }
    }

    private void pulled(SharedRun run, Token token, long before) {
        PlaceState place = run.instance.place;
        if (!voidOldest(run, token)) {
            run.instance.starting.remove(token);
        }
        PlacedToken oldest = place.find(token);
        if (PlacedToken.kindOf(token) == PlacedToken.GENERIC || (oldest != null && oldest.order() <= before)) {
            return;
        }
        forget(run, token);
        MissionState child = run.instance.child;
        if (child != null) {
            rules.robotRemoval.takeOut(child, ChildTokens.toChild(child, token));
        }
    }

    /** Nobody waits for a token any longer. */
    void forget(SharedRun run, Token token) {
        while (voidOldest(run, token)) {
            // once for each copy
        }
        run.instance.starting.removeIf(token::equals);
    }

    /** Strikes a token from the oldest unused return that brought it back; a return of nobody else is void. */
    private boolean voidOldest(SharedRun run, Token token) {
        for (Return r : run.returns) {
            if (r.tokens.remove(token)) {
                rules.note(
                        NoteKind.DISCARDED,
                        run.instance.place.mission.id,
                        "The unused return of " + TokenWords.of(List.of(token)) + " from the sub-mission on '"
                                + run.instance.place.place + "' is void: it was taken out of that place");
                if (r.tokens.isEmpty()) {
                    over(r);
                }
                return true;
            }
        }
        return false;
    }

    /** The shared instance itself ended: what stands in its end places returns. */
    void ended(Instance instance) {
        instance.status = Instance.Status.COMPLETE;
        List<Token> tokens = new ArrayList<>(instance.returned);
        instance.returned.clear();
        give(instance, tokens, instance.returnValue);
    }

    /** The shared instance was aborted; its starting tokens wait for what is decided. */
    void gone(Instance instance) {
        instance.status = Instance.Status.ABORTED;
    }

    /** The starting tokens of an aborted instance count as returned. */
    void giveBack(Instance instance) {
        instance.status = Instance.Status.COMPLETE;
        give(instance, new ArrayList<>(instance.starting), instance.returnValue);
    }
}
