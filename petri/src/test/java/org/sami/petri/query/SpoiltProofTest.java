package org.sami.petri.query;

import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.provider.Arguments;
import org.sami.petri.coverability.CoverabilityJudge;
import org.sami.petri.structure.StructureJudge;

/** The comparisons of proofs with all markings notice when one line of coverability or structure is wrong: each row spoils one. */
@Tag("long")
class SpoiltProofTest extends SpoiltLines {
    SpoiltProofTest() {
        super(44, new CoverabilityJudge(), new StructureJudge());
    }

    @Override
    Stream<Arguments> lines() {
        return Stream.concat(ofCoverability(), ofStructure());
    }

    private static Stream<Arguments> ofCoverability() {
        return Stream.of(
                coverability(
                        "any marking on the way makes places unbounded",
                        "CoverabilitySearch",
                        "order.covers(marking, before) && grow",
                        "grow"),
                coverability(
                        "equal places become unbounded",
                        "CoverabilitySearch",
                        "marking[place] > before[place] &&",
                        "marking[place] >= before[place] &&"),
                coverability(
                        "what is found anew is dropped",
                        "CoverabilitySearch",
                        "maximal.covering(next) < 0",
                        "maximal.covering(next) >= 0"),
                coverability(
                        "what is covered stays",
                        "CoverabilitySearch",
                        "maximal.add(number, kept::clear);",
                        "maximal.add(number, covered -> {});"),
                coverability(
                        "the last transition is not fired",
                        "CoverabilitySearch",
                        "transition < net.transitionCount() &&",
                        "transition < net.transitionCount() - 1 &&"),
                coverability("places with inhibitor arcs may grow", "MarkingOrder", "addNodes(net.inhibitors());", ""),
                coverability("places that are reset may grow", "MarkingOrder", "addNodes(net.resets());", ""),
                coverability(
                        "exact numbers may differ",
                        "MarkingOrder",
                        "if (first[place] != second[place]) {",
                        "if (false) {"),
                coverability(
                        "fewer tokens cover more",
                        "MarkingOrder",
                        "small[place] > large[place]",
                        "small[place] > 1 + large[place]"),
                coverability(
                        "only equal kinds cover",
                        "MaximalMarkings",
                        "(unbounded & ~large.unbounded) == 0",
                        "unbounded == large.unbounded"),
                coverability(
                        "only who marks the same places covers",
                        "MarkingBucket",
                        "if ((markedPlaces & ~marked[group]) == 0) {",
                        "if (markedPlaces == marked[group]) {"),
                coverability(
                        "only who marks the same places is covered",
                        "MarkingBucket",
                        "if ((marked[group] & ~markedPlaces) == 0) {",
                        "if (marked[group] == markedPlaces) {"),
                coverability(
                        "who is not covered is forgotten", "MarkingBucket", "members[group][kept++] = member;", ""),
                coverability(
                        "a run that was not tried repeats",
                        "CoverabilitySet",
                        "if (pump.grows(net, place)) {",
                        "if (true) {"),
                coverability(
                        "more tokens break nothing",
                        "CoverabilityQueries",
                        "case EQUAL, NOT_EQUAL -> false;",
                        "case EQUAL, NOT_EQUAL -> true;"),
                coverability(
                        "fewer are more",
                        "CoverabilityQueries",
                        "case AT_LEAST, MORE -> !opposite;",
                        "case AT_LEAST, MORE -> true;"),
                coverability(
                        "what counts against a sum may grow",
                        "CoverabilityQueries",
                        "&& comparison.terms().stream().allMatch(term -> term.factor() >= 0)",
                        ""),
                coverability(
                        "one part is enough",
                        "CoverabilityQueries",
                        "part -> holds(part, marking, true))\n                    : all",
                        "part -> !holds(part, marking, true))\n                    : all"),
                coverability(
                        "any number is a number",
                        "CoverabilityQueries",
                        "return true; // the sum",
                        "return false; // the sum"),
                coverability(
                        "a transition that is not enabled stays so",
                        "CoverabilityQueries",
                        "return !opposite; // places",
                        "return true; // places"));
    }

