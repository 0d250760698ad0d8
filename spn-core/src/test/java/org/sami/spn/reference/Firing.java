package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.NoteKind;
import org.sami.spn.protocol.Occurrence;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;

/** Fires a transition, in the order of R-FIRE-1. */
final class Firing {
    /** A token selected for an out edge: a copy of the pool, a token of an instance's end places, both, or a new one. */
    private record SelectedTokens(Token token, Optional<Copy> copy, Optional<Instance> instance) {}

    /** What one firing does. */
    private static final class Moves {
        final Set<Copy> removed = new LinkedHashSet<>();
        final Map<Instance, List<Token>> usedBack = new LinkedHashMap<>();
        final Map<Copy, Set<Instance>> removedAsReturned = new LinkedHashMap<>();
        final Map<OutEdge, List<SelectedTokens>> added = new LinkedHashMap<>();
    }

    private final World world;
    private final Enabling enabling;
    private final Attention attention;
    private final Places places;

    Firing(World world, Enabling enabling, Attention attention, Places places) {
        this.world = world;
        this.enabling = enabling;
        this.attention = attention;
        this.places = places;
    }

    void fire(Mission m, Transition t, List<Pending> used) {
        Moves moves = select(m, t, used);
        boolean countedWasRemoved = removesWhatItCounts(m, t, used, moves.removed);
        m.pending.removeAll(used);
        markCompletionsUsed(m, t, used);
        List<Returned> returns = useUpReturns(m, t, used);

        List<Visit> nobodys = nobodysVisitsThatEnd(m, t, used);
        List<Copy> left = new ArrayList<>(moves.removed);
        leaveCompletions(moves);
        places.remove(m, left);
        if (world.overrides(t) || world.awaitsAborted(t)) {
            places.pulled(m, left, returns);
        }
        nobodys.forEach(places::end);
        places.askWithoutWithdrawn();
        List<Visit> entered = new ArrayList<>();
        for (OutEdge edge : m.outEdges(t)) {
            List<Token> tokens =
                    moves.added.get(edge).stream().map(SelectedTokens::token).toList();
            if (isEntered(m, edge, tokens)) {
                entered.add(places.add(m, m.place(edge.place()), tokens));
            }
        }
        if (!left.isEmpty()) {
            places.offerAllWhereFilteredLeft(m);
        }
        attention.strike(m, left, entered);

        world.firings++;
        List<Occurrence> occurrences = used.stream().map(p -> p.occurrence).toList();
        world.effects.add(new Effect.Fired(world.firings, m.id, t.id(), occurrences, List.of()));
        writeVariables(m, used);
        // what the end place asks is sent, nobody waits for answers (R-END-3)
        boolean ends = places.endsWith(m, entered);
        withdrawCommands(m, t, left, ends);
        entered.forEach(visit -> places.activate(visit, ends));
        if (!ends) {
            entered.forEach(places::startSubMissions);
        }
        places.endOrReturn(m, entered);

        // R-LOOK-6
        entered.forEach(visit -> places.lookAfterEntry(m, visit.place));
        for (Place place : m.inPlaces(t)) {
            if (left.stream().anyMatch(copy -> copy.visit.place.equals(place))) {
                places.lookAfterLeaving(m, place);
            }
            // another return that waits is an occasion as it was when it came (c)
            if (m.statics.stream().anyMatch(i -> i.place.equals(place) && !i.returns.isEmpty())) {
                places.lookAfterEntry(m, place);
            }
        }
        places.lookAtWithdrawn();
        // R-LOOK-4
        if (t.inputs().isEmpty() && countedWasRemoved) {
            world.lookAt(m, t);
        }
        if (!m.pendingOf(t).isEmpty()) {
            world.lookAt(m, t); // R-LOOK-5
        }
    }

    /** Interrupts and aborts withdraw the commands of whom they take; a mission that ends, those of all. */
    private void withdrawCommands(Mission m, Transition t, List<Copy> left, boolean ends) {
        List<String> boats = left.stream()
                .flatMap(copy -> world.boatOf(copy.token).stream())
                .distinct()
                .toList();
        if (world.overrides(t) && !boats.isEmpty()) {
            world.effects.add(new Effect.CommandsWithdrawn(m.id, boats));
        }
        if (ends) {
            world.effects.add(new Effect.CommandsWithdrawn(m.id, List.of()));
            m.commandsWithdrawn = true;
        }
    }

    // ---- Selecting

