package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.PlacedToken;
import org.sami.spn.engine.state.Return;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.SharedRun;
import org.sami.spn.engine.state.TaskState;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Reserved;

/**
 * Occurrences that transitions have received and not used.
 *
 * <p>Implements R-REL-1, R-REL-3, R-OCC-12, R-PEND-1, R-PEND-2, R-PEND-3, R-PEND-4, R-RET-1, R-RET-4.
 */
public final class PendingOccurrences {
    private static final NamedToken[] NOBODY = {};
    private final RuleStep step;
    private final Enabling enabling;
    private final FiringAgenda work;

    PendingOccurrences(RuleStep step, Enabling enabling, FiringAgenda work) {
        this.step = step;
        this.enabling = enabling;
        this.work = work;
    }

    /** What an occurrence names: its tasks; where it has none, its robots. Of an aborted child, all. */
    public static List<Token> names(Occurrence o, EventRole role) {
        if (o.tasks().isEmpty() && o.proxies().isEmpty()) {
            return List.of();
        }
        if (o.tasks().isEmpty() && o.proxies().size() == 1) {
            return List.of(new Token.Proxy(o.proxies().get(0)));
        }
        List<Token> result = new ArrayList<>();
        for (TaskId task : o.tasks()) {
            addOnce(result, new Token.Task(task));
        }
        if (o.tasks().isEmpty() || role == EventRole.SUB_MISSION_ABORTED) {
            java.util.Set<String> seen = new java.util.LinkedHashSet<>(o.proxies());
            seen.forEach(p -> result.add(new Token.Proxy(p)));
        }
        return result;
    }

    /** Makes the pending occurrence of a transition, with its names; it is not added yet. */
    public PendingOccurrence make(
            TransitionState t,
            CompiledInput input,
            Occurrence o,
            List<Token> names,
            @Nullable SentActivation answered,
            @Nullable Visit bound) {
        PendingOccurrence p = new PendingOccurrence(o, input, answered, bound);
        p.names = names.isEmpty() ? NOBODY : new NamedToken[names.size()];
        p.namesLeft = p.names.length;
        for (int i = 0; i < p.names.length; i++) {
            NamedToken n = new NamedToken(names.get(i));
            n.tokens = tokensOf(n.token, answered);
            n.stood = stands(n, t, p.visit());
            p.names[i] = n;
        }
        return p;
    }

    /**
     * Strikes from an answer, which is not added yet, the tokens that the question named and that are gone since; returns them.
     *
     * @param offered robots that the question offered because they stood in its place; it named them too
     */
    public List<Token> strikeGone(TransitionState t, PendingOccurrence p, List<String> offered) {
        SentActivation asked = p.answered;
        if (asked == null) {
            return List.of(); // news answers no question
        }
        List<Token> gone = List.of();
        for (NamedToken n : p.names) {
            if (!n.stood && wasNamed(n, asked, offered) && !isIn(asked.visit, n)) {
                gone = gone.isEmpty() ? new ArrayList<>() : gone;
                gone.add(n.token);
            }
        }
        if (!gone.isEmpty()) {
            List<NamedToken> left = new ArrayList<>();
            for (NamedToken n : p.names) {
                if (!gone.contains(n.token)) {
                    left.add(n);
                }
            }
            p.names = left.isEmpty() ? NOBODY : left.toArray(NamedToken[]::new);
            p.namesLeft = p.names.length;
        }
        return gone;
    }

    /** Whether a question or request named somebody: who entered, whose task did, or who was offered. */
    private static boolean wasNamed(NamedToken n, SentActivation asked, List<String> offered) {
        for (Token token : n.tokens) {
            if (asked.activation.tokens().contains(token)) {
                return true;
            }
        }
        return n.token instanceof Token.Proxy robot
                && (asked.activation.proxies().contains(robot.proxy()) || offered.contains(robot.proxy()));
    }

    /** Whether a token of a name is in a visit; in the place of a visit by nobody. */
    private static boolean isIn(Visit visit, NamedToken n) {
        for (Token token : n.tokens) {
            if (visit.byNobody ? visit.place.has(token) : !visit.ended && visit.has(token)) {
                return true;
            }
        }
        return false;
    }

