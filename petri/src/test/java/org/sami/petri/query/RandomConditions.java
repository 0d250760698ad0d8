package org.sami.petri.query;

import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.sami.petri.net.PetriNet;

/** Random conditions on the markings of a net. */
public final class RandomConditions {
    private static final List<LinearComparison.Relation> RELATIONS = List.of(LinearComparison.Relation.values());

    private final PetriNet net;
    private final Random random;

    /** Conditions of a net, made with these numbers. */
    public RandomConditions(PetriNet net, Random random) {
        this.net = net;
        this.random = random;
    }

    /** A condition with so many levels of "and", "or" and "not" at most. */
    public MarkingCondition next(int depth) {
        return switch (random.nextInt(depth == 0 ? 6 : 10)) {
            case 0 -> new MarkingCondition.Enabled(net, random.nextInt(net.transitionCount()));
            case 1 -> new MarkingCondition.NothingEnabled(net);
            case 2 -> sum(random.nextInt(3) - 1, random.nextInt(4));
            case 3, 4, 5 -> sumOfAlike();
            case 6 -> new MarkingCondition.Not(next(depth - 1));
            case 7, 8 -> new MarkingCondition.All(List.of(next(depth - 1), next(depth - 1)));
            default -> new MarkingCondition.Any(List.of(next(depth - 1), next(depth - 1)));
        };
    }

    private LinearComparison sum(int factorOfSecond, int constant) {
        List<LinearComparison.Term> terms = List.of(
                new LinearComparison.Term(random.nextInt(net.placeCount()), 1 + random.nextInt(2)),
                new LinearComparison.Term(random.nextInt(net.placeCount()), factorOfSecond));
        return new LinearComparison(terms, relation(), constant);
    }

    /** All places whose ids end alike: in nets of copies, the same place of each copy. */
    private LinearComparison sumOfAlike() {
        String id = net.placeId(random.nextInt(net.placeCount()));
        String end = id.substring(id.length() - 1);
        List<LinearComparison.Term> terms = IntStream.range(0, net.placeCount())
                .filter(place -> net.placeId(place).endsWith(end))
                .mapToObj(place -> new LinearComparison.Term(place, 1))
                .toList();
        return new LinearComparison(terms, relation(), random.nextInt(3));
    }

    private LinearComparison.Relation relation() {
        return RELATIONS.get(random.nextInt(RELATIONS.size()));
    }
}
