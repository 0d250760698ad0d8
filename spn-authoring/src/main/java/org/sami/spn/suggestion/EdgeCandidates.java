package org.sami.spn.suggestion;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sami.spn.drawing.RequirementWords;
import org.sami.spn.edit.EdgeEdit;
import org.sami.spn.flow.NamedTokens;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TaskSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * The requirements that the language allows on an edge: each one alone, each one beside those that stand there, in the place of one of them, and
 * those that stand there without one. The usual ones come first. None consumes a robot, as that would end a finding by losing the robot, and
 * none makes a copy of one.
 */
final class EdgeCandidates {
    private final Plan plan;
    private final Vocabulary vocabulary;

    EdgeCandidates(Plan plan, Vocabulary vocabulary) {
        this.plan = plan;
        this.vocabulary = vocabulary;
    }

    /**
     * The candidates for an edge, without the requirements that stand there.
     *
     * @throws IllegalArgumentException if the plan has no such edge, or it is locked
     */
    List<Candidate> of(String id) {
        for (InEdge edge : plan.inEdges()) {
            if (edge.id().equals(id)) {
                refuseLocked(edge.locked());
                return candidates(
                        edge.requirements(),
                        in(edge),
                        InRequirement::kind,
                        RequirementWords::of,
                        written -> new EdgeEdit.SetInRequirements(plan.id(), id, written));
            }
        }
        for (OutEdge edge : plan.outEdges()) {
            if (edge.id().equals(id)) {
                refuseLocked(edge.locked());
                return candidates(
                        edge.requirements(),
                        out(edge),
                        OutRequirement::kind,
                        RequirementWords::of,
                        written -> new EdgeEdit.SetOutRequirements(plan.id(), id, written));
            }
        }
        throw new IllegalArgumentException("The plan \"" + plan.title() + "\" has no edge \"" + id + "\"");
    }

    private static void refuseLocked(boolean locked) {
        if (locked) {
            throw new IllegalArgumentException("The edge is locked: unlock it to change its requirements");
        }
    }

    private static <R> List<Candidate> candidates(
            List<R> there,
            List<R> single,
            Function<R, TokenKind> kind,
            Function<R, String> words,
            Function<List<R>, EdgeEdit> edit) {
        Predicate<R> stands = r -> kind.apply(r) != TokenKind.UNCONDITIONAL;
        List<R> kept = there.stream().filter(stands).toList();
        Set<List<R>> lists = new LinkedHashSet<>();
        single.forEach(r -> lists.add(List.of(r)));
        for (R added : single.stream().filter(stands).toList()) {
            if (kept.stream().noneMatch(r -> kind.apply(r) == kind.apply(added))) {
                lists.add(with(kept, kept.size(), added));
            }
            for (int i = 0; i < kept.size(); i++) {
                lists.add(replaced(kept, i, added));
            }
        }
        if (kept.size() > 1) {
            for (int i = 0; i < kept.size(); i++) {
                List<R> fewer = new ArrayList<>(kept);
                fewer.remove(i);
                lists.add(fewer);
            }
        }
        lists.removeIf(list -> Set.copyOf(list).equals(Set.copyOf(there))
                || list.stream().map(kind).distinct().count() < list.size());
        return lists.stream()
                .map(list -> new Candidate(
                        list.stream().map(words).collect(Collectors.joining(", ")),
                        edit.apply(list),
                        changes(there, list)))
                .toList();
    }

    private static <R> int changes(List<R> there, List<R> list) {
        long come = list.stream().filter(r -> !there.contains(r)).count();
        long go = there.stream().filter(r -> !list.contains(r)).count();
        return (int) (come + go);
    }

    private static <R> List<R> with(List<R> list, int at, R added) {
        List<R> changed = new ArrayList<>(list);
        changed.add(at, added);
        return changed;
    }

    private static <R> List<R> replaced(List<R> list, int at, R by) {
        List<R> changed = new ArrayList<>(list);
        changed.set(at, by);
        return changed;
    }

