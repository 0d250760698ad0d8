package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Match;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;

/** Who receives an occurrence, and what becomes of it while it waits (R-OCC-1 to R-OCC-11, R-PEND-1 to R-PEND-8). */
final class Attention {
    private final World world;
    private final Enabling enabling;

    Attention(World world, Enabling enabling) {
        this.world = world;
        this.enabling = enabling;
    }

    /** Gives it to all it is for (R-OCC-6), or notes why nobody wants it (R-OCC-11). */
    boolean receive(Occurrence occurrence) {
        return receive(occurrence, List.of());
    }

    /** As the other, for an answer to a question that offered boats which stood there. */
    boolean receive(Occurrence occurrence, List<String> offered) {
        boolean someAreGone = false;
        boolean onlyGone = false;
        boolean wanted = false;
        boolean askedForNames = false;
        for (Mission m : List.copyOf(world.missions)) {
            Optional<Occurrence> here = asSeenBy(m, occurrence);
            if (!m.reacts() || here.isEmpty()) {
                continue;
            }
            for (Transition t : inOrder(m, here.get())) {
                for (InputEventSpec event : t.inputs()) {
                    Pending pending = new Pending(t, event, here.get());
                    if (!typeFits(pending) || !someInPlaceIsMarked(m, t)) {
                        continue;
                    }
                    leaveOutGone(m, pending, offered);
                    boolean refused = namesNobodyWhereAsked(m, pending);
                    onlyGone |= refused && !pending.gone.isEmpty();
                    boolean taken = !refused && isFor(m, pending);
                    if (taken) {
                        keep(m, pending);
                    }
                    askedForNames |= refused;
                    wanted |= taken;
                    someAreGone |= taken && !pending.gone.isEmpty();
                }
            }
        }
        if (!wanted) {
            noteUnwanted(occurrence, askedForNames, onlyGone);
        } else if (someAreGone) {
            world.note(NoteKind.GONE, world.visitOfActivation.get(occurrence.activation()).mission.id, "");
        }
        return wanted;
    }

    // ---- Who is gone (R-OCC-12)

    /** Leaves out of an answer whom its question named and who is no longer where the transition looks. */
    private void leaveOutGone(Mission m, Pending p, List<String> offered) {
        Visit visit = p.isAnswer() ? world.visitOfActivation.get(p.occurrence.activation()) : null;
        boolean isPress = World.isInterrupt(world.eventType(p.event.type()).role());
        if (visit == null || visit.mission != m || isSuperseded(visit) || isPress) {
            return;
        }
        for (Token name : p.names()) {
            if (questionNamed(p, name, offered)
                    && !standsForIt(m, p, visit, name)
                    && !isWhereAsked(m, p, visit, name)) {
                p.gone.add(name);
            }
        }
    }

    private boolean questionNamed(Pending p, Token name, List<String> offered) {
        Activation question = enabling.answered(p);
        boolean entered = enabling.tokensOf(name, p).stream().anyMatch(question.tokens()::contains);
        return entered
                || (name instanceof Token.Proxy boat
                        && (question.proxies().contains(boat.proxy()) || offered.contains(boat.proxy())));
    }

    /** In the visit; where nobody entered, in the place. */
    private boolean isWhereAsked(Mission m, Pending p, Visit visit, Token name) {
        return enabling.tokensOf(name, p).stream()
                .anyMatch(token ->
                        visit.byNobody ? m.stands(token, visit.place) : !visit.ended && m.standsInVisit(token, visit));
    }

    /** Whether all transitions that wait for an answer would refuse it, for whom it names is gone. */
    boolean namesOnlyGone(Occurrence answer, List<String> offered, boolean isChoice) {
        Visit visit = world.visitOfActivation.get(answer.activation());
        List<Pending> all = new ArrayList<>();
        for (Transition t : visit.mission.outTransitions(visit.place)) {
            for (InputEventSpec event : t.inputs()) {
                if (event.type().equals(answer.type())) {
                    Pending p = new Pending(t, event, answer);
                    leaveOutGone(visit.mission, p, offered);
                    all.add(p);
                }
            }
        }
        return answer.namesSomebody()
                && !all.isEmpty()
                && all.stream().allMatch(p -> isChoice ? !p.namesSomebody() : namesNobodyWhereAsked(visit.mission, p));
    }

