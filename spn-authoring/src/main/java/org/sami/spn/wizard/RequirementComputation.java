package org.sami.spn.wizard;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.function.BiPredicate;
import org.sami.spn.model.Action;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.OutRequirement;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.vocabulary.Vocabulary;

/**
 * Adjusts the requirements of edges after events were added to a plan or taken from it (thesis 5.1.1). An edge is changed only by what the
 * change of the plan makes different in the computed requirements: what an author wrote otherwise stays. Locked edges, those of manual
 * sequences among them, are never changed.
 */
public final class RequirementComputation {
    private final Vocabulary vocabulary;
    private final AuthoringLibrary library;

    /** A computation with the words and the sequences of a domain. */
    public RequirementComputation(Vocabulary vocabulary, AuthoringLibrary library) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
        this.library = Objects.requireNonNull(library, "library");
    }

    /** The changed plan with the requirements that the change makes needed. */
    public Plan adjusted(Plan before, Plan changed) {
        ComputedRequirements old = computed(before);
        ComputedRequirements now = computed(changed);
        return changed.withInEdges(changed.inEdges().stream()
                        .map(e -> e.withRequirements(merged(
                                e.locked(),
                                e.requirements(),
                                old.in(e.id()),
                                now.in(e.id()),
                                RequirementComputation::inSaid)))
                        .toList())
                .withOutEdges(changed.outEdges().stream()
                        .map(e -> e.withRequirements(merged(
                                e.locked(),
                                e.requirements(),
                                old.out(e.id()),
                                now.out(e.id()),
                                RequirementComputation::outSaid)))
                        .toList());
    }

    /** The plan with the requirements of some edges computed from nothing; locked ones among them stay. */
    public Plan computed(Plan plan, Set<String> edges) {
        ComputedRequirements now = computed(plan);
        return plan.withInEdges(plan.inEdges().stream()
                        .map(e -> edges.contains(e.id()) && !e.locked() ? e.withRequirements(now.in(e.id())) : e)
                        .toList())
                .withOutEdges(plan.outEdges().stream()
                        .map(e -> edges.contains(e.id()) && !e.locked() ? e.withRequirements(now.out(e.id())) : e)
                        .toList());
    }

    private ComputedRequirements computed(Plan plan) {
        return new ComputedRequirements(plan, vocabulary, library);
    }

    private static <R> List<R> merged(
            boolean locked, List<R> written, List<R> old, List<R> now, BiPredicate<List<R>, R> said) {
        if (locked || (old.equals(now) && !written.isEmpty())) {
            return written;
        }
        List<R> merged = new ArrayList<>(written);
        merged.removeIf(r -> old.contains(r) && !now.contains(r));
        if (merged.isEmpty()) {
            return now;
        }
        for (R r : now) {
            if (!old.contains(r) && !said.test(merged, r)) {
                merged.add(r);
            }
        }
        return merged;
    }

    /** Whether what is written on an in edge says as much already, or the opposite. */
    private static boolean inSaid(List<InRequirement> written, InRequirement needed) {
        return needed.kind() == TokenKind.UNCONDITIONAL
                || written.stream()
                        .anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL
                                || r.kind() == needed.kind()
                                || (r.kind() == TokenKind.ANY_TOKEN && r.match() != Match.ZERO));
    }

    private static boolean outSaid(List<OutRequirement> written, OutRequirement needed) {
        return needed.kind() == TokenKind.UNCONDITIONAL
                || written.stream()
                        .anyMatch(r -> r.kind() == TokenKind.UNCONDITIONAL
                                || (r.action() != Action.CONSUME && covers(r.kind(), needed.kind())));
    }

    private static boolean covers(TokenKind written, TokenKind needed) {
        return written == needed
                || written == TokenKind.ANY_TOKEN
                || (written == TokenKind.RELEVANT && (needed == TokenKind.ANY_PROXY || needed == TokenKind.ANY_TASK));
    }
}
