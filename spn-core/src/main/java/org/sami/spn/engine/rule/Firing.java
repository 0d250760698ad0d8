package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.net.Reach;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.model.InRequirement;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;

/**
 * Fires transitions (thesis, Algorithm 2).
 *
 * <p>Implements R-OUT-7, R-VIS-2, R-VIS-4, R-VIS-7, R-LOOK-4, R-LOOK-7, R-LOOK-9, R-INT-6, R-END-3, R-FIRE-1,
 * R-FIRE-2, R-FIRE-3, R-SHR-3.
 */
public final class Firing {
    private final RuleStep step;
    private final MissionRules rules;
    private final Selection selection;
    private final Combinations combinations;

    Firing(RuleStep step, MissionRules rules) {
        this.step = step;
        this.rules = rules;
        this.selection = new Selection(rules.enabling, rules.pool);
        this.combinations = new Combinations(rules.enabling);
    }

    public void newChain() {
        step.state.chain++;
    }

    /** Looks at a transition whose turn it is on the work list. */
    public void lookAt(TransitionState t) {
        if (!t.transition.hasInputs()) {
            if (rules.enabling.isEnabled(t, RelevantTokens.NOBODY, FiringScope.FREE) && mayFire(t)) {
                fire(t, List.of(), RelevantTokens.NOBODY, FiringScope.FREE);
            }
            return;
        }
        if (t.pending > 0) {
            Combinations.Found found = combinations.find(t);
            if (found != null && mayFire(t)) {
                fire(t, found.used(), found.relevant(), found.scope());
                if (t.pending > 0 && t.mission.runs()) {
                    rules.work.add(t);
                }
            }
            rules.interrupts.refuseKept(t);
        }
    }

    private boolean mayFire(TransitionState t) {
        MissionState m = t.mission;
        if (m.chainNumber != step.state.chain) {
            m.chainNumber = step.state.chain;
            m.chain = 0;
        }
        if (m.chain >= step.project().livelockLimit) {
            rules.missionEnd.halt(
                    m, m.chain + " firings without new input, the next would be '" + t.transition + "': a livelock");
            return false;
        }
        m.chain++;
        return true;
    }

    /** Tokens that copy themselves would fill the memory long before their firings are counted as a livelock. */
    private boolean addsTooMany(SelectedTokens selected) {
        long added = 0;
        for (List<Token> one : selected.added) {
            added += one.size();
        }
        return added > step.project().mostTokensAdded();
    }

    private void fire(TransitionState t, List<PendingOccurrence> used, RelevantTokens relevant, FiringScope scope) {
        MissionState m = t.mission;
        CompiledTransition ct = t.transition;
        SelectedTokens selected = selection.select(t, relevant, scope);
        if (addsTooMany(selected)) {
            rules.missionEnd.halt(
                    m,
                    m.chain + " firings without new input: '" + t.transition + "' would add more than "
                            + step.project().mostTokensAdded() + " tokens at once");
            return;
        }
        long before = step.state.stamp;
        step.state.firings++;
        m.firings++;
        List<Occurrence> occurrences = new ArrayList<>(used.size());
        for (PendingOccurrence p : used) {
            occurrences.add(p.occurrence);
            t.remove(p);
            rules.interrupts.taken(p);
        }
        step.emit(new Effect.Fired(step.state.firings, m.id, ct.id(), occurrences, selected.moves));
        for (String shortOf : selected.shortOf) {
            step.note(NoteKind.SHORT_OF_TOKENS, m.id, "'" + ct + "' found " + shortOf);
        }
        boolean ending = ends(m, ct);
        List<Visit> nobody = endingVisitsByNobody(m, ct, used, scope.reach);
        List<PlacedToken> removed = selected.removed;
        List<Visit> entered = move(m, ct, selected);
        if (scope.reach == Reach.ALL) {
            withdrawCommands(m, removed);
        }
        List<Return> returns = useReturns(m, ct, selected, scope);
        for (PlacedToken e : removed) {
            rules.removal.left(e, before, scope.reach != Reach.FREE);
        }
        if (scope.reach != Reach.FREE) {
            rules.sharedInstances.pulled(removed, returns, before);
        }
        for (Visit v : nobody) {
            rules.visits.end(v);
        }
        rules.robotRemoval.askWithoutWithdrawn();
        if (!removed.isEmpty() && !m.decisions.isEmpty()) {
            rules.robotChoices.left(m);
        }
        write(m, used);
        if (ending) {
            rules.missionEnd.lastWords(m);
        }
        for (Visit v : entered) {
            rules.activating.activate(v, ending);
        }
        if (ending) {
            rules.missionEnd.ended(m);
            rules.work.addWithdrawn();
            return;
        }
        boolean shared = m.instance != null && m.instance.isShared();
        for (Visit v : entered) {
            if (!shared || !v.place.place.isEnd()) {
                rules.subMissions.entered(v);
            }
        }
        // a return is given when the firing is complete, as a mission ends
        for (Visit v : entered) {
            if (shared && v.place.place.isEnd()) {
                rules.sharedInstances.returned(m, v);
            }
        }
        lookAround(t, entered, removed);
    }

    private static boolean ends(MissionState m, CompiledTransition t) {
        if (m.instance != null && m.instance.isShared()) {
            for (CompiledTransition.Out out : t.outs) {
                if (out.place().isEnd() && out.place().place.endsSharedInstance()) {
                    return true;
                }
            }
            return false;
        }
        for (CompiledTransition.Out out : t.outs) {
            if (out.place().isEnd()) {
                return true;
            }
        }
        return false;
    }