    /** An answer reaches transitions in the order of the place that asked (R-LOOK-6). */
    private List<Transition> inOrder(Mission m, Occurrence o) {
        Visit asked = world.visitOfActivation.get(o.activation());
        return asked == null || asked.mission != m ? m.plan.transitions() : m.outTransitions(asked.place);
    }

    /** Answer in one mission, news in the others (R-OCC-8). */
    private Optional<Occurrence> asSeenBy(Mission m, Occurrence o) {
        if (o.mission() != Ids.NONE) {
            return o.mission() == m.id ? Optional.of(o) : Optional.empty();
        }
        Visit asked = world.visitOfActivation.get(o.activation());
        if (asked != null && asked.mission == m) {
            return Optional.of(o);
        }
        return Optional.of(Occurrence.news(o.type(), o.proxies(), o.values()))
                .map(n -> new Occurrence(n.type(), Ids.NONE, Ids.NONE, o.proxies(), o.tasks(), o.values()));
    }

    /** Whether an occurrence is for a transition (R-OCC-2 to R-OCC-5). */
    boolean isFor(Mission m, Pending p) {
        return typeFits(p) && someInPlaceIsMarked(m, p.transition) && answersHere(m, p) && someRelevantIsHere(m, p);
    }

    private boolean typeFits(Pending p) {
        return world.eventType(p.event.type()).equals(world.eventType(p.occurrence.type()))
                && p.event.fields().entrySet().stream()
                        .allMatch(f -> f.getValue().equals(p.occurrence.values().get(f.getKey())));
    }

    private static boolean someInPlaceIsMarked(Mission m, Transition t) {
        List<Place> places = m.inPlaces(t);
        return places.isEmpty()
                || places.stream().anyMatch(place -> !m.tokensIn(place).isEmpty() || m.visitedByNobody(place));
    }

    private boolean answersHere(Mission m, Pending p) {
        if (!p.isAnswer()) {
            return true;
        }
        Visit visit = world.visitOfActivation.get(p.occurrence.activation());
        if (visit == null
                || visit.mission != m
                || !m.inPlaces(p.transition).contains(visit.place)
                || isSuperseded(visit)) {
            return false;
        }
        for (Token name : p.names()) {
            if (standsForIt(m, p, visit, name)) {
                return true;
            }
        }
        // names nobody, or none of those that were asked (R-OCC-4)
        List<Token> asked = enabling.answered(p).tokens();
        boolean namesNoneAsked = p.names().stream()
                .flatMap(name -> enabling.tokensOf(name, p).stream())
                .noneMatch(asked::contains);
        boolean concerned = visit.byNobody
                || m.tokensIn(visit.place).stream()
                        .anyMatch(c ->
                                c.visit == visit && !asksOnlyForAbsence(m, p.transition, visit.place, c.token, false));
        return namesNoneAsked && !visit.ended && concerned;
    }

    /** Whether an edge asks only that a token be absent (R-OCC-7). */
    boolean asksOnlyForAbsence(Mission m, Transition t, Place place, Token token, boolean isNamed) {
        Set<Token> relevant = isNamed ? Set.of(token) : Set.of();
        List<InRequirement> ofItsKind = m.inEdges(t).stream()
                .filter(edge -> edge.place().equals(place.id()))
                .flatMap(edge -> edge.requirements().stream())
                .filter(r ->
                        r.kind() == TokenKind.UNCONDITIONAL || enabling.isOfKind(r.kind(), r.task(), token, relevant))
                .toList();
        return ofItsKind.stream().anyMatch(Attention::forbidsAny)
                && ofItsKind.stream().noneMatch(Attention::asksForSome);
    }

    private static boolean forbidsAny(InRequirement r) {
        return switch (r.match()) {
            case ZERO -> true;
            case LESS_THAN -> r.n() < 2;
            case EXACTLY -> r.n() < 1;
            case AT_LEAST, ALL -> false;
        };
    }

    private static boolean asksForSome(InRequirement r) {
        return r.kind() == TokenKind.UNCONDITIONAL
                || r.match() == Match.ALL
                || (r.n() > 0 && (r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY));
    }

