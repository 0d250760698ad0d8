package org.sami.spn.plannet;

import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.BiPredicate;
import java.util.function.Predicate;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Action;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Which tokens can come to which place, whoever may be named, and which of them can never be copied. A bound from above that follows requirements and no
 * numbers. Immutable.
 */
final class PossibleTokens implements TokenWays {
    private final MadeByChildren made;
    private final Plan plan;
    private final Vocabulary vocabulary;
    private final Map<String, Set<PlanToken>> at = new HashMap<>();
    private final Set<String> byNobody = new HashSet<>();
    private final Set<PlanToken> copied = new HashSet<>();
    /** Of copied tokens: groups of places that together have the token once at most. */
    private final Map<PlanToken, List<Set<String>>> single = new HashMap<>();

    /** How the places with sub-missions are that are followed. */
    private final Map<String, SubMode> modes;

    /** Of places with shared sub-missions the tokens that those can bring back. */
    private final BiPredicate<String, PlanToken> returns;

    /**
     * Those of a plan by itself.
     *
     * @param byPlace whether of a token that may stand several times in one place the others are told apart; else it may in all of them
     */
    PossibleTokens(Project project, Vocabulary vocabulary, Plan plan, Collection<PlanToken> all, boolean byPlace) {
        this(project, vocabulary, plan, all, token -> !token.isMade(), token -> false, byPlace);
    }