    /** Removes, then adds; the visits that begin, in out-edge order. */
    private List<Visit> move(MissionState m, CompiledTransition t, SelectedTokens selected) {
        rules.removal.remove(selected.removed);
        List<Visit> entered = new ArrayList<>(t.outs.length);
        for (int i = 0; i < t.outs.length; i++) {
            CompiledTransition.Out out = t.outs[i];
            List<Token> tokens = selected.added.get(i);
            if (!tokens.isEmpty() || out.unconditional() || out.place().isEnd()) {
                entered.add(rules.visits.begin(m.place(out.place().index), tokens));
            }
        }
        return entered;
    }

    /** Uses up completions and returns of sub-missions; the returns of static instances that it used, with what it used of them. */
    private List<Return> useReturns(MissionState m, CompiledTransition t, SelectedTokens selected, FiringScope scope) {
        for (SelectedTokens.UsedReturn used : selected.usedReturns) {
            used.instance().returned.remove(used.token());
        }
        List<Return> result = List.of();
        for (CompiledPlace place : t.inPlaces) {
            PlaceState state = m.places[place.index];
            if (state == null) {
                continue;
            }
            if (t.wantsSubTokens && scope.reach != Reach.ALL) {
                Visit bound = scope.visitIn(state);
                for (Visit v : state.instanceVisits().values()) {
                    v.used |= v.complete() && (bound == null || bound == v);
                }
            }
            PairedReturns paired = PairedReturns.in(state, scope);
            if (paired != null) {
                for (Return used : paired.returns) {
                    result = result.isEmpty() ? new ArrayList<>() : result;
                    result.add(new Return(used.instance, paired.tokens, used.value));
                    rules.sharedInstances.used(used, paired.tokens);
                }
            }
        }
        for (Return checked : scope.checked) {
            rules.pendings.over(checked);
        }
        return result;
    }

    private void withdrawCommands(MissionState m, List<PlacedToken> removed) {
        Set<String> robots = new LinkedHashSet<>();
        for (PlacedToken e : removed) {
            if (e.token instanceof Token.Proxy proxy) {
                robots.add(proxy.proxy());
            } else if (e.token instanceof Token.Task task) {
                TaskState state = step.task(task.task());
                if (state != null && !state.proxy().isEmpty()) {
                    robots.add(state.proxy());
                }
            }
        }
        if (!robots.isEmpty()) {
            step.emit(new Effect.CommandsWithdrawn(m.id, List.copyOf(robots)));
        }
    }

    /**
     * Visits by nobody end by an answer to them, by a transition without input event, or when all is taken. Where several visits of
     * a place have instances, one completion lets the transition fire: whose instances still run goes on.
     */
    private static List<Visit> endingVisitsByNobody(
            MissionState m, CompiledTransition t, List<PendingOccurrence> used, Reach reach) {
        List<Visit> ending = List.of();
        for (CompiledPlace place : t.inPlaces) {
            PlaceState state = m.places[place.index];
            if (state == null || state.byNobody().isEmpty()) {
                continue;
            }
            for (Visit v : state.byNobody()) {
                boolean goesOn = reach != Reach.ALL && v.hasRunning();
                if (!goesOn && (!t.hasInputs() || t.clears || answers(used, v))) {
                    ending = ending.isEmpty() ? new ArrayList<>() : ending;
                    ending.add(v);
                }
            }
        }
        return ending;
    }

    private static boolean answers(List<PendingOccurrence> used, Visit v) {
        for (PendingOccurrence p : used) {
            if (p.visit() == v) {
                return true;
            }
        }
        return false;
    }

    private void write(MissionState m, List<PendingOccurrence> used) {
        for (PendingOccurrence p : used) {
            for (Map.Entry<String, String> write : p.input.writes) {
                Value value = p.occurrence.values().get(write.getKey());
                if (value != null) {
                    rules.scopes.write(m, write.getValue(), value);
                }
            }
        }
    }

    /** Puts on the work list what this firing gave occasion to look at. */
    private void lookAround(TransitionState t, List<Visit> entered, List<PlacedToken> removed) {
        for (Visit v : entered) {
            rules.work.entered(v.place);
        }
        MissionState m = t.mission;
        for (CompiledPlace place : t.transition.inPlaces) {
            PlaceState state = m.places[place.index];
            if (state != null) {
                if (anyFrom(removed, state)) {
                    rules.work.left(state);
                }
                for (SharedRun run : state.shared) {
                    if (!run.returns.isEmpty()) {
                        rules.work.entered(state);
                    }
                }
            }
        }
        rules.work.addWithdrawn();
        if (!t.transition.hasInputs() && removedCounted(t.transition, removed)) {
            rules.work.add(t);
        }
    }

    private static boolean anyFrom(List<PlacedToken> removed, PlaceState place) {
        for (PlacedToken e : removed) {
            if (e.place() == place) {
                return true;
            }
        }
        return false;
    }

    /** Occasion (d). */
    private boolean removedCounted(CompiledTransition t, List<PlacedToken> removed) {
        for (PlacedToken e : removed) {
            for (CompiledTransition.In in : t.ins) {
                if (in.place() == e.place().place) {
                    for (InRequirement r : in.requirements()) {
                        if (rules.enabling.counts(r, e)) {
                            return true;
                        }
                    }
                }
            }
        }
        return false;
    }
}