    public void add(TransitionState t, PendingOccurrence p) {
        if (p.visit() != null) {
            for (NamedToken n : p.names) {
                n.stood = n.stood || isIn(p.visit(), n);
            }
        }
        if (p.isNews() && !p.input.isPress()) {
            replaceOlder(t, p);
        }
        t.add(p);
        work.add(t);
    }

    /** Tells all transitions that check it the value of a return: one occurrence for all of them. */
    public void tell(Return r) {
        MissionState m = r.place().mission;
        if (r.over || !m.runs() || (r.visit() != null && r.visit().ended)) {
            return;
        }
        for (CompiledTransition t : r.place().place.outTransitions) {
            for (CompiledInput input : t.inputs) {
                if (input.checks(r.value, r.instance.plan())) {
                    Map<String, Value> values = Map.of(Reserved.VALUE, new TextValue(r.value));
                    Occurrence o = new Occurrence(input.spec.type(), m.id, Ids.NONE, List.of(), List.of(), values);
                    add(m.transition(t.index), new PendingOccurrence(o, input, r));
                }
            }
        }
    }

    /** Tells all unused returns of static instances again. */
    public void tellUnused() {
        for (MissionState m : step.state.missions.values()) {
            for (PlaceState place : m.places) {
                for (SharedRun run : place == null ? new SharedRun[0] : place.shared) {
                    run.returns.forEach(this::tell);
                }
            }
        }
    }

    /** A return was used or is void: no transition hears of its value any longer. */
    public void over(Return r) {
        r.over = true;
        for (CompiledTransition ct : r.place().place.outTransitions) {
            TransitionState t = r.place().mission.transitions[ct.index];
            if (t == null || !ct.checksReturns) {
                continue;
            }
            for (TransitionState.Queue q : t.queues) {
                for (PendingOccurrence p = q.first; p != null; p = p.next) {
                    if (p.told == r) {
                        t.remove(p);
                    }
                }
            }
        }
    }

    /** The tokens that a name speaks of. */
    public Token[] tokensOf(Token name, @Nullable SentActivation answered) {
        if (answered != null && name instanceof Token.Proxy proxy && answered.hasTasks) {
            List<Token> result = new ArrayList<>();
            result.add(name);
            for (Token token : answered.activation.tokens()) {
                if (token instanceof Token.Task task) {
                    TaskState state = step.task(task.task());
                    if (state != null && state.proxy().equals(proxy.proxy())) {
                        addOnce(result, token);
                    }
                }
            }
            return result.toArray(Token[]::new);
        }
        return new Token[] {name};
    }

    /**
     * One copy of a token left a place, its firing is complete: occurrences that named it may have to be struck.
     *
     * @param before the stamp before the firing: what entered later has a greater order
     */
    public void left(PlaceState place, Token token, long before) {
        for (CompiledTransition ct : place.place.outTransitions) {
            TransitionState t = place.mission.transitions[ct.index];
            if (t != null && t.pending > 0) {
                List<TransitionState.Speaking> speaking = t.speakingOf(token);
                for (int i = speaking.size() - 1; i >= 0; i--) {
                    if (i < speaking.size()) {
                        strikeIfGone(t, speaking.get(i), place, before);
                    }
                }
            }
        }
    }

    /** Strikes a name from a transition's pending occurrences, news too (a robot was dropped); whether one spoke of it. */
    public boolean strikeAll(TransitionState t, Token token) {
        boolean spoken = false;
        for (TransitionState.Speaking speaking : List.copyOf(t.speakingOf(token))) {
            if (speaking.name().token.equals(token) && !speaking.name().struck) {
                strike(t, speaking);
                spoken = true;
            }
        }
        return spoken;
    }

    /** A visit ended: pending occurrences that answer it and name nobody go with it. */
    public void visitEnded(Visit visit) {
        MissionState mission = visit.place.mission;
        for (CompiledTransition ct : visit.place.place.outTransitions) {
            TransitionState t = mission.transitions[ct.index];
            if (t == null || t.nameless == 0) {
                continue;
            }
            for (TransitionState.Queue q : t.queues) {
                for (PendingOccurrence p = q.first; p != null; p = p.next) {
                    if (p.names.length == 0 && p.visit() == visit) {
                        t.remove(p);
                        if (p.told == null) { // a return's value goes with the return, which is reported
                            discarded(t, p);
                        }
                    }
                }
            }
        }
    }

