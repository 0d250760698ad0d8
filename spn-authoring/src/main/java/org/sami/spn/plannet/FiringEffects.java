package org.sami.spn.plannet;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.Place;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.Transition;

/** What a firing does besides moving tokens: to its mission, to visits by nobody, to what is looked at next, and to sub-missions. */
final class FiringEffects {
    private final PlanNetWork work;
    private final Transition t;
    private final List<InEdge> ins;
    private final Selections selections;
    private final SubMissionCases subs;

    FiringEffects(PlanNetWork work, Transition t, List<InEdge> ins, Selections selections, SubMissionCases subs) {
        this.work = work;
        this.t = t;
        this.ins = ins;
        this.selections = selections;
        this.subs = subs;
    }

    boolean isEnd(String place) {
        return work.plan().place(place).filter(Place::end).isPresent();
    }

    /** Whether entering a place ends the mission. */
    boolean endsMission(String place) {
        return work.plan().place(place).filter(work::endsMission).isPresent();
    }

    /** What a firing brings to end places. */
    EndTokens atEnd(List<TokenOption> chosen) {
        List<PlanToken> tokens = new ArrayList<>();
        Set<Integer> edges = new LinkedHashSet<>();
        for (TokenOption option : chosen) {
            List<Integer> ending = option.edges.stream()
                    .filter(edge -> isEnd(selections.target(edge)))
                    .toList();
            if (!ending.isEmpty()) {
                tokens.add(option.token);
                edges.addAll(ending);
            }
        }
        return new EndTokens(tokens, edges);
    }

    /**
     * Completes a case.
     *
     * @param entered numbers of the out edges by which places are entered
     * @param left the in places that tokens leave
     * @param returnsSome whether sub-mission tokens are selected
     * @param atEnd whom it brings to an end place
     * @return it, or what becomes of it as the places with sub-missions are that it enters
     */
    List<CaseArcs> of(
            CaseArcs arcs, Set<Integer> entered, Set<String> left, boolean ends, boolean returnsSome, EndTokens atEnd) {
        around(arcs, entered, left, ends);
        if (!ends) {
            returnToParent(arcs, atEnd);
        }
        List<CaseArcs> cases = subs.of(arcs, entered, left, returnsSome, ends);
        if (ends) {
            work.asChild().ifPresent(child -> cases.forEach(one -> child.completed(one, atEnd)));
        }
        return cases;
    }

    /** Of a shared sub-mission: each edge into an end place that does not end it is a return. */
    private void returnToParent(CaseArcs arcs, EndTokens atEnd) {
        Set<Integer> returning = new LinkedHashSet<>();
        for (int edge = 0; edge < selections.edges().size(); edge++) {
            if (isEnd(selections.target(edge))) {
                returning.add(edge);
                work.places().occasions(work.plan(), selections.target(edge), true, arcs);
            }
        }
        if (!returning.isEmpty()) {
            work.asChild().ifPresent(child -> child.returned(arcs, returning, atEnd));
        }
    }

    /** That the mission runs, the end, visits by nobody that end, and which transitions are to be looked at next. */
    private void around(CaseArcs arcs, Set<Integer> entered, Set<String> left, boolean ends) {
        int running = work.places().running();
        if (ends) {
            arcs.remove(running, 1);
        } else {
            arcs.atLeast(running, 1);
        }
        for (Optional<PlanNetWork> of = work.parent();
                of.isPresent();
                of = of.get().parent()) {
            arcs.atLeast(of.get().places().running(), 1);
        }
        boolean clears = selections.all().stream()
                .anyMatch(s -> s.isOf(TokenKind.ANY_TOKEN)
                        && s.removes()
                        && s.requirement().takesAll());
        if (t.inputs().isEmpty() || clears) {
            for (InEdge edge : ins) {
                if (!work.possible().hasSub(edge.place())) {
                    work.places().nobody(edge.place()).ifPresent(nobody -> {
                        if (!arcs.adds(nobody)) {
                            arcs.empty(nobody);
                        }
                    });
                }
            }
        }
        work.places().occasion(t.id()).ifPresent(mark -> arcs.remove(mark, 1));
        if (!ends) {
            entered.forEach(edge -> work.places().occasions(work.plan(), selections.target(edge), true, arcs));
            left.forEach(place -> work.places().occasions(work.plan(), place, false, arcs));
        }
    }
}
