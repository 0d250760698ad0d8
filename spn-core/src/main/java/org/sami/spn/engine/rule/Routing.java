package org.sami.spn.engine.rule;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sami.spn.engine.net.CompiledInput;
import org.sami.spn.engine.net.CompiledPlace;
import org.sami.spn.engine.net.CompiledTransition;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NamedToken;
import org.sami.spn.engine.state.PendingOccurrence;
import org.sami.spn.engine.state.PlaceState;
import org.sami.spn.engine.state.SentActivation;
import org.sami.spn.engine.state.TransitionState;
import org.sami.spn.engine.state.Visit;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Reserved;
import org.sami.spn.vocabulary.TokenNeed;

/**
 * Brings an occurrence to every transition that it is for. An answer goes straight from its activation to the
 * transitions of its place, news to the missions whose plans speak of it: the cost does not grow with robots or
 * missions that it does not concern.
 *
 * <p>Implements R-OCC-2, R-OCC-3, R-OCC-4, R-OCC-5, R-OCC-6, R-OCC-8, R-OCC-10, R-OCC-11, R-OCC-12.
 */
public final class Routing {
    /** What became of an occurrence at one or more transitions. */
    private static final class Fate {
        /** Robots that the question offered because they stood in its place. */
        final List<String> offered;

        /** Whom the answer names and who is gone, for transitions that took it. */
        Set<Token> gone = Set.of();

        /** The same, for transitions that refused it as it names nobody else. */
        Set<Token> onlyGone = Set.of();

        boolean received;
        boolean namesNobody;

        Fate(List<String> offered) {
            this.offered = offered;
        }
    }

    private final RuleStep step;
    private final Enabling enabling;
    private final PendingOccurrences pendings;

    Routing(RuleStep step, Enabling enabling, PendingOccurrences pendings) {
        this.step = step;
        this.enabling = enabling;
        this.pendings = pendings;
    }

    /** Brings an occurrence to the transitions that it is for, or notes why there is none; returns whether there is one. */
    public boolean route(Occurrence o) {
        return route(o, List.of());
    }

    /**
     * The same for an answer to a choice of robots.
     *
     * @param offered robots that the choice offered because they stood in its place
     */
    boolean route(Occurrence o, List<String> offered) {
        int type = step.project().knownTypeId(o.type());
        SentActivation sent = o.activation() == Ids.NONE ? null : step.state.sent.get(o.activation());
        Fate fate = new Fate(offered);
        if (type >= 0) {
            if (o.activation() == Ids.NONE) {
                news(o, type, null, fate);
            } else if (sent != null && (o.mission() == Ids.NONE || o.mission() == sent.activation.mission())) {
                if (o.mission() == Ids.NONE) {
                    news(o, type, sent, fate);
                } else {
                    answer(o, type, sent, fate);
                }
            } else if (sent == null && o.mission() == Ids.NONE) {
                news(o, type, null, fate);
            }
        }
        if (!fate.received) {
            discarded(o, sent, fate);
        } else if (sent != null && !fate.gone.isEmpty()) {
            step.note(
                    NoteKind.GONE,
                    sent.activation.mission(),
                    o.type() + " is taken without " + TokenWords.of(List.copyOf(fate.gone)) + ", who is gone");
        }
        return fate.received;
    }

    /**
     * Whether all robots that an answer names are gone for all transitions that wait for it, and these require some.
     *
     * @param offered robots that the question offered because they stood in its place
     * @param isChoice whether an answer that names nobody is none, whatever transitions ask for (R-DEC-5)
     */
    boolean namesOnlyGone(Occurrence o, SentActivation sent, List<String> offered, boolean isChoice) {
        int type = step.project().knownTypeId(o.type());
        boolean onlyGone = false;
        for (CompiledTransition t : sent.visit.place.place.outTransitions) {
            for (CompiledInput input : t.inputs) {
                if (input.typeId == type && !input.isPress() && o.namesSomebody()) {
                    TransitionState state = sent.mission().transition(t.index);
                    List<Token> names = PendingOccurrences.names(o, input.role);
                    PendingOccurrence p = pendings.make(state, input, o, names, sent, null);
                    pendings.strikeGone(state, p, offered);
                    if (p.names.length > 0 || !(isChoice || asksForNames(t, o))) {
                        return false;
                    }
                    onlyGone = true;
                }
            }
        }
        return onlyGone;
    }

    private void answer(Occurrence o, int type, SentActivation sent, Fate fate) {
        MissionState m = sent.mission();
        if (!m.runs()) {
            return;
        }
        for (CompiledTransition t : sent.visit.place.place.outTransitions) {
            for (CompiledInput input : t.inputs) {
                if (input.typeId == type) {
                    offer(m, t, input, o, sent, fate);
                }
            }
        }
    }

    /** News to one mission or to all, in order of their ids; an answer in the mission that asked. */
    private void news(Occurrence o, int type, @Nullable SentActivation asked, Fate fate) {
        if (o.mission() != Ids.NONE) {
            MissionState m = step.state.missions.get(o.mission());
            if (m != null) {
                newsIn(m, o, type, fate);
            }
            return;
        }
        for (MissionState m : step.state.attentive(type).values()) {
            if (asked != null && m == asked.mission()) {
                answer(o, type, asked, fate);
            } else {
                newsIn(m, o, type, fate);
            }
        }
    }

    private void newsIn(MissionState m, Occurrence o, int type, Fate fate) {
        if (!m.runs()) {
            return;
        }
        for (CompiledTransition t : m.plan.waitingFor(type)) {
            for (CompiledInput input : t.inputs) {
                if (input.typeId == type) {
                    offer(m, t, input, o, null, fate);
                }
            }
        }
    }