    private static Stream<Arguments> ofStructure() {
        return Stream.of(
                structure("resets take nothing", "Incidence", "columns.add(IntegerVector.unit(place, -1));", ""),
                structure(
                        "transitions consume nothing",
                        "Incidence",
                        "vector(net.consumed(), transition), -1)",
                        "vector(net.consumed(), transition), 0)"),
                structure(
                        "what changes by one never changes",
                        "Incidence",
                        "weights.times(column) == 0",
                        "weights.times(column) <= 0"),
                structure(
                        "what grows by one never grows",
                        "Incidence",
                        "weights.times(column) <= 0",
                        "weights.times(column) <= 1"),
                structure("a reset empties no trap", "ClosedPlaces", "both.or(bits(emptied[transition]));", ""),
                structure(
                        "siphons are traps",
                        "ClosedPlaces",
                        "nodes(net.produced()), nodes(net.consumed()));",
                        "nodes(net.consumed()), nodes(net.produced()));"),
                structure(
                        "a place that goes takes no other along",
                        "ClosedPlaces",
                        "failed.add(transition);\n                        }\n                    }",
                        "}\n                    }"),
                structure(
                        "inhibitor arcs stop nothing",
                        "SiphonTrapCheck",
                        "if (net.inhibitors().size() > 0) {",
                        "if (false) {"),
                structure(
                        "two tokens are one",
                        "SiphonTrapCheck",
                        "if (!NetClass.consumesSingleTokens(net)) {",
                        "if (false) {"),
                structure(
                        "an empty trap is enough",
                        "SiphonTrapCheck",
                        "if (trap.stream().noneMatch(place -> net.initial(place) > 0)) {",
                        "if (trap.isEmpty()) {"),
                structure(
                        "the first siphon is the only one",
                        "MinimalClosedSets",
                        "open.push(new Problem(allowed, (BitSet) required.clone()));",
                        ""),
                structure("factors may be negative", "RefutedCase", "if (factors.valueAt(i) < 0) {", "if (false) {"),
                structure("a sum that is reached is not", "RefutedCase", "return room < 0;", "return room <= 0;"),
                structure(
                        "a sum may grow",
                        "RefutedCase",
                        "if (Math.addExact(growth, firings.get(column)) > 0) {",
                        "if (Math.addExact(growth, firings.get(column)) > 1) {"),
                structure(
                        "a number of firings is left out",
                        "StateEquation",
                        "new FiringLimit(column, true, below + 1)",
                        "new FiringLimit(column, true, below + 2)"),
                structure(
                        "one of two cases is enough",
                        "StateEquation",
                        "choice.get().parts().stream().allMatch(part",
                        "choice.get().parts().stream().anyMatch(part"),
                structure(
                        "one of two numbers of firings is enough",
                        "StateEquation",
                        "below)))\n                && contradicts",
                        "below)))\n                || contradicts"),
                structure(
                        "an empty trap stays marked",
                        "StateEquation",
                        "trap.stream().anyMatch(place -> net.initial(place) > 0) ? trap",
                        "true ? trap"),
                structure(
                        "a choice is made at once",
                        "StateEquation",
                        "choices.add((OneOf) condition);",
                        "add(((OneOf) condition).parts().get(0));"),
                structure(
                        "an opposite leaves one out",
                        "LinearCondition",
                        "Math.subtractExact(1, sum.least())",
                        "Math.subtractExact(2, sum.least())"),
                structure(
                        "inhibited is one more",
                        "LinearCondition",
                        "inhibitors.weight(arc) - 1L",
                        "inhibitors.weight(arc) - 2L"),
                structure(
                        "less is at most",
                        "StructuralQueries",
                        "case LESS -> LinearCondition.opposite(atLeast(weights, constant));",
                        "case LESS -> LinearCondition.opposite(atLeast(weights, constant - 1));"),
                structure(
                        "parts are joined the other way",
                        "StructuralQueries",
                        "parts(all.parts(), opposite, opposite)",
                        "parts(all.parts(), opposite, !opposite)"),
                structure(
                        "a bound is one lower",
                        "MarkingBound",
                        "weights.times(net.initialMarking()), incidence",
                        "weights.times(net.initialMarking()) - 1, incidence"));
    }

    private static Arguments coverability(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, CoverabilityJudge.class, "coverability/" + source, right, wrong);
    }

    private static Arguments structure(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, StructureJudge.class, "structure/" + source, right, wrong);
    }
}
