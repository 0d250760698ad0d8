package org.sami.spn.reference;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.InputEventSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.TaskId;

/** Whether a transition can fire, and with which of its pending occurrences. */
final class Enabling {
    private final World world;

    Enabling(World world) {
        this.world = world;
    }

    // ---- Relevant tokens (R-REL-1 to R-REL-3)

    /** The tokens that stand for one named boat or task in one occurrence. */
    List<Token> tokensOf(Token name, Pending pending) {
        List<Token> tokens = new ArrayList<>();
        tokens.add(name);
        if (name instanceof Token.Proxy boat && pending.isAnswer()) {
            // R-REL-3
            for (Token token : answered(pending).tokens()) {
                if (token instanceof Token.Task task
                        && Optional.of(boat.proxy()).equals(world.boatOf(task.task()))
                        && !tokens.contains(token)) {
                    tokens.add(token);
                }
            }
        }
        return tokens;
    }

    Activation answered(Pending pending) {
        long id = pending.occurrence.activation();
        return world.visitOfActivation.get(id).activations.stream()
                .filter(a -> a.id() == id)
                .findFirst()
                .orElseThrow();
    }

    /** Each once (R-REL-2). */
    Set<Token> relevant(List<Pending> used) {
        Set<Token> relevant = new LinkedHashSet<>();
        for (Pending pending : used) {
            pending.names().forEach(name -> relevant.addAll(tokensOf(name, pending)));
        }
        return relevant;
    }

    boolean isOfKind(TokenKind kind, String task, Token token, Set<Token> relevant) {
        return switch (kind) {
            case GENERIC -> token instanceof Token.Generic;
            case ANY_PROXY -> token instanceof Token.Proxy;
            case ANY_TASK -> token instanceof Token.Task;
            case ANY_TOKEN -> true;
            case TASK -> token instanceof Token.Task t && isTask(t.task(), task);
            case RELEVANT -> relevant.contains(token);
            case SUB_MISSION_TOKENS, UNCONDITIONAL -> false;
        };
    }

    /** Whether a token is of a task, by its name or class (R-IN-1). */
    private boolean isTask(TaskId id, String nameOrClass) {
        return id.name().equals(nameOrClass)
                || world.task(id).map(t -> t.taskClass().equals(nameOrClass)).orElse(false);
    }

    // ---- The pool (R-OUT-2)

    /** What stands in the in places, in the order of in edges, then of entry (R-OUT-2). */
    List<Copy> pool(Mission m, Transition t, List<Pending> used) {
        List<Copy> pool = new ArrayList<>();
        m.inPlaces(t).forEach(place -> pool.addAll(poolIn(m, t, place, used)));
        return pool;
    }

    /** What of a place is in the pool of a transition that would use these occurrences. */
    List<Copy> poolIn(Mission m, Transition t, Place place, List<Pending> used) {
        // held by an instance (R-SUB-2)
        List<Copy> pool = m.tokensIn(place).stream()
                .filter(copy -> world.overrides(t) || isOver(copy.visit, t))
                .filter(copy -> mayUse(copy.visit, used))
                .toList();
        if (returnsNeeded(m, t, place, used).isEmpty()) {
            return pool;
        }
        return equalTo(broughtBackByAll(returnsUsed(m, t, place, used)), pool);
    }

    private boolean isOver(Visit visit, Transition t) {
        return visit.complete() || (visit.aborted() && world.awaitsAborted(t));
    }

    /** Whether a checked value binds the firing to another visit (R-RET-2). */
    static boolean mayUse(Visit visit, List<Pending> used) {
        return used.stream()
                .flatMap(p -> p.told.stream())
                .filter(r -> r.by.visit.isPresent() && r.by.parent == visit.mission && r.by.place.equals(visit.place))
                .allMatch(r -> r.by.visit.get() == visit);
    }

    // ---- Returns of static sub-missions that go together (R-SHR-4, R-SHR-9)

    private List<Instance> returnsNeeded(Mission m, Transition t, Place place, List<Pending> used) {
        return m.statics.stream()
                .filter(i -> i.place.equals(place) && needsReturn(i, t, used))
                .toList();
    }

    /** One return of each static instance on a place, as a firing uses them; none where it has to wait or needs none. */
    List<Returned> returnsUsed(Mission m, Transition t, Place place, List<Pending> used) {
        List<List<Returned>> tuples = List.of(List.of());
        for (Instance instance : returnsNeeded(m, t, place, used)) {
            List<Returned> checked = used.stream()
                    .flatMap(p -> p.told.stream())
                    .filter(r -> r.by == instance)
                    .toList();
            List<List<Returned>> longer = new ArrayList<>();
            for (List<Returned> tuple : tuples) {
                for (Returned choice : checked.isEmpty() ? instance.returns : checked.subList(0, 1)) {
                    List<Returned> with = new ArrayList<>(tuple);
                    with.add(choice);
                    longer.add(with);
                }
            }
            tuples = longer;
        }
        return tuples.stream().filter(Enabling::goTogether).findFirst().orElse(List.of());
    }