    /** Whoever entered it has since ended a later visit to the same place: what was asked first is over for good. */
    private boolean isSuperseded(Visit visit) {
        return visit.ended
                && visit.entered.stream()
                        .filter(token -> !(token instanceof Token.Generic))
                        .allMatch(token -> world.visitOfActivation.values().stream()
                                .anyMatch(later -> later.mission == visit.mission
                                        && later.place.equals(visit.place)
                                        && later.endedAs > visit.endedAs
                                        && later.entered.contains(token)));
    }

    /** Whether a name stands in the visit that asked or in another in place (R-OCC-4). */
    private boolean standsForIt(Mission m, Pending p, Visit visit, Token name) {
        for (Token token : enabling.tokensOf(name, p)) {
            if (asksOnlyForAbsence(m, p.transition, visit.place, token, true)) {
                continue; // this answer is for those who could take it
            }
            if (!visit.ended && m.standsInVisit(token, visit)) {
                return true;
            }
            for (Place other : World.others(m.inPlaces(p.transition), visit.place)) {
                if (m.stands(token, other) && !asksOnlyForAbsence(m, p.transition, other, token, true)) {
                    return true;
                }
            }
        }
        return false;
    }

    /** Whether one of the relevant tokens that it must have stands here (R-OCC-5). */
    private boolean someRelevantIsHere(Mission m, Pending p) {
        boolean mustHave = m.inEdges(p.transition).stream()
                .flatMap(e -> e.requirements().stream())
                .anyMatch(Attention::mustHaveRelevant);
        boolean joinsWithAny = p.names().isEmpty() && p.transition.inputs().size() > 1;
        EventRole role = world.eventType(p.event.type()).role();
        boolean ofTheMission = World.overrides(role) && !World.isInterrupt(role);
        return !mustHave
                || joinsWithAny
                || ofTheMission
                || enabling.relevant(List.of(p)).stream()
                        .anyMatch(token -> m.inPlaces(p.transition).stream()
                                .anyMatch(place -> m.stands(token, place)
                                        && !asksOnlyForAbsence(m, p.transition, place, token, true)));
    }

    private static boolean mustHaveRelevant(InRequirement r) {
        boolean wantsSome =
                r.match() == Match.ALL || ((r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY) && r.n() >= 1);
        return r.kind() == TokenKind.RELEVANT && wantsSome;
    }

    /** Whether it should have named somebody (R-OCC-10). */
    private boolean namesNobodyWhereAsked(Mission m, Pending p) {
        boolean speaks = m.inEdges(p.transition).stream()
                        .flatMap(e -> e.requirements().stream())
                        .anyMatch(r -> r.kind() == TokenKind.RELEVANT)
                || m.outEdges(p.transition).stream()
                        .flatMap(e -> e.requirements().stream())
                        .anyMatch(r -> r.kind() == TokenKind.RELEVANT);
        EventRole role = world.eventType(p.event.type()).role();
        boolean joinsWithAny = p.transition.inputs().size() > 1;
        boolean open = p.answeredVisit(world).filter(visit -> !visit.ended).isPresent();
        return open && !p.namesSomebody() && speaks && !joinsWithAny && !World.overrides(role);
    }

    /** Keeps an occurrence (R-PEND-1). */
    void keep(Mission m, Pending pending) {
        Optional<Visit> answered = pending.answeredVisit(world);
        if (answered.isEmpty() && pending.told.isEmpty()) {
            // of news the newest (R-PEND-2)
            m.pending.removeIf(older -> older.answeredVisit(world).isEmpty()
                    && older.told.isEmpty()
                    && older.transition.equals(pending.transition)
                    && older.event.equals(pending.event)
                    && namedSet(older).equals(namedSet(pending)));
        }
        answered.ifPresent(visit -> pending.names().stream()
                .filter(name -> standsForIt(m, pending, visit, name) || isWhereAsked(m, pending, visit, name))
                .forEach(pending.stood::add));
        m.pending.add(pending);
        world.lookAt(m, pending.transition);
    }

    private static Set<Token> namedSet(Pending p) {
        return new HashSet<>(p.names());
    }