    private List<InRequirement> in(InEdge edge) {
        List<InRequirement> all = new ArrayList<>();
        if (namesTokens(edge.transition())) {
            all.add(InRequirement.allRelevant());
            all.add(InRequirement.of(TokenKind.RELEVANT, Match.AT_LEAST, 1));
        }
        List<TokenKind> kinds = kinds();
        kinds.forEach(kind -> all.add(InRequirement.of(kind, Match.AT_LEAST, 1)));
        kinds.forEach(kind -> all.add(InRequirement.of(kind, Match.ZERO, 0)));
        tasks().forEach(task -> all.add(new InRequirement(TokenKind.TASK, Match.AT_LEAST, 1, task)));
        kinds.forEach(kind -> all.add(InRequirement.of(kind, Match.EXACTLY, 1)));
        kinds.forEach(kind -> all.add(InRequirement.of(kind, Match.AT_LEAST, 2)));
        kinds.forEach(kind -> all.add(InRequirement.of(kind, Match.LESS_THAN, 2)));
        tasks().forEach(task -> all.add(new InRequirement(TokenKind.TASK, Match.ZERO, 0, task)));
        all.add(InRequirement.unconditional());
        return all;
    }

    private List<OutRequirement> out(OutEdge edge) {
        List<OutRequirement> all = new ArrayList<>();
        List<TokenKind> kinds = new ArrayList<>();
        if (namesTokens(edge.transition())) {
            kinds.add(TokenKind.RELEVANT);
        }
        kinds.addAll(kinds());
        if (entersSubMissions(edge.transition())) {
            kinds.add(TokenKind.SUB_MISSION_TOKENS);
        }
        for (TokenKind kind : kinds) {
            all.add(OutRequirement.of(Action.TAKE, OutRequirement.ALL, kind));
            if (kind != TokenKind.RELEVANT && kind != TokenKind.SUB_MISSION_TOKENS) {
                all.add(OutRequirement.of(Action.TAKE, 1, kind));
            }
        }
        tasks().forEach(task -> all.add(new OutRequirement(TokenKind.TASK, OutRequirement.ALL, Action.TAKE, task)));
        kinds.stream()
                .filter(kind -> kind == TokenKind.GENERIC || kind == TokenKind.ANY_TASK)
                .forEach(kind -> all.add(OutRequirement.of(Action.CONSUME, OutRequirement.ALL, kind)));
        all.add(OutRequirement.of(Action.ADD, 1, TokenKind.GENERIC));
        all.add(OutRequirement.unconditional());
        all.removeIf(r -> r.action() == Action.TAKE && isTakenElsewhere(edge, r.kind()));
        return all;
    }

    /** Whether another edge of the transition takes such tokens: taking them twice would make a copy of a robot or a task. */
    private boolean isTakenElsewhere(OutEdge edge, TokenKind kind) {
        return plan.outEdgesOf(edge.transition()).stream()
                .filter(other -> !other.id().equals(edge.id()))
                .flatMap(other -> other.requirements().stream())
                .anyMatch(other -> other.action() == Action.TAKE && overlap(kind, other.kind()));
    }

    private static boolean overlap(TokenKind one, TokenKind other) {
        if (one == other || one == TokenKind.ANY_TOKEN || other == TokenKind.ANY_TOKEN) {
            return true;
        }
        boolean generic = one == TokenKind.GENERIC || other == TokenKind.GENERIC;
        boolean proxies = one == TokenKind.ANY_PROXY || other == TokenKind.ANY_PROXY;
        boolean tasks = Stream.of(one, other).anyMatch(kind -> kind == TokenKind.ANY_TASK || kind == TokenKind.TASK);
        return !generic && !(proxies && tasks);
    }

    private List<TokenKind> kinds() {
        return plan.tasks().isEmpty()
                ? List.of(TokenKind.ANY_PROXY, TokenKind.ANY_TOKEN, TokenKind.GENERIC)
                : List.of(TokenKind.ANY_PROXY, TokenKind.ANY_TASK, TokenKind.ANY_TOKEN, TokenKind.GENERIC);
    }

    private List<String> tasks() {
        return plan.tasks().stream().map(TaskSpec::name).distinct().toList();
    }

    private boolean entersSubMissions(String transition) {
        return plan.inEdgesOf(transition).stream()
                .flatMap(edge -> plan.place(edge.place()).stream())
                .map(Place::subMissions)
                .anyMatch(missions -> !missions.isEmpty());
    }

    /** Whether an input event of a transition can name tokens: without one there are no relevant tokens (thesis 3.1). */
    private boolean namesTokens(String transition) {
        return plan.transition(transition).stream()
                .flatMap(t -> t.inputs().stream())
                .flatMap(input -> vocabulary.event(input.type()).stream())
                .anyMatch(event -> !NamedTokens.of(event).isEmpty());
    }
}