    private static boolean goTogether(List<Returned> tuple) {
        return tuple.stream().anyMatch(r -> r.tokens.isEmpty())
                || !broughtBackByAll(tuple).isEmpty();
    }

    /** As many of each token as every one of the returns has. */
    static List<Token> broughtBackByAll(List<Returned> tuple) {
        List<Token> all = new ArrayList<>();
        if (!tuple.isEmpty()) {
            for (Token token : tuple.get(0).tokens) {
                int wanted = java.util.Collections.frequency(all, token) + 1;
                if (tuple.stream().allMatch(r -> java.util.Collections.frequency(r.tokens, token) >= wanted)) {
                    all.add(token);
                }
            }
        }
        return all;
    }

    /** Whether it needs a return (R-SHR-4); not interrupts, and not for an instance whose abort they answer. */
    private boolean needsReturn(Instance shared, Transition t, List<Pending> used) {
        boolean answersAbort = shared.state == Instance.State.ABORTED && world.awaitsAborted(t);
        boolean checksIt = used.stream().flatMap(p -> p.told.stream()).anyMatch(r -> r.by == shared);
        return checksIt || (!world.overrides(t) && !answersAbort);
    }

    /** Of the parent's tokens those equal to the ones that returned, one for one. */
    private static List<Copy> equalTo(List<Token> returned, List<Copy> copies) {
        List<Token> left = new ArrayList<>(returned);
        return copies.stream().filter(copy -> left.remove(copy.token)).toList();
    }

    /** Whether no sub-mission keeps it waiting (R-SUB-3, R-SHR-4; thesis, Algorithm 1). */
    private boolean waitsForSubMission(Mission m, Transition t, Place place, List<Pending> used) {
        if (world.overrides(t)) {
            return false;
        }
        List<Visit> visits =
                m.visits.stream().filter(v -> v.place.equals(place)).toList();
        boolean allRun = !visits.isEmpty() && visits.stream().noneMatch(v -> mayUse(v, used) && isOver(v, t));
        boolean noReturn = !returnsNeeded(m, t, place, used).isEmpty()
                && returnsUsed(m, t, place, used).isEmpty();
        return allRun || noReturn;
    }

    /**
     * A transition that moves sub-mission tokens fires for a completion, once: a boat that did not come back does not make
     * it fire again.
     */
    private boolean someCompletionIsNew(Mission m, Transition t, List<Pending> used) {
        boolean movesThem = m.outEdges(t).stream()
                .flatMap(e -> e.requirements().stream())
                .anyMatch(r -> r.kind() == TokenKind.SUB_MISSION_TOKENS);
        List<Place> dynamic = m.inPlaces(t).stream()
                .filter(p -> p.subMissions().stream().anyMatch(s -> !s.shared()))
                .toList();
        return !movesThem
                || world.overrides(t)
                || world.awaitsAborted(t)
                || dynamic.isEmpty()
                || m.statics.stream().anyMatch(i -> m.inPlaces(t).contains(i.place)) // its return is the completion
                || m.visits.stream()
                        .filter(v -> dynamic.contains(v.place) && isOver(v, t) && mayUse(v, used))
                        .anyMatch(v -> !v.used || v.instances.stream().anyMatch(i -> !i.back.isEmpty()));
    }

    // ---- In edges (R-IN-1 to R-IN-5)

    boolean requirementsHold(Mission m, Transition t, List<Pending> used) {
        if (!someCompletionIsNew(m, t, used)) {
            return false;
        }
        for (InEdge edge : m.inEdges(t)) {
            Place place = m.place(edge.place());
            if (waitsForSubMission(m, t, place, used)) {
                return false;
            }
            for (InRequirement requirement : edge.requirements()) {
                if (!holds(requirement, m, t, place, used)) {
                    return false;
                }
            }
        }
        return true;
    }

    private boolean holds(InRequirement requirement, Mission m, Transition t, Place place, List<Pending> used) {
        if (requirement.kind() == TokenKind.UNCONDITIONAL) {
            return true;
        }
        Set<Token> relevant = relevant(used);
        long inPool = poolIn(m, t, place, used).stream()
                .filter(c -> isOfKind(requirement.kind(), requirement.task(), c.token, relevant))
                .count();
        long standing = m.tokensIn(place).stream()
                .filter(c -> isOfKind(requirement.kind(), requirement.task(), c.token, relevant))
                .count();
        return switch (requirement.match()) {
            case ZERO -> standing == 0;
            case LESS_THAN -> standing < requirement.n();
            case EXACTLY -> standing == requirement.n();
            case AT_LEAST -> inPool >= requirement.n();
            case ALL -> used.stream().allMatch(p -> allNamedAreHere(m, t, place, p, used));
        };
    }

