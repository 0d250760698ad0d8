package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.flow.TokenType;
import org.sami.spn.model.Place;

/**
 * A shared sub-mission that the net follows: from its parent's start on who enters the place joins it, until it enters an end place that ends it; all other end places
 * return who comes there (R-SHR-1 to R-SHR-6). Of the unused returns the net knows which robots they bring, and how many bring none; not their order, nor which robots came
 * together. Where tokens leave the place otherwise, or nobody enters it, it is left open for good.
 */
final class SharedChild extends FollowedChild {
    private final Set<PlanToken> returning = new HashSet<>();
    private final int unused;
    private final int running;

    /**
     * A child that is ready to be followed.
     *
     * @param place of the parent's plan
     * @param mission the child's
     * @param team the tokens that there are
     */
    SharedChild(MissionPlaces parent, String place, ChildMission mission, List<PlanToken> team) {
        super(
                parent,
                place,
                mission,
                team.stream()
                        .filter(token -> token.type() == TokenType.PROXY && comesToEnd(mission, token))
                        .toList());
        team.stream().filter(token -> comesToEnd(mission, token)).forEach(returning::add);
        unused = parent.returnsOfNobody(place);
        running = mission.places().running();
    }

    private static boolean comesToEnd(ChildMission mission, PlanToken token) {
        return mission.plan().places().stream()
                .anyMatch(place -> place.end() && mission.possible().comes(place.id(), token));
    }

    /** A return brings only what can come to an end place of the child. */
    @Override
    boolean mayReturn(PlanToken token) {
        return returning.contains(token);
    }

    @Override
    List<SubMode> modes() {
        return List.of(SubMode.RETURNED, SubMode.OPEN);
    }

    @Override
    void suppose(SubMode mode, CaseArcs arcs) {
        if (mode == SubMode.OPEN) {
            arcs.atLeast(open(), 1);
        }
    }

    /** What an option supposes where the token is one of those that the return brought: it does not wait any longer. */
    void used(TokenOption option) {
        if (option.present.contains(place())) {
            back(option.token).ifPresent(at -> use(option.arcs, at));
        }
    }

    /**
     * The cases of a firing out of the place by the return that it uses: the one of those robots that are said to be in the pool; else one that brings no robot, or one of whom
     * nothing is said.
     *
     * @param robots so many the return must bring at least
     */
    List<CaseArcs> used(CaseArcs arcs, List<TokenOption> chosen, int robots) {
        List<TokenOption> returned = chosen.stream()
                .filter(option -> option.token.type() == TokenType.PROXY && option.present.contains(place()))
                .toList();
        List<TokenOption> others = chosen.stream()
                .filter(option -> option.isUnselected && back(option.token).isPresent())
                .toList();
        if (returned.size() + others.size() < robots) {
            return List.of();
        }
        if (!returned.isEmpty()) {
            return List.of(arcs);
        }
        List<CaseArcs> cases = new ArrayList<>();
        if (robots == 0) {
            CaseArcs ofNobody = arcs.copy();
            ofNobody.remove(unused, 1);
            cases.add(ofNobody);
        }
        for (TokenOption option : others) {
            CaseArcs ofOther = arcs.copy();
            use(ofOther, back(option.token).orElseThrow());
            cases.add(ofOther);
        }
        return cases;
    }

    private static void use(CaseArcs arcs, int at) {
        arcs.atLeast(at, 1);
        arcs.empty(at);
    }

    @Override
    public List<CaseArcs> changed(CaseArcs arcs, int edges, boolean isByNobody, boolean isPulled) {
        if (isPulled || isByNobody) {
            leaveOpen(arcs);
            return List.of(arcs);
        }
        CaseArcs joined = arcs.copy();
        joined.atLeast(running, 1);
        join(joined);
        Optional<? extends StartedChild> inner = atStart();
        List<CaseArcs> cases =
                new ArrayList<>(inner.isPresent() ? inner.get().changed(joined, edges, false, false) : List.of(joined));
        CaseArcs over = arcs.copy(); // nobody joins one that has ended, or is not followed any longer
        over.below(running, 1);
        cases.add(over);
        return cases;
    }

    @Override
    public void parentStarts(CaseArcs arcs) {
        forget(arcs);
        start(arcs);
    }

    @Override
    public void enteredFirst(CaseArcs arcs) {
        join(arcs);
        atStart().ifPresent(child -> child.enteredFirst(arcs));
    }

    @Override
    void forget(CaseArcs arcs) {
        super.forget(arcs);
        arcs.clear(unused);
    }

    /** Each is a return of its own, and nobody stays there. */
    @Override
    void returned(CaseArcs arcs, Set<Integer> ends, EndTokens atEnd) {
        ends.stream().filter(edge -> !atEnd.edges().contains(edge)).forEach(edge -> arcs.add(unused, 1));
        bringBack(arcs, atEnd.tokens());
        mission().plan().places().stream()
                .filter(Place::end)
                .flatMap(place -> mission().places().allIn(place.id()).stream())
                .forEach(arcs::cancel);
    }

    @Override
    void completed(CaseArcs arcs, EndTokens atEnd) {
        empty(arcs);
        bringBack(arcs, atEnd.tokens());
        if (atEnd.edges().isEmpty()) {
            arcs.add(unused, 1);
        }
    }
}