    /** An allocation changed: names of robots may speak of other tasks now. */
    public void renewNames(TransitionState t) {
        for (TransitionState.Queue q : t.queues) {
            for (PendingOccurrence p = q.first; p != null; p = p.next) {
                if (p.answered != null && p.answered.hasTasks) {
                    for (NamedToken n : p.names) {
                        if (!n.struck) {
                            t.renew(p, n, tokensOf(n.token, p.answered));
                        }
                    }
                }
            }
        }
    }

    private void strikeIfGone(TransitionState t, TransitionState.Speaking speaking, PlaceState left, long before) {
        NamedToken n = speaking.name();
        Visit visit = speaking.pending().visit();
        boolean gone = speaking.pending().isNews()
                ? watches(t, left) && !standsOn(n, t, left, before)
                : n.stood && !stands(n, t, visit) && (visit == null || !isIn(visit, n));
        if (gone) {
            strike(t, speaking);
        }
    }

    private static boolean watches(TransitionState t, PlaceState left) {
        for (CompiledTransition watching : left.place.barriers) {
            if (watching == t.transition) {
                return true;
            }
        }
        return false;
    }

    /** Whether a token of a name stands in a watched place, other than as a copy that entered the left place just now. */
    private boolean standsOn(NamedToken n, TransitionState t, PlaceState left, long before) {
        for (Token token : n.tokens) {
            for (CompiledPlace place : t.transition.watched) {
                PlaceState state = t.mission.places[place.index];
                PlacedToken oldest = state == null ? null : state.find(token);
                if (oldest != null && (state != left || oldest.order() <= before)) {
                    return true;
                }
            }
        }
        return false;
    }

    private void strike(TransitionState t, TransitionState.Speaking speaking) {
        PendingOccurrence p = speaking.pending();
        t.strike(p, speaking.name());
        if (p.namesLeft == 0) {
            t.remove(p);
            discarded(t, p);
        }
    }

    /** Whether a token of a name is in the answered visit or in another in place of the transition. */
    private boolean stands(NamedToken n, TransitionState t, @Nullable Visit visit) {
        for (Token token : n.tokens) {
            if (visit != null && enabling.wantsAbsence(t.transition, visit.place.place, token, true)) {
                continue;
            }
            if (visit != null && !visit.ended && visit.has(token)) {
                return true;
            }
            for (CompiledPlace place : t.transition.inPlaces) {
                PlaceState state = t.mission.places[place.index];
                if (state != null
                        && (visit == null || state != visit.place)
                        && state.has(token)
                        && !enabling.wantsAbsence(t.transition, place, token, true)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** There can be two older ones of the same names: one of them spoke of others too, who are no longer there. */
    private void replaceOlder(TransitionState t, PendingOccurrence p) {
        if (p.names.length == 0) {
            for (PendingOccurrence old = t.queues[p.input.index].first; t.nameless > 0 && old != null; old = old.next) {
                if (old.isNews() && old.names.length == 0) {
                    t.remove(old);
                    return;
                }
            }
            return;
        }
        for (TransitionState.Speaking speaking : List.copyOf(t.speakingOf(p.names[0].token))) {
            PendingOccurrence old = speaking.pending();
            if (old.isNews() && old.input == p.input && namesSame(old, p)) {
                t.remove(old);
            }
        }
    }

    /** Whether two pending occurrences name the same robots or tasks. */
    public static boolean namesSame(PendingOccurrence a, PendingOccurrence b) {
        if (a.namesLeft != b.namesLeft) {
            return false;
        }
        for (NamedToken n : a.names) {
            if (!n.struck && !names(b, n.token)) {
                return false;
            }
        }
        return true;
    }

    private static boolean names(PendingOccurrence p, Token token) {
        for (NamedToken n : p.names) {
            if (!n.struck && n.token.equals(token)) {
                return true;
            }
        }
        return false;
    }

    private void discarded(TransitionState t, PendingOccurrence p) {
        step.note(
                NoteKind.DISCARDED,
                t.mission.id,
                p.occurrence.type() + " at '" + t.transition
                        + "' is discarded: nobody it speaks of is there any longer");
    }

    private static void addOnce(List<Token> list, Token token) {
        if (!list.contains(token)) {
            list.add(token);
        }
    }
}