    /**
     * Those of one mission.
     *
     * @param atStart the tokens with which it may start
     * @param several those of which several may be there at the start
     * @param byPlace as for the other constructor
     */
    PossibleTokens(
            Project project,
            Vocabulary vocabulary,
            Plan plan,
            Collection<PlanToken> all,
            Predicate<PlanToken> atStart,
            Predicate<PlanToken> several,
            boolean byPlace) {
        made = new MadeByChildren(project, vocabulary);
        this.vocabulary = vocabulary;
        this.plan = plan;
        modes = Map.of();
        returns = (place, token) -> true;
        plan.startPlace().ifPresent(start -> all.stream().filter(atStart).forEach(token -> come(start.id(), token)));
        boolean more = true;
        while (more) {
            more = false;
            for (OutEdge edge : plan.outEdges()) {
                more |= follow(edge, all);
            }
        }
        plan.outEdges().stream()
                .filter(edge -> edge.requirements().isEmpty()
                        || edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL)
                        || isEnd(edge.place()))
                .map(OutEdge::place)
                .forEach(byNobody::add);
        for (PlanToken token : all) {
            if (several.test(token) || plan.transitions().stream().anyMatch(t -> copies(t, token))) {
                copied.add(token);
            }
        }
        SinglePlaces singles =
                new SinglePlaces(plan, this, all.stream().anyMatch(token -> token.type() == TokenType.TASK), several);
        copied.stream()
                .filter(token -> token.type() != TokenType.GENERIC && !token.isMade())
                .forEach(token -> single.put(token, singles.groups(token)));
        if (!byPlace) {
            single.keySet().removeIf(this::isLoose);
        }
    }

    private PossibleTokens(PossibleTokens of, Map<String, SubMode> modes, BiPredicate<String, PlanToken> returns) {
        made = of.made;
        vocabulary = of.vocabulary;
        plan = of.plan;
        at.putAll(of.at);
        byNobody.addAll(of.byNobody);
        copied.addAll(of.copied);
        single.putAll(of.single);
        this.modes = modes;
        this.returns = returns;
    }

    /**
     * The same while places with sub-missions are so.
     *
     * @param returns whether a return of a place's shared sub-mission can bring a token
     */
    PossibleTokens in(Map<String, SubMode> modes, BiPredicate<String, PlanToken> returns) {
        return modes.isEmpty() ? this : new PossibleTokens(this, modes, returns);
    }

    private boolean isEnd(String place) {
        return plan.place(place).filter(Place::end).isPresent();
    }

    private boolean follow(OutEdge edge, Collection<PlanToken> all) {
        Optional<Transition> t = plan.transition(edge.transition());
        boolean more = false;
        for (PlanToken token : all) {
            if (t.isPresent() && !comes(edge.place(), token) && adds(edge, t.get(), token)) {
                more |= come(edge.place(), token);
            }
        }
        return more;
    }

    private boolean come(String place, PlanToken token) {
        return at.computeIfAbsent(place, p -> new HashSet<>()).add(token);
    }

    private boolean adds(OutEdge edge, Transition t, PlanToken token) {
        return edge.requirements().stream().anyMatch(r -> adds(r, t, token));
    }

    private boolean adds(OutRequirement r, Transition t, PlanToken token) {
        if (r.action() == Action.CONSUME) {
            return false;
        }
        return makes(r, t, token) || (covers(r, t, token) && isInPool(t, token));
    }

    @Override
    public boolean makes(OutRequirement r, Transition t, PlanToken token) {
        boolean isGeneric = token.type() == TokenType.GENERIC;
        if (r.kind() == TokenKind.SUB_MISSION_TOKENS && r.action() != Action.CONSUME) {
            return made.whereNobodyStands(plan, t, place -> comes(place, PlanToken.GENERIC))
                    .contains(token.type());
        }
        return r.action() == Action.ADD
                && ((r.kind() == TokenKind.GENERIC && !r.takesAll() && r.n() > 0 && isGeneric)
                        || (r.kind() == TokenKind.RELEVANT
                                && !isGeneric
                                && !t.inputs().isEmpty()
                                && (token.isMade() || !makesTasks(t))));
    }

    /** Whether a transition only waits for tasks that the mission makes: its occurrences name those, which stand nowhere yet. */
    boolean makesTasks(Transition t) {
        return !t.inputs().isEmpty()
                && t.inputs().stream()
                        .allMatch(input -> vocabulary
                                .event(input.type())
                                .filter(type -> type.role() == EventRole.TASKS_GENERATED)
                                .isPresent());
    }

    @Override
    public boolean covers(OutRequirement r, Transition t, PlanToken token) {
        return switch (r.kind()) {
            case RELEVANT -> token.type() != TokenType.GENERIC && !t.inputs().isEmpty() && !makesTasks(t);
            case TASK -> token.isTask(r.task());
            case SUB_MISSION_TOKENS -> plan.inEdgesOf(t.id()).stream().anyMatch(edge -> hasSub(edge.place()));
            case GENERIC -> token.type() == TokenType.GENERIC && (r.action() != Action.ADD || r.takesAll());
            default -> TokenType.of(r.kind()).contains(token.type());
        };
    }

    /** Whether a token can be in the pool of a transition. */
    private boolean isInPool(Transition t, PlanToken token) {
        return plan.inEdgesOf(t.id()).stream()
                .anyMatch(edge -> comes(edge.place(), token) && !isExcluded(t, edge.place(), token));
    }

    /** Whether the transition cannot fire while the token is in the place. */
    boolean isExcluded(Transition t, String place, PlanToken token) {
        return plan.inEdgesOf(t.id()).stream()
                .filter(edge -> edge.place().equals(place))
                .flatMap(edge -> edge.requirements().stream())
                .filter(InRequirement::asksForNone)
                .anyMatch(r -> r.kind() == TokenKind.TASK
                        ? token.isTask(r.task())
                        : r.kind() != TokenKind.RELEVANT
                                && TokenType.of(r.kind()).contains(token.type()));
    }

    private boolean copies(Transition t, PlanToken token) {
        int entered = 0;
        for (OutEdge edge : plan.outEdgesOf(t.id())) {
            boolean here = false;
            for (OutRequirement r : edge.requirements()) {
                if (adds(r, t, token)) {
                    if ((r.action() == Action.ADD || makes(r, t, token)) && !(token.isMade() && makesTasks(t))) {
                        return true;
                    }
                    here = true;
                }
            }
            entered += here ? 1 : 0;
        }
        return entered > 1;
    }

    @Override
    public boolean hasSub(String place) {
        return plan.place(place).filter(p -> !p.subMissions().isEmpty()).isPresent();
    }

    /** Whether a sub-mission may hold tokens of the place, so that they are there and in no pool. */
    boolean isHeld(String place) {
        SubMode mode = modes.getOrDefault(place, SubMode.OPEN);
        return hasSub(place) && (mode == SubMode.RETURNED || mode == SubMode.OPEN);
    }

    /** Whether the plans of a place's sub-missions may make tokens, or copy those that were given to them. */
    boolean isMadeByChildren(String place) {
        return !made.by(plan, place).isEmpty();
    }

    @Override
    public boolean comes(String place, PlanToken token) {
        return at.getOrDefault(place, Set.of()).contains(token);
    }

    /** Whether a place can be entered by nobody. */
    boolean isEnteredByNobody(String place) {
        return byNobody.contains(place);
    }

    /** Whether there can be several of a token in the mission. */
    boolean isCopied(PlanToken token) {
        return copied.contains(token);
    }

    /** Whether several of a token may stand in some place. */
    boolean isLoose(PlanToken token) {
        return at.keySet().stream().anyMatch(place -> isLoose(token, place));
    }

    /** Whether several of a token may stand in a place. */
    boolean isLoose(PlanToken token, String place) {
        return isCopied(token)
                && comes(place, token)
                && single.getOrDefault(token, List.of()).stream().noneMatch(group -> group.contains(place));
    }

    /** Whether a token may stand in all of these places at once. */
    boolean canStand(PlanToken token, Collection<String> places) {
        return single.getOrDefault(token, List.of()).stream()
                .allMatch(group -> places.stream().filter(group::contains).count() <= 1);
    }

    @Override
    public List<String> spots(Transition t, PlanToken token) {
        return plan.inEdgesOf(t.id()).stream()
                .map(edge -> edge.place())
                .distinct()
                .filter(place -> comes(place, token) && !isExcluded(t, place, token))
                .filter(place -> modes.get(place) != SubMode.VACANT)
                .filter(place -> modes.get(place) != SubMode.RETURNED || returns.test(place, token))
                .toList();
    }
}
