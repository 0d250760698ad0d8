package org.sami.petri.coverability;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.sami.petri.net.PetriNet;
import org.sami.petri.query.LinearComparison;
import org.sami.petri.query.MarkingCondition;
import org.sami.petri.query.NetQuery;
import org.sami.petri.query.QueryAnswer.NetVerdict;

/**
 * Answers queries from a complete coverability set, also where a net has infinitely many markings: how many tokens a place can have, and that markings with at least so
 * many tokens are never reached. Conditions are answered if more tokens never break them. For one thread.
 */
public final class CoverabilityQueries {
    private final PetriNet net;
    private final CoverabilitySet set;

    /** An answer in words; no where a place is unbounded, or nothing reachable fulfils a condition. */
    public record Answer(NetVerdict verdict, String words) {}

    /** Answers from the set of a net. */
    public CoverabilityQueries(PetriNet net, CoverabilitySet set) {
        this.net = net;
        this.set = set;
    }

    /** Whether a query is of a kind that a complete set can answer. */
    public static boolean mayAnswer(NetQuery query) {
        if (query instanceof NetQuery.Reachable reachable) {
            return growsTrue(reachable.condition(), false);
        }
        if (query instanceof NetQuery.Invariant invariant) {
            return growsTrue(invariant.condition(), true);
        }
        return query instanceof NetQuery.Bound;
    }

    /** The answer; empty where the set does not tell, and where a run that shows it has to be searched for. */
    public Optional<Answer> answer(NetQuery query) {
        if (!set.isComplete() || !mayAnswer(query)) {
            return Optional.empty();
        }
        if (query instanceof NetQuery.Bound bound) {
            return Optional.of(bound(bound.place()));
        }
        boolean invariant = query instanceof NetQuery.Invariant;
        MarkingCondition condition = query instanceof NetQuery.Reachable reachable
                ? reachable.condition()
                : ((NetQuery.Invariant) query).condition();
        for (int number = 0; number < set.size(); number++) {
            if (holds(condition, set.marking(number), invariant)) {
                return Optional.empty();
            }
        }
        return Optional.of(new Answer(
                invariant ? NetVerdict.YES : NetVerdict.NO,
                "proved by the minimal coverability set of " + set.size() + " markings"));
    }

    private Answer bound(int place) {
        String name = "place " + net.placeId(place);
        if (set.mostTokens(place).isPresent()) {
            return new Answer(
                    NetVerdict.YES,
                    name + " has at most " + set.mostTokens(place).getAsInt() + " tokens");
        }
        return new Answer(NetVerdict.NO, name + " is unbounded" + growth(place));
    }

    /** How a place grows without end, in words; empty where it does so only after others have been made large. */
    private String growth(int place) {
        return set.pump(place)
                .map(pump -> ": it grows with each round of " + names(pump.repeated())
                        + (pump.lead().isEmpty() ? "" : ", after " + names(pump.lead())))
                .orElse("");
    }

    private String names(List<Integer> transitions) {
        return transitions.stream().map(net::transitionId).collect(Collectors.joining(" "));
    }

    /** Whether a condition, or its opposite, stays true when tokens are added. */
    private static boolean growsTrue(MarkingCondition condition, boolean opposite) {
        if (condition instanceof MarkingCondition.Not not) {
            return growsTrue(not.part(), !opposite);
        }
        if (condition instanceof MarkingCondition.All all) {
            return all.parts().stream().allMatch(part -> growsTrue(part, opposite));
        }
        if (condition instanceof MarkingCondition.Any any) {
            return any.parts().stream().allMatch(part -> growsTrue(part, opposite));
        }
        if (condition instanceof MarkingCondition.Enabled) {
            return !opposite; // places with inhibitor arcs are exact in the set
        }
        return condition instanceof LinearComparison comparison
                && comparison.terms().stream().allMatch(term -> term.factor() >= 0)
                && switch (comparison.relation()) {
                    case AT_LEAST, MORE -> !opposite;
                    case AT_MOST, LESS -> opposite;
                    case EQUAL, NOT_EQUAL -> false;
                };
    }

    /** Whether a condition that {@link #growsTrue}, or its opposite, holds in a marking with any number of tokens in some places. */
    private static boolean holds(MarkingCondition condition, int[] marking, boolean opposite) {
        if (condition instanceof MarkingCondition.Not not) {
            return holds(not.part(), marking, !opposite);
        }
        if (condition instanceof MarkingCondition.All all) {
            return opposite
                    ? all.parts().stream().anyMatch(part -> holds(part, marking, true))
                    : all.parts().stream().allMatch(part -> holds(part, marking, false));
        }
        if (condition instanceof MarkingCondition.Any any) {
            return opposite
                    ? any.parts().stream().allMatch(part -> holds(part, marking, true))
                    : any.parts().stream().anyMatch(part -> holds(part, marking, false));
        }
        if (condition instanceof LinearComparison comparison
                && comparison.terms().stream()
                        .anyMatch(term -> term.factor() > 0 && marking[term.place()] == Omega.OMEGA)) {
            return true; // the sum is larger than any number
        }
        return condition.test(marking) != opposite;
    }
}
