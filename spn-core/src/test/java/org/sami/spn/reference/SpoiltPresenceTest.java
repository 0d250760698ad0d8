package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The comparison of nets that follow whether any robots are there with nets that name them notices when one line of the translation or of the answers is wrong. */
class SpoiltPresenceTest {
    private static final Path PLANS = Path.of("../spn-authoring/src/main/java/org/sami/spn/plannet");
    private static final Path ANSWERS = Path.of("../petri/src/main/java/org/sami/petri");
    private static final int MOST_SEEDS = 500;
    private static final SpoiltNets NETS = new SpoiltNets(PresentJudge.class, MOST_SEEDS);

    /** What is spoilt, the source, and the line. */
    static Stream<Arguments> lines() {
        return Stream.of(
                cases(
                        "all that may happen surely does",
                        "surely.retainAll(cases.keySet());",
                        "surely.addAll(cases.keySet());"),
                cases(
                        "only what surely happens may happen",
                        "may.putAll(cases);",
                        "if (may.isEmpty()) { may.putAll(cases); } may.keySet().retainAll(cases.keySet());"),
                cases(
                        "robots stand in one place at most",
                        ".filter(present::containsAll)",
                        ".filter(one -> present.containsAll(one) && one.size() < 2)"),
                cases(
                        "a robot is where it is not",
                        "share(within, i, chosen, shares);",
                        "share(within, i + 1, chosen, shares);"),
                cases(
                        "who stands elsewhere as well is not looked at",
                        "standing.contains(spot) == option.present.contains(spot)",
                        "true"),
                cases("a place keeps its robots", "forEach(place -> arcs.empty(at(place)))", "forEach(place -> {})"),
                cases("nobody enters", "forEach(place -> arcs.set(at(place)))", "forEach(place -> {})"),
                cases("a place without robots is not asked for", "arcs.below(at(spot), 1);", "{ }"),
                cases("a place with robots is not asked for", "arcs.atLeast(at(spot), 1);", "{ }"),
                cases(
                        "only the first robot moves",
                        "after.addAll(robots.get(i).after(standings.get(i)))",
                        "after.addAll(i == 0 ? robots.get(i).after(standings.get(i)) : standings.get(i))"),
                cases("who may be anywhere is nowhere", "option -> option.isAnywhere", "option -> false"),
                plan(
                        "each robot counts at the start",
                        "PlanNetWork",
                        "view == RobotView.PRESENT ? 1 :",
                        "view == RobotView.PRESENT ? 2 :"),
                answers(
                        "what may be enabled is enabled",
                        "coverability/SaturatedQueries",
                        "!end.test(marking) && !isSomethingSure(marking)",
                        "!end.test(marking) && false"),
                answers(
                        "what may happen leads home",
                        "coverability/SaturatedSearch",
                        "saturated.isSure(t) && wider.isSure(saturated.original(t))",
                        "saturated.isSure(t)"),
                answers(
                        "robots are counted",
                        "coverability/SaturatedQueries",
                        "(wider.presence().get(term.place()) && !comparison.isOfPresence())",
                        "false"),
                answers(
                        "bounds of robots are known",
                        "coverability/SaturatedQueries",
                        "saturated.places().get(place) || wider.presence().get(place)",
                        "saturated.places().get(place)"),
                answers("two robots are one", "query/LinearComparison", "constant == least &&", "true &&"));
    }

    private static Arguments cases(String spoilt, String right, String wrong) {
        return plan(spoilt, "PresenceCases", right, wrong);
    }

    private static Arguments plan(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, PLANS.resolve(source + ".java"), right, wrong);
    }

    private static Arguments answers(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, ANSWERS.resolve(source + ".java"), right, wrong);
    }

    @ParameterizedTest(name = "{0}")
    @MethodSource("lines")
    void disagreesSoon(String spoilt, Path source, String right, String wrong, @TempDir Path folder)
            throws ReflectiveOperationException {
        assertThat(NETS.difference(spoilt, folder, source, right, wrong))
                .as(spoilt)
                .isPresent();
    }
}
