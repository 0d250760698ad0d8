package org.sami.petri.query;

import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.provider.Arguments;
import org.sami.petri.symmetry.SymmetryJudge;

/** The comparisons of answers with what a plain search saw notice when one line of symmetry or queries is wrong: each row spoils one. */
@Tag("long")
class SpoiltAnswerTest extends SpoiltLines {
    SpoiltAnswerTest() {
        super(28, new SymmetryJudge(), new QueryJudge());
    }

    @Override
    Stream<Arguments> lines() {
        return Stream.concat(ofSymmetry(), ofQueries());
    }

    private static Stream<Arguments> ofSymmetry() {
        return Stream.of(
                symmetry(
                        "the first tokens are not compared",
                        "symmetry/NetPermutation",
                        "net.initial(place) != net.initial(places[place])",
                        "false"),
                symmetry(
                        "arcs are not compared",
                        "symmetry/NetPermutation",
                        "arcs.weight(other, places[arcs.node(arc)]) != arcs.weight(arc)",
                        "false"),
                symmetry(
                        "all markings stay",
                        "symmetry/NetPermutation",
                        "if (marking[places[place]] != marking[place]) {",
                        "if (false) {"),
                symmetry(
                        "exchanges that change the marking make firings alike",
                        "symmetry/NetSymmetry",
                        "if (generator.fixes(marking)) {",
                        "if (true) {"),
                symmetry(
                        "of two firings that are alike none is left",
                        "symmetry/NetSymmetry",
                        "other < transition && isListed[other]",
                        "other != transition && isListed[other]"),
                symmetry(
                        "tokens are exchanged once",
                        "symmetry/NetSymmetry",
                        "changed |= spread(generator, fired, mostTokens);",
                        "spread(generator, fired, mostTokens);"),
                symmetry(
                        "the way back takes the exchanges the other way",
                        "symmetry/NetSymmetry",
                        "before[t] = then[generator.transition(t)];",
                        "before[generator.transition(t)] = then[t];"),
                symmetry(
                        "the way back takes no exchanges",
                        "symmetry/NetSymmetry",
                        "before[t] = then[generator.transition(t)];",
                        ""),
                symmetry(
                        "who is like one with more tokens has as many as before",
                        "symmetry/NetSymmetry",
                        "if (mostTokens[place] < mostTokens[image]) {",
                        "if (false) {"),
                symmetry(
                        "who is like one that fires never fires",
                        "symmetry/NetSymmetry",
                        "if (fired.get(image) && !fired.get(t)) {",
                        "if (false) {"),
                symmetry("only the last place has to fit", "graph/StateLayout", "excess |= ", "excess = "),
                symmetry(
                        "what follows a firing is not made alike",
                        "symmetry/NetSymmetry",
                        "touching(places(net, t))",
                        "touching(new int[0])"));
    }

    private static Stream<Arguments> ofQueries() {
        return Stream.of(
                query(
                        "any symmetry keeps any condition",
                        ".filter(symmetry -> ConditionSymmetry.isKept(condition, symmetry))",
                        ""),
                query(
                        "what is never reached is reached",
                        "whenFound ? NetVerdict.NO : NetVerdict.YES, what + \" is never",
                        "whenFound ? NetVerdict.YES : NetVerdict.NO, what + \" is never"),
                query(
                        "what a part does not show is never reached",
                        ": unknown(graph, what + \" was not found\");",
                        ": new QueryAnswer(whenFound ? NetVerdict.NO : NetVerdict.YES, what, Optional.empty(),"
                                + " graph);"),
                query(
                        "an invariant is asked for as it stands",
                        "first(new Not(invariant.condition()), false",
                        "first(invariant.condition(), false"),
                query("ends are deadlocks", "new Not(query.end())", "new All(List.of())"),
                query("the farthest deadlock is shown", ".min();", ".max();"),
                query("known deadlocks are any", ".filter(state -> goal.test(whole.marking(state)))", ""),
                query(
                        "all can come home where a part can",
                        "if (!graph.isComplete()) {\n            return unknown(graph, \"not every",
                        "if (false) {\n            return unknown(graph, \"not every"),
                query("all can come home", "if (states.firstWithout().isEmpty()) {", "if (true) {"),
                query(
                        "homes are the same by symmetry",
                        "boolean isSymmetric = isSymmetric(isKept(condition));",
                        "boolean isSymmetric = isSymmetric(true);"),
                query(
                        "a sum is the same by symmetry",
                        "boolean isKept = isKept(new LinearComparison(bound.terms(),"
                                + " LinearComparison.Relation.AT_LEAST, 0));",
                        "boolean isKept = true;"),
                query("the most of a sum is the first", "if (sum > most) {", "if (most == Long.MIN_VALUE) {"),
                query(
                        "the most of a sum in a part is the most",
                        "return graph.isComplete()\n                ? new QueryAnswer(NetVerdict.YES, bound.text()",
                        "return true\n                ? new QueryAnswer(NetVerdict.YES, bound.text()"),
                query(
                        "the most tokens in a part are the most",
                        "return graph.isComplete()\n                ? new QueryAnswer(NetVerdict.YES, words",
                        "return true\n                ? new QueryAnswer(NetVerdict.YES, words"),
                query("a run to fewer tokens shows the most", "marking[place] == most", "marking[place] <= most"),
                query(
                        "graphs of states that are alike are whole",
                        "known.put(isSymmetric, graph);\n        }",
                        "known.put(false, graph);\n        }"));
    }

    private static Arguments symmetry(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, SymmetryJudge.class, source, right, wrong);
    }

    private static Arguments query(String spoilt, String right, String wrong) {
        return arguments(spoilt, QueryJudge.class, "query/QueryRunner", right, wrong);
    }
}