    /** Whether each name has a token here (R-IN-2). */
    private boolean allNamedAreHere(Mission m, Transition t, Place place, Pending pending, List<Pending> used) {
        List<Token> here =
                poolIn(m, t, place, used).stream().map(copy -> copy.token).toList();
        return pending.names().stream()
                .allMatch(name -> tokensOf(name, pending).stream().anyMatch(here::contains));
    }

    // ---- What waits (R-PEND-5 to R-PEND-8)

    /** The earliest combination that enables it (R-PEND-5); empty where it cannot fire. */
    Optional<List<Pending>> enabledWith(Mission m, Transition t) {
        if (!m.reacts()) {
            return Optional.empty();
        }
        if (t.inputs().isEmpty()) {
            return requirementsHold(m, t, List.of()) ? Optional.of(List.of()) : Optional.empty();
        }
        if (t.waitFor() == WaitFor.ALL) {
            return allReported(m, t).filter(used -> requirementsHold(m, t, used));
        }
        for (List<Pending> combination : combinations(m, t, 0)) {
            if (nameTheSame(combination) && tellOfTheSame(combination) && requirementsHold(m, t, combination)) {
                return Optional.of(combination);
            }
        }
        return Optional.empty();
    }

    private List<List<Pending>> combinations(Mission m, Transition t, int from) {
        if (from == t.inputs().size()) {
            return List.of(List.of());
        }
        List<List<Pending>> all = new ArrayList<>();
        for (Pending first : pendingOf(m, t, t.inputs().get(from))) {
            for (List<Pending> rest : combinations(m, t, from + 1)) {
                List<Pending> combination = new ArrayList<>();
                combination.add(first);
                combination.addAll(rest);
                all.add(combination);
            }
        }
        return all;
    }

    private static List<Pending> pendingOf(Mission m, Transition t, InputEventSpec event) {
        return m.pendingOf(t).stream().filter(p -> p.event.equals(event)).toList();
    }

    /** Whether occurrences join (R-PEND-6). */
    private static boolean nameTheSame(List<Pending> combination) {
        return combination.stream()
                        .map(p -> new HashSet<>(p.names()))
                        .filter(names -> !names.isEmpty())
                        .distinct()
                        .count()
                <= 1;
    }

    private static boolean tellOfTheSame(List<Pending> combination) {
        List<Returned> told = combination.stream().flatMap(p -> p.told.stream()).toList();
        return told.stream().allMatch(one -> told.stream().allMatch(one::goesWith));
    }

    /** The places that a wait-for-all transition watches. */
    List<Place> watched(Mission m, Transition t) {
        List<Place> speaking = m.inEdges(t).stream()
                .filter(e -> e.requirements().stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT))
                .map(e -> m.place(e.place()))
                .distinct()
                .toList();
        return speaking.isEmpty() ? m.inPlaces(t) : speaking;
    }

    /** All reports, once everybody has reported (R-PEND-7). */
    private Optional<List<Pending>> allReported(Mission m, Transition t) {
        Set<Token> standing = new LinkedHashSet<>();
        for (Place place : watched(m, t)) {
            m.tokensIn(place).stream()
                    .map(copy -> copy.token)
                    .filter(token -> !(token instanceof Token.Generic))
                    .forEach(standing::add);
        }
        if (standing.isEmpty()) {
            return Optional.empty(); // R-PEND-8
        }
        boolean several = t.inputs().size() > 1;
        boolean somebodyReported = false;
        List<Pending> used = new ArrayList<>();
        for (InputEventSpec event : t.inputs()) {
            List<Pending> all = pendingOf(m, t, event);
            List<Pending> reports = all.stream()
                    .filter(p -> relevant(List.of(p)).stream().anyMatch(standing::contains))
                    .toList();
            boolean namesNobody = several
                    && !all.isEmpty()
                    && all.stream().allMatch(p -> p.names().isEmpty());
            if (!namesNobody && !relevant(reports).containsAll(standing)) {
                return Optional.empty();
            }
            somebodyReported = somebodyReported || !namesNobody;
            // R-PEND-6
            for (Pending p : all) {
                boolean joins = used.stream()
                        .flatMap(other -> other.told.stream())
                        .allMatch(told -> p.told.map(told::goesWith).orElse(true));
                if ((reports.contains(p) || p.names().isEmpty()) && joins) {
                    used.add(p);
                }
            }
        }
        return somebodyReported ? Optional.of(used) : Optional.empty();
    }
}
