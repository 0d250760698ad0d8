package org.sami.spn.wiring;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sami.spn.model.Action;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.TokenKind;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** Which kinds of tokens can come into each place of a plan, by what its out edges do. */
public final class ComingTokens {
    /** The kinds that are told apart. */
    public enum Kind {
        GENERIC,
        PROXY,
        TASK
    }

    private final Project project;
    private final Vocabulary vocabulary;
    private final Set<String> asked;
    private final Map<String, List<String>> before = new HashMap<>();
    private final Map<String, Set<Kind>> coming = new HashMap<>();

    /** The tokens of a plan of a project. */
    public ComingTokens(Project project, Plan plan, Vocabulary vocabulary) {
        this(project, plan, vocabulary, new HashSet<>());
    }

    private ComingTokens(Project project, Plan plan, Vocabulary vocabulary, Set<String> asked) {
        this.project = project;
        this.vocabulary = vocabulary;
        this.asked = asked;
        asked.add(plan.id());
        for (Place place : plan.places()) {
            coming.put(place.id(), place.start() ? atStart(plan) : EnumSet.noneOf(Kind.class));
        }
        for (InEdge edge : plan.inEdges()) {
            before.computeIfAbsent(edge.transition(), t -> new ArrayList<>()).add(edge.place());
        }
        boolean more = true;
        while (more) {
            more = false;
            for (OutEdge edge : plan.outEdges()) {
                Set<Kind> there = coming.get(edge.place());
                more |= there != null && there.addAll(brought(plan, edge));
            }
        }
    }

    /** What can come into a place. */
    public Set<Kind> in(String place) {
        return Set.copyOf(coming.getOrDefault(place, Set.of()));
    }

    /** Whether a kind can come into a place. */
    public boolean comes(Kind kind, String place) {
        return coming.getOrDefault(place, Set.of()).contains(kind);
    }

    /** A mission starts with the generic token, the robots and the plan's tasks; an instance also with what enters its parent's place. */
    private Set<Kind> atStart(Plan plan) {
        Set<Kind> kinds = EnumSet.of(Kind.GENERIC, Kind.PROXY);
        if (!plan.tasks().isEmpty() || parentsBringTasks(plan)) {
            kinds.add(Kind.TASK);
        }
        return kinds;
    }

    private boolean parentsBringTasks(Plan plan) {
        for (Plan parent : project.plans()) {
            List<Place> places = parent.places().stream()
                    .filter(p ->
                            p.subMissions().stream().map(SubMissionSpec::plan).anyMatch(plan.id()::equals))
                    .toList();
            if (!places.isEmpty() && !asked.contains(parent.id())) {
                ComingTokens above = new ComingTokens(project, parent, vocabulary, asked);
                if (places.stream().anyMatch(p -> above.comes(Kind.TASK, p.id()))) {
                    return true;
                }
            }
        }
        return false;
    }

    private Set<Kind> brought(Plan plan, OutEdge edge) {
        Set<Kind> pool = EnumSet.noneOf(Kind.class);
        before.getOrDefault(edge.transition(), List.of())
                .forEach(place -> pool.addAll(coming.getOrDefault(place, Set.of())));
        Set<Kind> brought = EnumSet.noneOf(Kind.class);
        for (OutRequirement r : edge.requirements()) {
            if (r.action() != Action.CONSUME) {
                brought.addAll(brought(plan, edge, r, pool));
            }
        }
        return brought;
    }

    private Set<Kind> brought(Plan plan, OutEdge edge, OutRequirement r, Set<Kind> pool) {
        boolean made = r.action() == Action.ADD;
        Set<Kind> kinds = EnumSet.noneOf(Kind.class);
        switch (r.kind()) {
            case GENERIC -> add(kinds, Kind.GENERIC, made || pool.contains(Kind.GENERIC));
            case ANY_PROXY -> add(kinds, Kind.PROXY, pool.contains(Kind.PROXY));
            case ANY_TASK, TASK -> add(kinds, Kind.TASK, pool.contains(Kind.TASK));
            case ANY_TOKEN -> kinds.addAll(pool);
            case RELEVANT, SUB_MISSION_TOKENS -> {
                Set<Kind> named = r.kind() == TokenKind.RELEVANT && made ? named(plan, edge.transition()) : pool;
                add(kinds, Kind.PROXY, named.contains(Kind.PROXY));
                add(kinds, Kind.TASK, named.contains(Kind.TASK));
            }
            case UNCONDITIONAL -> {}
        }
        return kinds;
    }

    private static void add(Set<Kind> kinds, Kind kind, boolean comes) {
        if (comes) {
            kinds.add(kind);
        }
    }

    /** Whom the answers of a transition can name, wherever their tokens stand. */
    private Set<Kind> named(Plan plan, String transition) {
        Set<Kind> named = EnumSet.noneOf(Kind.class);
        plan.transition(transition).stream()
                .flatMap(t -> t.inputs().stream())
                .flatMap(i -> vocabulary.event(i.type()).stream())
                .map(EventType::tokens)
                .forEach(need -> {
                    add(named, Kind.TASK, need == TokenNeed.TASK || need == TokenNeed.PROXY_OR_TASK);
                    add(named, Kind.PROXY, need == TokenNeed.PROXY || need == TokenNeed.PROXY_OR_TASK);
                });
        return named;
    }
}
