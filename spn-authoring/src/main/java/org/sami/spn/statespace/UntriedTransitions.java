package org.sami.spn.statespace;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutEdge;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Transition;
import org.sami.spn.vocabulary.Vocabulary;

/** Transitions that did not fire as the search does not bring them about ({@link PlanRoles#isUntried}), and what lies behind them. */
final class UntriedTransitions {
    private final Plan plan;
    private final List<Transition> untried;

    UntriedTransitions(Plan plan, Vocabulary vocabulary, Set<String> fired) {
        this.plan = plan;
        PlanRoles roles = new PlanRoles(plan, vocabulary);
        untried = plan.transitions().stream()
                .filter(t -> !fired.contains(t.id()) && roles.isUntried(t))
                .toList();
    }

    List<String> words(DeepRequest request) {
        return untried.stream()
                .map(t -> SearchWords.transition(request, t.id()))
                .toList();
    }

    /** Their ids and those of all places and transitions that they lead to. */
    Set<String> andBehindThem() {
        Set<String> behind = new HashSet<>();
        Deque<String> open =
                new ArrayDeque<>(untried.stream().map(Transition::id).toList());
        while (!open.isEmpty()) {
            String id = open.pop();
            if (behind.add(id)) {
                plan.outEdges().stream()
                        .filter(edge -> edge.transition().equals(id))
                        .map(OutEdge::place)
                        .forEach(open::add);
                plan.inEdges().stream()
                        .filter(edge -> edge.place().equals(id))
                        .map(InEdge::transition)
                        .forEach(open::add);
            }
        }
        return behind;
    }
}