    /** Offers an occurrence to one input event of one transition. */
    private void offer(
            MissionState m,
            CompiledTransition t,
            CompiledInput input,
            Occurrence o,
            @Nullable SentActivation sent,
            Fate fate) {
        if (!fits(input, o) || !isAttentive(m, t)) {
            return;
        }
        TransitionState state = m.transition(t.index);
        List<Token> names = PendingOccurrences.names(o, input.role);
        PendingOccurrence p = pendings.make(state, input, o, names, sent, null);
        List<Token> gone = sent == null || input.isPress() ? List.of() : pendings.strikeGone(state, p, fate.offered);
        if (sent != null && p.names.length == 0 && !input.isPress() && asksForNames(t, o)) {
            fate.namesNobody |= !sent.visit.ended; // else there is no question that stays open: it is late
            fate.onlyGone = with(fate.onlyGone, gone);
            return;
        }
        if (sent != null && !answers(t, p, sent)) {
            return;
        }
        if (t.mustHaveRelevant && (t.inputs.length == 1 || p.names.length > 0) && !anyHere(m, t, p)) {
            return;
        }
        pendings.add(state, p);
        fate.received = true;
        fate.gone = with(fate.gone, gone);
    }

    private static Set<Token> with(Set<Token> before, List<Token> more) {
        if (more.isEmpty()) {
            return before;
        }
        Set<Token> all = new LinkedHashSet<>(before);
        all.addAll(more);
        return all;
    }

    /** Whether an answer must name somebody for a transition. */
    private boolean asksForNames(CompiledTransition t, Occurrence o) {
        return t.speaksOfRelevant && (t.inputs.length == 1 || needsTokens(o));
    }

    /** Whether one of its in places is marked or visited by nobody, or it has none. */
    public static boolean isAttentive(MissionState m, CompiledTransition t) {
        if (t.inPlaces.length == 0) {
            return true;
        }
        for (CompiledPlace place : t.inPlaces) {
            PlaceState state = m.places[place.index];
            if (state != null && state.isVisited()) {
                return true;
            }
        }
        return false;
    }

    private boolean needsTokens(Occurrence o) {
        return step.project()
                .vocabulary
                .event(o.type())
                .map(EventType::tokens)
                .filter(n -> n != TokenNeed.NONE)
                .isPresent();
    }

    private static boolean fits(CompiledInput input, Occurrence o) {
        if (input.selector == null) {
            return true;
        }
        if (input.role == EventRole.CHECK_RETURN) {
            return selected(input, o, Reserved.VALUE);
        }
        return !input.role.isPress() || selected(input, o, Reserved.INTERRUPT_NAME);
    }

    private static boolean selected(CompiledInput input, Occurrence o, String field) {
        Value value = o.values().get(field);
        return value == null || CompiledInput.text(value).equals(input.selector);
    }

    /** Whether somebody it names is still in the visit or in another in place; or the visit goes on, where it names others. */
    private boolean answers(CompiledTransition t, PendingOccurrence p, SentActivation sent) {
        for (NamedToken n : p.names) {
            if (n.stood) {
                return true;
            }
        }
        if (sent.visit.ended) {
            return false;
        }
        for (NamedToken n : p.names) {
            for (Token token : n.tokens) {
                if (sent.activation.tokens().contains(token)) {
                    return false;
                }
            }
        }
        return concerns(t, sent.visit);
    }

    /** Whether somebody, or nobody, is in a visit whose absence is not all that a transition asks for. */
    private boolean concerns(CompiledTransition t, Visit visit) {
        if (visit.byNobody || !t.wantsNone) {
            return true;
        }
        for (Token token : visit.left()) {
            if (!enabling.wantsAbsence(t, visit.place.place, token, false)) {
                return true;
            }
        }
        return false;
    }

    private boolean anyHere(MissionState m, CompiledTransition t, PendingOccurrence p) {
        for (NamedToken n : p.names) {
            for (Token token : n.tokens) {
                for (CompiledPlace place : t.inPlaces) {
                    PlaceState state = m.places[place.index];
                    if (state != null && state.has(token) && !enabling.wantsAbsence(t, place, token, true)) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private void discarded(Occurrence o, @Nullable SentActivation sent, Fate fate) {
        EventType type = step.project().vocabulary.event(o.type()).orElse(null);
        if (type != null && type.flags().contains(EventFlag.COALESCE)) {
            Long before = step.state.discardedNews.get(type.name());
            step.state.discardedNews.put(type.name(), before == null ? 1 : before + 1);
            return;
        }
        long mission = o.mission() != Ids.NONE || sent == null ? o.mission() : sent.activation.mission();
        if (type != null && type.role().isInterrupt()) {
            new UntakenPresses(step).note(o);
        } else if (fate.namesNobody && !fate.onlyGone.isEmpty()) {
            String who = TokenWords.of(List.copyOf(fate.onlyGone));
            step.note(
                    NoteKind.DISCARDED,
                    mission,
                    o.type() + " is discarded: it names nobody but " + who + ", who is gone");
        } else if (fate.namesNobody) {
            step.note(NoteKind.NAMES_NOBODY, mission, o.type() + " names nobody though robots or tasks were asked for");
        } else if (o.activation() != Ids.NONE && (sent == null || !sent.open)) {
            step.note(
                    NoteKind.LATE,
                    mission,
                    o.type() + " answers activation " + o.activation() + ", whose visit has ended");
        } else {
            step.note(NoteKind.DISCARDED, mission, "No transition waits for " + o.type() + named(o));
        }
    }

    private static String named(Occurrence o) {
        List<String> names = new ArrayList<>(o.proxies());
        o.tasks().forEach(t -> names.add(t.name()));
        return names.isEmpty() ? "" : " of " + String.join(", ", names);
    }
}
