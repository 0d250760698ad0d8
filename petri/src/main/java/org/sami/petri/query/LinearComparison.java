package org.sami.petri.query;

import java.util.List;

/**
 * A comparison of a weighted sum of tokens with a number: {@code sum of factor * tokens, relation, constant}.
 *
 * @param terms one for each place at most
 */
public record LinearComparison(List<Term> terms, Relation relation, long constant) implements MarkingCondition {
    public LinearComparison {
        terms = List.copyOf(terms);
    }

    /**
     * A place and how often its tokens count. A factor below 2^31 in size does not keep a sum within a long: the sum of three such terms can exceed it, and
     * {@link QueryParser} refuses sums that could.
     */
    public record Term(int place, int factor) {}

    /** How two numbers are compared. */
    public enum Relation {
        LESS,
        AT_MOST,
        EQUAL,
        NOT_EQUAL,
        AT_LEAST,
        MORE
    }

    /** Whether it only asks if there are tokens in any of its places, such as {@code a + 2 * b >= 1}. */
    public boolean isOfPresence() {
        long least = relation == Relation.LESS || relation == Relation.AT_LEAST ? 1 : 0;
        return constant == least && terms.stream().allMatch(term -> term.factor() > 0);
    }

    @Override
    public boolean test(int[] marking) {
        long sum = 0;
        for (Term term : terms) {
            sum += (long) term.factor() * marking[term.place()];
        }
        return switch (relation) {
            case LESS -> sum < constant;
            case AT_MOST -> sum <= constant;
            case EQUAL -> sum == constant;
            case NOT_EQUAL -> sum != constant;
            case AT_LEAST -> sum >= constant;
            case MORE -> sum > constant;
        };
    }
}
