package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;
import org.sami.spn.model.WaitFor;

/**
 * The cases of one transition of a plan: one transition of the net for each set of tokens that may be named, each place in which a token may stand as far as that
 * matters, and each way to meet the requirements.
 */
final class TransitionCases {
    /** So many choices for all robots together are tried where it is followed whether any are there: a second or two. */
    private static final int MOST_TRIED = 400_000;

    private final PlanNetWork work;
    private final PossibleTokens possible;
    private final Transition t;
    private final List<InEdge> ins;
    private final Selections selections;
    private final List<CaseArcs> conditions;
    private final Set<String> watched;
    private final boolean mustHaveRelevant;
    private final boolean hasTasks;
    /** The tokens of which several may stand in one of its in places. */
    private final Set<PlanToken> loose = new HashSet<>();

    private final Set<Object> known = new HashSet<>();
    private final WakenedCases wakened;
    private final SubMissionCases subs;
    private final FiringEffects effects;
    private Function<List<TokenOption>, Optional<CaseArcs>> ofRobots;
    private Optional<Map<Object, PresenceCases.Found>> found = Optional.empty();
    private int made;
    private int tried;

    /** @param modes how the places are whose sub-missions are followed, where that matters */
    TransitionCases(PlanNetWork work, Transition t, List<CaseArcs> conditions, Map<String, SubMode> modes) {
        this.work = work;
        possible = work.possible().in(modes, work::mayReturn);
        this.t = t;
        this.conditions = conditions;
        ofRobots = new CountedRobots(work.places(), work.possible(), t)::arcs;
        ins = work.plan().inEdgesOf(t.id());
        wakened = new WakenedCases(work, t);
        selections = new Selections(t, work.plan().outEdgesOf(t.id()));
        subs = new SubMissionCases(work, t, modes, selections);
        effects = new FiringEffects(work, t, ins, selections, subs);
        watched = t.waitFor() == WaitFor.ALL && !t.inputs().isEmpty() ? watchedPlaces() : Set.of();
        mustHaveRelevant = TransitionLooks.isToldNames(work.vocabulary(), t)
                && requirements().stream()
                        .anyMatch(r -> r.kind() == TokenKind.RELEVANT
                                && (r.match() == Match.ALL
                                        || ((r.match() == Match.AT_LEAST || r.match() == Match.EXACTLY) && r.n() > 0)));
        hasTasks = work.team().stream().anyMatch(token -> token.type() == TokenType.TASK);
        work.team().stream()
                .filter(token -> ins.stream().anyMatch(edge -> possible.isLoose(token, edge.place())))
                .forEach(loose::add);
    }

    private List<InRequirement> requirements() {
        return ins.stream().flatMap(edge -> edge.requirements().stream()).toList();
    }

