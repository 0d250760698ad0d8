package org.sami.petri.query;

import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.provider.Arguments;
import org.sami.petri.graph.GraphJudge;

/** The comparisons of searches with a plain one notice when one line of graphs or reductions is wrong: each row spoils one. */
@Tag("long")
class SpoiltSearchTest extends SpoiltLines {
    SpoiltSearchTest() {
        super(33, new GraphJudge());
    }

    @Override
    Stream<Arguments> lines() {
        return ofGraphs();
    }

    private static Stream<Arguments> ofGraphs() {
        return Stream.of(
                graph(
                        "what a disabled transition waits for is left out",
                        "StubbornSets",
                        "enabled[transition] ? relations.dependentOn(transition) : enablers(transition, marking)",
                        "enabled[transition] ? relations.dependentOn(transition) : new int[0]"),
                graph(
                        "what an enabled transition depends on is left out",
                        "StubbornSets",
                        "? relations.dependentOn(transition) :",
                        "? new int[0] :"),
                graph(
                        "too few tokens come by those that take them",
                        "StubbornSets",
                        "relations.raising(net.consumed()",
                        "relations.lowering(net.consumed()"),
                graph(
                        "too many tokens go by those that bring them",
                        "StubbornSets",
                        "relations.lowering(net.inhibitors()",
                        "relations.raising(net.inhibitors()"),
                graph(
                        "an enabled transition of the state before is enabled",
                        "StubbornSets",
                        "enabled[list[i]] = false;",
                        ""),
                graph(
                        "who brings one token more brings none",
                        "TransitionRelations",
                        "producers.weight(arc) > consumers.weight(place, t)",
                        "producers.weight(arc) > 1 + consumers.weight(place, t)"),
                graph(
                        "who takes one token more takes none",
                        "TransitionRelations",
                        "consumers.weight(arc) > producers",
                        "consumers.weight(arc) > 1 + producers"),
                graph(
                        "who empties a place takes nothing",
                        "TransitionRelations",
                        "addAll(resetters, place, set);\n            known",
                        "known"),
                graph(
                        "tokens for the same place share nothing",
                        "TransitionRelations",
                        "addAll(consumers, place, set);\n                addAll(resetters",
                        " addAll(resetters"),
                graph(
                        "who consumes minds no reset",
                        "TransitionRelations",
                        "addAll(consumers, place, set);\n                addAll(resetters, place, set);",
                        "addAll(consumers, place, set);"),
                graph(
                        "who produces minds nobody inhibited",
                        "TransitionRelations",
                        "addAll(inhibited, place, set);",
                        ""),
                graph(
                        "who produces minds no reset",
                        "TransitionRelations",
                        "addAll(inhibited, place, set);\n                addAll(resetters, place, set);",
                        "addAll(inhibited, place, set);"),
                graph(
                        "who is inhibited minds nobody who produces",
                        "TransitionRelations",
                        "for (int other : raising(place)) {\n                    set.set(other);\n                }",
                        ""),
                graph(
                        "after the last slot comes none",
                        "StateTable",
                        "slot + 1 == slots.length() ? 0 : slot + 1",
                        "slot + 1"),
                graph(
                        "states that begin alike are one",
                        "StateTable",
                        "if (states.get(at + w) != state[w]) {",
                        "if (states.get(at) != state[0]) {"),
                graph(
                        "states are one word apart",
                        "StateTable",
                        "long at = (long) number * words;",
                        "long at = number;"),
                graph(
                        "the larger table forgets",
                        "StateTable",
                        "slots.set(slot, number + 1);",
                        "slots.set(slot, number);"),
                graph(
                        "states of the larger table push out others",
                        "StateTable",
                        "while (slots.get(slot) != 0) {\n",
                        "while (slots.get(slot) == Integer.MIN_VALUE) {\n"),
                graph("a state that is packed again is the first", "StateTable", "load(number, old);", "load(0, old);"),
                graph(
                        "a field crosses words",
                        "StateLayout",
                        "used + bits[place] > Long.SIZE",
                        "used + bits[place] > Long.SIZE + 1"),
                graph("fields overlap", "StateLayout", "used += bits[place];", "used += bits[place] - 1;"),
                graph(
                        "a number has one bit fewer",
                        "StateLayout",
                        "Integer.SIZE - Integer.numberOfLeadingZeros(tokens)",
                        "Integer.SIZE - 1 - Integer.numberOfLeadingZeros(tokens)"),
                graph(
                        "a field holds one token more",
                        "StateLayout",
                        "((1L << bits[place]) - 1)",
                        "(1L << bits[place])"),
                graph(
                        "what a transition takes of what it brings is not counted",
                        "PackedFiring",
                        "produced.weight(arc) - consumed.weight(t, produced.node(arc))",
                        "produced.weight(arc) - 2 * consumed.weight(t, produced.node(arc))"),
                graph(
                        "changes of one word replace each other",
                        "PackedFiring",
                        "sums[at] += tokens",
                        "sums[at] = tokens"),
                graph(
                        "what is brought after a reset always fits",
                        "PackedFiring",
                        "resets[transition] ? overflowAfterReset(transition) : FITS",
                        "FITS"),
                graph("a reset empties nothing", "PackedFiring", "after[emptied.node(arc)] = 0;", ""),
                graph("only who is one firing away comes home", "HomeStates", "open[waiting++] = sources[i];", ""),
                graph(
                        "no marking is home",
                        "HomeStates",
                        "reached.set(state);\n                open[waiting++] = state;",
                        "open[waiting++] = state;"),
                graph(
                        "the first who comes home is the first who does not",
                        "HomeStates",
                        "canReach.nextClearBit(0)",
                        "canReach.nextSetBit(0)"),
                graph(
                        "edges lead back to where they end",
                        "HomeStates",
                        "sources[next[edges.target(edge)]++] = state;",
                        "sources[next[edges.target(edge)]++] = edges.target(edge);"),
                graph(
                        "who resets minds nobody who consumes",
                        "TransitionRelations",
                        "addAll(consumers, place, set);\n                addAll(producers",
                        "addAll(producers"),
                graph(
                        "who resets minds nobody who produces",
                        "TransitionRelations",
                        "addAll(producers, place, set);",
                        ""));
    }

    private static Arguments graph(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, GraphJudge.class, "graph/" + source, right, wrong);
    }
}
