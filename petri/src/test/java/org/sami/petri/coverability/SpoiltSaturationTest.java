package org.sami.petri.coverability;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.file.Path;
import java.util.Optional;
import java.util.function.LongFunction;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sami.spn.testing.SpoiltClasses;

/** The comparison of saturated with whole graphs notices when one line of the saturated net is wrong: each row spoils one. */
class SpoiltSaturationTest {
    private static final Path SOURCES = Path.of("src/main/java/org/sami/petri/coverability");
    private static final int MOST_SEEDS = 2_500;

    /** What is spoilt, the class, and the line. */
    static Stream<Arguments> lines() {
        return Stream.of(
                net("places have all their tokens at first", "Math.min(1, initial)", "initial"),
                net("places have no token at first", "Math.min(1, initial)", "0"),
                net("other places have one token at first", "initial) : initial", "initial) : Math.min(1, initial)"),
                net("who consumes a token leaves none", "choices.add(place);", ""),
                net("who consumes a token leaves one", "int variant = 0;", "int variant = (1 << choices.size()) - 1;"),
                net(
                        "only one place may keep a token",
                        "variant < 1 << choices.size()",
                        "variant < Math.min(2, 1 << choices.size())"),
                net("all firings are sure", "isSure && variant == 0", "true"),
                net("a firing that leaves a token is sure", "isSure && variant == 0", "isSure"),
                net(
                        "a firing that needs no token is sure",
                        "isSure &= original.inhibitors().weight(t, place) == 0;",
                        ""),
                net("transitions stand for the first", "originals.add(t);", "originals.add(0);"),
                net("nothing is consumed", "builder.consume(number, consumed.node(arc), consumed.weight(arc));", ""),
                net("one token is consumed", "consumed.node(arc), consumed.weight(arc)", "consumed.node(arc), 1"),
                net("nothing inhibits", "builder.inhibit(number, inhibitors.node(arc), inhibitors.weight(arc));", ""),
                net("nothing is reset", "builder.reset(number, resets.node(arc));", ""),
                net("one token is produced", "place, produced.weight(arc)", "place, 1"),
                net(
                        "places get all tokens",
                        "builder.produce(number, place, 1);",
                        "builder.produce(number, place, produced.weight(arc));"),
                net("a token joins the one there", "builder.reset(number, place); // there", "// there"),
                net("the token left is another place's", "choices.get(i), 1)", "choices.get(0), 1)"),
                rules("inhibitor arcs may count", "strike(net.inhibitors());", ""),
                rules("arcs may count", "strike(net.consumed());", ""),
                rules("all places are exact", "exact.clear(place);", ""),
                rules("all transitions are last", "!last.get(t) &&", "false &&"),
                rules("any transition is last", "== 0);\n                }", "<= 9);\n                }"));
    }

    private static Arguments net(String spoilt, String right, String wrong) {
        return arguments(spoilt, "SaturatedNet", right, wrong);
    }

    private static Arguments rules(String spoilt, String right, String wrong) {
        return arguments(spoilt, "SaturablePlaces", right, wrong);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("lines")
    void disagreesSoon(String spoilt, String source, String right, String wrong, @TempDir Path folder)
            throws ReflectiveOperationException {
        LongFunction<?> judge = (LongFunction<?>) SpoiltClasses.with(
                        folder,
                        SOURCES.resolve(source + ".java"),
                        right,
                        wrong,
                        name -> name.startsWith("org.sami.petri."))
                .loadClass(SaturationJudge.class.getName())
                .getConstructors()[0]
                .newInstance();

        Optional<?> found = Optional.empty();
        for (long seed = 0; seed < MOST_SEEDS && found.isEmpty(); seed++) {
            found = judged(judge, seed);
        }

        assertThat(found).as(spoilt).isPresent();
    }

    /** What differs; a net that cannot be made or searched any more is noticed too. */
    private static Optional<?> judged(LongFunction<?> judge, long seed) {
        try {
            return (Optional<?>) judge.apply(seed);
        } catch (IllegalArgumentException | IllegalStateException | IndexOutOfBoundsException broken) {
            return Optional.of("seed " + seed + ": " + broken);
        }
    }
}
