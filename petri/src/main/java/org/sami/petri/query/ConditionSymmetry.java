package org.sami.petri.query;

import java.util.List;
import java.util.function.IntUnaryOperator;
import java.util.stream.Collectors;
import org.sami.petri.symmetry.NetSymmetry;

/** Whether a condition means the same after equal components were exchanged. */
final class ConditionSymmetry {
    private ConditionSymmetry() {}

    /** Whether each permutation keeps the condition as it is written, but for the order of its parts. Else it may still mean the same; that is not seen. */
    static boolean isKept(MarkingCondition condition, NetSymmetry symmetry) {
        String own = text(condition, place -> place, transition -> transition);
        for (int generator = 0; generator < symmetry.generators(); generator++) {
            int at = generator;
            String moved = text(
                    condition,
                    place -> symmetry.imagesOfPlace(place).get(at),
                    transition -> symmetry.imagesOfTransition(transition).get(at));
            if (!moved.equals(own)) {
                return false;
            }
        }
        return true;
    }

    private static String text(MarkingCondition condition, IntUnaryOperator place, IntUnaryOperator transition) {
        if (condition instanceof MarkingCondition.All all) {
            return "all" + texts(all.parts(), place, transition);
        } else if (condition instanceof MarkingCondition.Any any) {
            return "any" + texts(any.parts(), place, transition);
        } else if (condition instanceof MarkingCondition.Not not) {
            return "not" + texts(List.of(not.part()), place, transition);
        } else if (condition instanceof MarkingCondition.Enabled enabled) {
            return "t" + transition.applyAsInt(enabled.transition());
        } else if (condition instanceof LinearComparison comparison) {
            return comparison.terms().stream()
                            .map(term -> place.applyAsInt(term.place()) + "*" + term.factor())
                            .sorted()
                            .toList()
                    + comparison.relation().name()
                    + comparison.constant();
        }
        return "deadlock";
    }

    private static String texts(List<MarkingCondition> parts, IntUnaryOperator place, IntUnaryOperator transition) {
        return parts.stream()
                .map(part -> text(part, place, transition))
                .sorted()
                .collect(Collectors.joining(",", "(", ")"));
    }
}