    private Moves select(Mission m, Transition t, List<Pending> used) {
        Moves moves = new Moves();
        for (OutEdge edge : m.outEdges(t)) {
            List<SelectedTokens> onEdge = new ArrayList<>();
            for (OutRequirement requirement : edge.requirements()) {
                if (requirement.kind() == TokenKind.UNCONDITIONAL) {
                    continue;
                }
                List<SelectedTokens> selected = selected(m, t, used, requirement);
                Map<Instance, List<Token>> usedHere = new LinkedHashMap<>();
                boolean noneNamed = requirement.kind() == TokenKind.RELEVANT
                        && requirement.action() != Action.ADD
                        && selected.isEmpty();
                if (noneNamed || (!requirement.takesAll() && selected.size() < requirement.n())) {
                    world.note(NoteKind.SHORT_OF_TOKENS, m.id, t.id());
                }
                if (requirement.action() != Action.ADD) {
                    for (SelectedTokens s : selected) {
                        s.copy().ifPresent(moves.removed::add);
                        if (s.instance().isPresent() && s.copy().isPresent()) {
                            moves.removedAsReturned
                                    .computeIfAbsent(s.copy().get(), key -> new LinkedHashSet<>())
                                    .add(s.instance().get());
                        }
                        s.instance()
                                .ifPresent(i -> usedHere.computeIfAbsent(i, key -> new ArrayList<>())
                                        .add(s.token()));
                    }
                    usedHere.forEach((instance, tokens) -> mergeOnce(moves.usedBack, instance, tokens));
                }
                if (requirement.action() != Action.CONSUME) {
                    selected.stream().filter(s -> !isOn(onEdge, s)).forEach(onEdge::add);
                }
            }
            moves.added.put(edge, onEdge);
        }
        useUpSubMissionTokens(moves);
        return moves;
    }

    /** What two requirements select is one token (R-OUT-2). */
    private static void mergeOnce(Map<Instance, List<Token>> all, Instance instance, List<Token> tokens) {
        List<Token> before = all.computeIfAbsent(instance, key -> new ArrayList<>());
        List<Token> same = new ArrayList<>(before);
        tokens.stream().filter(token -> !same.remove(token)).toList().forEach(before::add);
    }

    /** Adds a token to an edge once (R-OUT-6). */
    private static boolean isOn(List<SelectedTokens> onEdge, SelectedTokens s) {
        if (s.copy().isPresent()) {
            return onEdge.stream()
                    .anyMatch(o -> o.copy().equals(s.copy())
                            || (o.copy().isEmpty()
                                    && !(o.token() instanceof Token.Generic)
                                    && o.token().equals(s.token())));
        }
        boolean generic = s.token() instanceof Token.Generic;
        return !generic && onEdge.stream().anyMatch(o -> o.token().equals(s.token()));
    }

    /** What one requirement selects (R-OUT-2). */
    private List<SelectedTokens> selected(Mission m, Transition t, List<Pending> used, OutRequirement r) {
        if (r.kind() == TokenKind.SUB_MISSION_TOKENS) {
            List<SelectedTokens> all = subMissionTokens(m, t, used);
            return r.takesAll() ? all : all.subList(0, Math.min(r.n(), all.size()));
        }
        if (r.action() == Action.ADD && r.kind() == TokenKind.RELEVANT) {
            // R-OUT-5
            return used.stream()
                    .flatMap(p -> p.names().stream())
                    .distinct()
                    .limit(r.takesAll() ? Integer.MAX_VALUE : r.n())
                    .map(name -> new SelectedTokens(name, Optional.empty(), Optional.empty()))
                    .toList();
        }
        if (r.action() == Action.ADD && r.kind() == TokenKind.GENERIC && !r.takesAll()) {
            // R-OUT-4
            List<SelectedTokens> made = new ArrayList<>();
            for (int i = 0; i < r.n(); i++) {
                made.add(new SelectedTokens(Token.GENERIC, Optional.empty(), Optional.empty()));
            }
            return made;
        }
        Set<Token> relevant = enabling.relevant(used);
        List<SelectedTokens> all = enabling.pool(m, t, used).stream()
                .filter(copy -> enabling.isOfKind(r.kind(), r.task(), copy.token, relevant))
                .map(copy -> new SelectedTokens(copy.token, Optional.of(copy), Optional.empty()))
                .toList();
        // R-OUT-5
        return r.takesAll() ? all : all.subList(0, Math.min(r.n(), all.size()));
    }

    // ---- Sub-mission tokens (R-SUB-4)

    /** What came back (R-SUB-4), each with the parent's copy that came back, if there is one. */
    private List<SelectedTokens> subMissionTokens(Mission m, Transition t, List<Pending> used) {
        List<SelectedTokens> tokens = new ArrayList<>();
        for (Place place : m.inPlaces(t)) {
            List<Copy> free = new ArrayList<>(enabling.poolIn(m, t, place, used));
            List<Returned> returns = enabling.returnsUsed(m, t, place, used);
            for (Token token : Enabling.broughtBackByAll(returns)) {
                tokens.add(cameBack(token, returns.get(0).by, free));
            }
            for (Instance instance : m.instancesOn(place)) {
                boolean canBeTaken = instance.visit
                        .map(v -> v.complete() && Enabling.mayUse(v, used))
                        .orElse(false);
                for (Token token : canBeTaken ? instance.back : List.<Token>of()) {
                    tokens.add(cameBack(token, instance, free));
                }
            }
        }
        return tokens;
    }

