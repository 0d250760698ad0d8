package org.sami.petri.structure;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.LinearComparison;
import org.sami.petri.query.MarkingCondition;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer.NetVerdict;
import org.sami.petri.structure.LinearCondition.AllOf;
import org.sami.petri.structure.LinearCondition.OneOf;

/** Answers queries from structure alone, before any search: those whose answer is that something never happens. For one thread. */
public final class StructuralQueries {
    private final PetriNet net;
    private final StructuralAnswers answers;

    /**
     * An answer with its proof.
     *
     * @param verdict yes or no
     */
    public record Answer(NetVerdict verdict, StructuralProof proof) {}

    /** Answers about a net. */
    public StructuralQueries(PetriNet net, StructuralAnswers answers) {
        this.net = net;
        this.answers = answers;
    }

    /** The answer, where structure proves it; empty where a search has to. */
    public Optional<Answer> answer(NetQuery query) {
        try {
            return proved(query);
        } catch (ArithmeticException e) {
            return Optional.empty(); // its numbers are too large to be reckoned with
        }
    }

    private Optional<Answer> proved(NetQuery query) {
        if (query instanceof NetQuery.Reachable reachable) {
            return never(reachable.condition(), false, NetVerdict.NO);
        }
        if (query instanceof NetQuery.Invariant invariant) {
            return never(invariant.condition(), true, NetVerdict.YES);
        }
        if (query instanceof NetQuery.Deadlock deadlock) {
            return noDeadlock(deadlock.end());
        }
        return Optional.empty();
    }

    private Optional<Answer> noDeadlock(MarkingCondition end) {
        Optional<StructuralProof> never = answers.neverStopsBySiphons();
        if (never.isEmpty()) {
            never = answers.never(new AllOf(List.of(LinearCondition.dead(net), condition(end, true))));
        }
        return never.map(proof -> new Answer(NetVerdict.NO, proof));
    }

    private Optional<Answer> never(MarkingCondition condition, boolean opposite, NetVerdict verdict) {
        return answers.never(condition(condition, opposite)).map(proof -> new Answer(verdict, proof));
    }

    /** A condition, or its opposite, in sums of tokens. */
    private LinearCondition condition(MarkingCondition condition, boolean opposite) {
        if (condition instanceof MarkingCondition.Not not) {
            return condition(not.part(), !opposite);
        }
        if (condition instanceof MarkingCondition.All all) {
            return parts(all.parts(), opposite, opposite);
        }
        if (condition instanceof MarkingCondition.Any any) {
            return parts(any.parts(), opposite, !opposite);
        }
        LinearCondition plain = plain(condition);
        return opposite ? LinearCondition.opposite(plain) : plain;
    }

    private LinearCondition parts(List<MarkingCondition> parts, boolean opposite, boolean one) {
        List<LinearCondition> conditions = new ArrayList<>();
        parts.forEach(part -> conditions.add(condition(part, opposite)));
        return one ? new OneOf(conditions) : new AllOf(conditions);
    }

    private LinearCondition plain(MarkingCondition condition) {
        if (condition instanceof LinearComparison comparison) {
            return comparison(comparison);
        }
        if (condition instanceof MarkingCondition.Enabled enabled) {
            return LinearCondition.enabled(net, enabled.transition());
        }
        if (condition instanceof MarkingCondition.NothingEnabled) {
            return LinearCondition.dead(net);
        }
        throw new IllegalArgumentException("a condition of an unknown kind: " + condition);
    }

    private static LinearCondition comparison(LinearComparison comparison) {
        IntegerVector weights = IntegerVector.ZERO;
        for (LinearComparison.Term term : comparison.terms()) {
            weights = weights.combined(1, IntegerVector.unit(term.place(), 1), term.factor());
        }
        long constant = comparison.constant();
        return switch (comparison.relation()) {
            case AT_LEAST -> atLeast(weights, constant);
            case MORE -> LinearCondition.opposite(atMost(weights, constant));
            case AT_MOST -> atMost(weights, constant);
            case LESS -> LinearCondition.opposite(atLeast(weights, constant));
            case EQUAL -> new AllOf(List.of(atLeast(weights, constant), atMost(weights, constant)));
            case NOT_EQUAL ->
                new OneOf(List.of(
                        LinearCondition.opposite(atLeast(weights, constant)),
                        LinearCondition.opposite(atMost(weights, constant))));
        };
    }

    private static LinearCondition atLeast(IntegerVector weights, long least) {
        return new LinearCondition.AtLeast(weights, least);
    }

    private static LinearCondition atMost(IntegerVector weights, long most) {
        return new LinearCondition.AtLeast(IntegerVector.ZERO.combined(1, weights, -1), Math.negateExact(most));
    }
}