    private void noteUnwanted(Occurrence occurrence, boolean askedForNames, boolean onlyGone) {
        Visit visit = world.visitOfActivation.get(occurrence.activation());
        long mission = occurrence.mission() == Ids.NONE && visit != null ? visit.mission.id : occurrence.mission();
        if (world.eventType(occurrence.type()).flags().contains(EventFlag.COALESCE)) {
            return; // counted, not noted (R-OCC-11)
        } else if (World.isInterrupt(world.eventType(occurrence.type()).role())) {
            world.note(NoteKind.INTERRUPT_REFUSED, occurrence.mission(), occurrence.type());
        } else if (askedForNames) {
            world.note(onlyGone ? NoteKind.DISCARDED : NoteKind.NAMES_NOBODY, mission, occurrence.type());
        } else if (occurrence.activation() != Ids.NONE
                && (visit == null || visit.ended || visit.mission.status == Mission.Status.ENDED)) {
            world.note(NoteKind.LATE, mission, occurrence.type());
        } else {
            world.note(NoteKind.DISCARDED, mission, occurrence.type());
        }
    }

    /** Refuses what cannot fire now (R-INT-4). */
    void refuseInterrupts(Mission m, Transition t) {
        for (Pending p : m.pendingOf(t)) {
            if (World.overrides(world.eventType(p.event.type()).role())) {
                m.pending.remove(p);
                if (World.isInterrupt(world.eventType(p.event.type()).role())) {
                    world.note(NoteKind.INTERRUPT_REFUSED, m.id, t.id());
                }
            }
        }
    }

    /** Strikes who left from what waits (R-PEND-3, R-PEND-4). */
    void strike(Mission m, List<Copy> left, List<Visit> entered) {
        for (Pending p : List.copyOf(m.pending)) {
            for (Token name : p.names()) {
                List<Copy> leaving =
                        left.stream().filter(copy -> concerns(m, p, copy, name)).toList();
                if (leaving.stream().anyMatch(copy -> !stillThere(m, p, name, copy.visit.place, entered))) {
                    p.struck.add(name);
                }
            }
            if (p.told.flatMap(r -> r.by.visit).map(visit -> visit.ended).orElse(false)) {
                m.pending.remove(p);
                continue;
            }
            boolean allLeft = !p.struck.isEmpty() && p.names().isEmpty();
            if (allLeft || unheardOf(p)) {
                m.pending.remove(p);
                world.note(NoteKind.DISCARDED, m.id, p.occurrence.type());
            }
        }
    }

    private boolean concerns(Mission m, Pending p, Copy copy, Token name) {
        if (!enabling.tokensOf(name, p).contains(copy.token)) {
            return false;
        }
        Optional<Visit> answered = p.answeredVisit(world);
        if (answered.isPresent()) {
            return p.stood.contains(name) && m.inPlaces(p.transition).contains(copy.visit.place);
        }
        // who left reports again (R-PEND-8)
        return p.transition.waitFor() == WaitFor.ALL
                && enabling.watched(m, p.transition).contains(copy.visit.place);
    }

    /** Whether somebody of that name is there who did not just leave a place and enter it again. */
    private boolean stillThere(Mission m, Pending p, Token name, Place left, List<Visit> entered) {
        Optional<Visit> answered = p.answeredVisit(world);
        if (answered.isPresent()) {
            return standsForIt(m, p, answered.get(), name) || isWhereAsked(m, p, answered.get(), name);
        }
        return enabling.watched(m, p.transition).stream()
                .flatMap(place -> m.tokensIn(place).stream())
                .filter(copy -> copy.token.equals(name))
                .anyMatch(copy -> !copy.visit.place.equals(left) || !entered.contains(copy.visit));
    }

    /** The visit that it answers is over, and it names nobody. */
    private boolean unheardOf(Pending p) {
        return !p.namesSomebody()
                && p.answeredVisit(world).map(visit -> visit.ended).orElse(false);
    }

    /** Strikes a dropped boat (R-TOK-5). Returns the transitions that still have others to hear of. */
    List<Transition> forget(Mission m, Token.Proxy boat) {
        List<Transition> struck = new ArrayList<>();
        for (Pending p : new ArrayList<>(m.pending)) {
            if (p.names().contains(boat)) {
                p.struck.add(boat);
                if (p.names().isEmpty()) {
                    m.pending.remove(p);
                    world.note(NoteKind.DISCARDED, m.id, p.occurrence.type());
                }
                struck.add(p.transition);
            }
        }
        return m.plan.transitions().stream().filter(struck::contains).toList();
    }
}