    private static SelectedTokens cameBack(Token token, Instance instance, List<Copy> free) {
        Optional<Copy> came = free.stream()
                .filter(c -> c.token.equals(token)
                        && instance.visit.map(v -> v == c.visit).orElse(true))
                .findFirst();
        came.ifPresent(free::remove);
        return new SelectedTokens(token, came, Optional.of(instance));
    }

    private void useUpSubMissionTokens(Moves moves) {
        moves.usedBack.forEach((instance, tokens) -> {
            if (!instance.spec.shared()) {
                tokens.forEach(instance.back::remove);
            }
        });
    }

    /** What this firing uses of returns (R-SHR-4, R-SHR-9), with the occurrences that tell their values. */
    private List<Returned> useUpReturns(Mission m, Transition t, List<Pending> used) {
        used.forEach(p -> p.told.filter(r -> r.by.visit.isPresent()).ifPresent(places::useUp));
        List<Returned> all = new ArrayList<>();
        for (Place place : m.inPlaces(t)) {
            List<Returned> together = enabling.returnsUsed(m, t, place, used);
            List<Token> tokens = Enabling.broughtBackByAll(together);
            for (Returned one : together) {
                all.add(new Returned(one.by, tokens, one.value));
                places.useUp(one, tokens);
            }
        }
        return all;
    }

    /** A token that leaves the parent's place otherwise leaves the end places of the completed instance as well. */
    private static void leaveCompletions(Moves moves) {
        for (Copy copy : moves.removed) {
            Set<Instance> returnedBy = moves.removedAsReturned.getOrDefault(copy, Set.of());
            copy.visit.instances.stream()
                    .filter(i -> i.state == Instance.State.COMPLETE && !returnedBy.contains(i))
                    .forEach(i -> i.back.remove(copy.token));
        }
    }

    private void markCompletionsUsed(Mission m, Transition t, List<Pending> used) {
        boolean movesThem = m.outEdges(t).stream()
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS);
        if (movesThem && !world.overrides(t)) {
            List<Place> in = m.inPlaces(t);
            m.visits.stream()
                    .filter(v ->
                            in.contains(v.place) && !v.instances.isEmpty() && v.complete() && Enabling.mayUse(v, used))
                    .forEach(v -> v.used = true);
        }
    }

    // ---- Removing and adding

    /** Which visits by nobody a firing ends (R-VIS-4). */
    private List<Visit> nobodysVisitsThatEnd(Mission m, Transition t, List<Pending> used) {
        boolean movesEverything = m.outEdges(t).stream()
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.kind() == TokenKind.ANY_TOKEN && r.takesAll() && r.action() != Action.ADD);
        List<Place> in = m.inPlaces(t);
        return m.visits.stream()
                .filter(v -> v.byNobody && in.contains(v.place))
                .filter(v -> v.complete() || v.aborted() || world.overrides(t))
                .filter(v -> t.inputs().isEmpty()
                        || movesEverything
                        || used.stream()
                                .anyMatch(p -> p.answeredVisit(world).equals(Optional.of(v))
                                        || p.told.flatMap(r -> r.by.visit).equals(Optional.of(v))))
                .toList();
    }

    /** Whether a firing enters a place (R-VIS-2). */
    private static boolean isEntered(Mission m, OutEdge edge, List<Token> tokens) {
        return !tokens.isEmpty()
                || edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL)
                || m.place(edge.place()).end();
    }

    private boolean removesWhatItCounts(Mission m, Transition t, List<Pending> used, Set<Copy> removed) {
        Set<Token> relevant = enabling.relevant(used);
        for (InEdge edge : m.inEdges(t)) {
            for (InRequirement r : edge.requirements()) {
                boolean counts = r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY;
                if (counts
                        && removed.stream()
                                .anyMatch(c -> c.visit.place.id().equals(edge.place())
                                        && enabling.isOfKind(r.kind(), r.task(), c.token, relevant))) {
                    return true;
                }
            }
        }
        return false;
    }

    private void writeVariables(Mission m, List<Pending> used) {
        for (Pending p : used) {
            p.event.writes().forEach((field, variable) -> {
                Value value = p.occurrence.values().get(field);
                if (value != null) {
                    places.variables().write(m, variable, value);
                }
            });
        }
    }
}