    /** The places in which every robot must report; those where tasks may stand or a sub-mission runs are left out. */
    private Set<String> watchedPlaces() {
        Set<String> all = new LinkedHashSet<>();
        ins.stream()
                .filter(edge -> edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT))
                .forEach(edge -> all.add(edge.place()));
        if (all.isEmpty()) {
            ins.forEach(edge -> all.add(edge.place()));
        }
        all.removeIf(place -> work.possible().hasSub(place)
                || work.places().in(place).keySet().stream().anyMatch(token -> token.type() == TokenType.TASK));
        return all;
    }

    /** What can be with one token of a kind; nothing where the transition can never fire. */
    List<TokenOption> options(PlanToken token) {
        if (conditions.isEmpty()) {
            return List.of();
        }
        boolean speaks = requirements().stream().anyMatch(r -> r.kind() == TokenKind.RELEVANT)
                || selections.all().stream().anyMatch(s -> s.isOf(TokenKind.RELEVANT));
        return new TokenOptions(
                        work.places(),
                        possible,
                        t,
                        selections,
                        subs,
                        speaks,
                        watched,
                        ends() && work.view() != RobotView.PRESENT)
                .of(token).stream()
                        .filter(option -> !option.isNamed || SinglePlaces.mayBeNamed(ins, hasTasks, option.present))
                        .toList();
    }

    /**
     * Adds the cases to the net.
     *
     * @param profiles where robots are counted by the places in which they are
     */
    void add(Optional<RobotProfiles> profiles) throws PlanNetTooLargeException {
        if (conditions.isEmpty()) {
            return; // it can never fire
        }
        List<List<TokenOption>> perToken = new ArrayList<>();
        for (PlanToken token : work.team()) {
            if (token.type() != TokenType.GENERIC) {
                List<TokenOption> options = options(token);
                perToken.addAll(Collections.nCopies(
                        work.count(token),
                        profiles.isPresent() && token.equals(PlanToken.ROBOTS)
                                ? profiles.get().expanded(t, options)
                                : options));
            }
        }
        choose(perToken, 0, 0, new ArrayList<>(), generics());
    }

    private List<GenericOption> generics() {
        return new GenericOptions(work.places(), possible, t, selections, work.robots(), work.beyond()).all();
    }

    /** Adds the cases to a net that follows only whether any robot is in a place. */
    void addByPresence() throws PlanNetTooLargeException {
        if (conditions.isEmpty()) {
            return; // it can never fire
        }
        PresenceCases presence = new PresenceCases(work, t);
        List<List<TokenOption>> others = work.team().stream()
                .filter(token -> token.type() == TokenType.TASK)
                .map(this::options)
                .toList();
        List<GenericOption> generics = generics();
        presence.add(title(), options(PlanToken.ROBOTS), (robots, standings) -> {
            Map<Object, PresenceCases.Found> cases = new LinkedHashMap<>();
            found = Optional.of(cases);
            ofRobots = chosen -> presence.arcs(chosen, standings);
            List<List<TokenOption>> perToken = new ArrayList<>(others);
            perToken.addAll(robots);
            choose(perToken, 0, 0, new ArrayList<>(), generics);
            return cases;
        });
    }

    /** Robots that are counted are all alike: their options are taken in one order only, from a number on. */
    private void choose(
            List<List<TokenOption>> perToken,
            int next,
            int from,
            List<TokenOption> chosen,
            List<GenericOption> generics)
            throws PlanNetTooLargeException {
        if (next == perToken.size()) {
            if (found.isPresent() && ++tried > MOST_TRIED) {
                throw new PlanNetTooLargeException("robots can share the in places of \"" + title()
                        + "\" in too many ways: ask about fewer robots");
            }
            if (isMet(chosen)) {
                List<TokenOption> robots = chosen.stream()
                        .filter(o -> o.token.equals(PlanToken.ROBOTS))
                        .toList();
                Optional<CaseArcs> together = ofRobots.apply(robots);
                if (together.isPresent()) { // else another case does the same and supposes less
                    for (GenericOption generic : generics) {
                        join(chosen, robots, together.get(), generic);
                    }
                }
            }
            return;
        }
        List<TokenOption> options = perToken.get(next);
        boolean isNextAlike = next + 1 < perToken.size() && perToken.get(next + 1) == options;
        for (int i = from; i < options.size(); i++) {
            chosen.add(options.get(i));
            choose(perToken, next + 1, isNextAlike ? i : 0, chosen, generics);
            chosen.remove(chosen.size() - 1);
        }
    }

    /** Whether the named tokens are what in edges ask for. */
    private boolean isMet(List<TokenOption> chosen) {
        if (mustHaveRelevant && chosen.stream().noneMatch(o -> o.isNamed && !o.present.isEmpty())) {
            return false;
        }
        if (!watched.isEmpty() && chosen.stream().noneMatch(o -> o.isNamed)) {
            return false;
        }
        if (chosen.stream().anyMatch(o -> o.isNamedByRobot)
                && chosen.stream().noneMatch(o -> o.isNamed && o.token.type() == TokenType.PROXY)) {
            return false;
        }
        for (InEdge edge : ins) {
            for (InRequirement r : edge.requirements()) {
                if (r.kind() == TokenKind.RELEVANT && !MetRequirements.meets(r, edge.place(), chosen, hasTasks)) {
                    return false;
                }
            }
        }
        return true;
    }

    /** Whether it leads to an end of the mission. */
    private boolean ends() {
        return selections.edges().stream().anyMatch(edge -> effects.endsMission(edge.place()));
    }

    /** @param robots those of the chosen options that are of robots that are counted, with what they ask for together */
    private void join(List<TokenOption> chosen, List<TokenOption> robots, CaseArcs ofRobots, GenericOption generic)
            throws PlanNetTooLargeException {
        boolean isLoose = chosen.stream()
                .anyMatch(o -> loose.contains(o.token) || (work.possible().isCopied(o.token) && o.present.size() > 1));
        if (!MetRequirements.fits(
                selections.numbers(), chosen, generic.picked, generic.more, this::isSurelyThere, isLoose)) {
            return;
        }
        CaseArcs arcs = generic.arcs.copy();
        arcs.join(ofRobots);
        List<PlanNetMove> moves = new ArrayList<>(generic.moves);
        Set<Integer> entered = new LinkedHashSet<>(generic.edges);
        Set<String> left = new LinkedHashSet<>(generic.left);
        List<String> named = new ArrayList<>();
        boolean returnsSome = generic.returned > 0;
        for (TokenOption option : chosen) {
            if (robots.isEmpty() || !option.token.equals(PlanToken.ROBOTS)) {
                arcs.join(option.arcs);
            }
            moves.addAll(option.moves);
            entered.addAll(option.edges);
            left.addAll(option.removed);
            returnsSome |= option.isReturned;
            if (option.isNamed && !option.isNamedByRobot) {
                named.add(option.token.label());
            }
        }
        boolean ends = false;
        for (int i = 0; i < selections.edges().size(); i++) {
            OutEdge edge = selections.edges().get(i);
            boolean isEnd = effects.isEnd(edge.place());
            ends |= effects.endsMission(edge.place());
            boolean unconditional = edge.requirements().isEmpty()
                    || edge.requirements().stream().anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL);
            if (!entered.contains(i) && unconditional && !isEnd) {
                arcs.add(work.places().nobody(edge.place()).getAsInt(), 1);
                entered.add(i);
            }
        }
        EndTokens atEnd = effects.atEnd(chosen);
        for (CaseArcs ready : InConditions.both(subs.returns(arcs, chosen), conditions)) {
            for (CaseArcs awake : wakened.of(ready)) {
                CaseArcs whole = awake.copy();
                PlanNetFiring firing = work.firing(t, named, moves, ends);
                for (CaseArcs each : effects.of(whole, entered, left, ends, returnsSome, atEnd)) {
                    put(each, firing, robots);
                }
            }
        }
    }

    /** Whether a token surely is where it can be selected: a sub-mission may hold it, or it may stand nowhere. */
    private boolean isSurelyThere(TokenOption option) {
        return option.present.stream().anyMatch(place -> !possible.isHeld(place));
    }

    private void put(CaseArcs arcs, PlanNetFiring firing, List<TokenOption> robots) throws PlanNetTooLargeException {
        if (arcs.isImpossible()) {
            return;
        }
        if (found.isPresent()) {
            found.get().putIfAbsent(arcs.key(), new PresenceCases.Found(arcs, firing));
            return;
        }
        if (!known.add(arcs.key())) {
            return;
        }
        work.putFiring(title(), firing, robots, arcs, ++made);
    }

    private String title() {
        return t.name().isBlank() ? t.id() : t.name();
    }
}
