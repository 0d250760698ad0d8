package org.sami.spn.reference;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** The comparisons of plans' nets with the engine notice when one line of the translation, or of the search, is wrong: each row spoils one. */
@Tag("long")
class SpoiltTranslationTest {
    private static final Path PLANS = Path.of("../spn-authoring/src/main/java/org/sami/spn/plannet");
    private static final Path SEARCHES = Path.of("../petri/src/main/java/org/sami/petri/graph");
    private static final int LEAST_SPOILT = 20;
    private static final int MOST_SEEDS = 2000;
    private static final SpoiltNets NETS = new SpoiltNets(NetJudge.class, MOST_SEEDS);

    /** What is spoilt, and the line. */
    static Stream<Arguments> lines() {
        return Stream.of(
                plan("none is at most one", "InConditions", "none.below(one, 1)", "none.below(one, 2)"),
                plan("exactly is one more at most", "InConditions", "r.n() + 1);", "r.n() + 2);"),
                plan("less than is at most", "InConditions", "arcs.below(at, r.n());", "arcs.below(at, r.n() + 1);"),
                plan("at least is one less", "InConditions", "arcs.atLeast(at, least)", "arcs.atLeast(at, least - 1)"),
                single("all of those named may be some", ".allMatch(edge -> present", ".anyMatch(edge -> present"),
                plan("what enters a place is lost", "TokenOptions", "option.arcs.add(at, 1)", "option.arcs.add(at, 0)"),
                plan(
                        "take leaves the token where it is",
                        "TokenOptions",
                        "one.arcs.remove(at, 1)",
                        "one.arcs.atLeast(at, 1)"),
                plan(
                        "who enters is not counted",
                        "TokenOptions",
                        "option.arcs.add(counter, 1)",
                        "option.arcs.add(counter, 0)"),
                plan(
                        "who leaves is still counted",
                        "TokenOptions",
                        "one.arcs.remove(counter, 1)",
                        "one.arcs.remove(counter, 0)"),
                plan("consume adds as take does", "Selections", "!= Action.CONSUME", "!= Action.ADD"),
                plan(
                        "a smaller number takes none of a larger",
                        "TokenOptions",
                        "level <= s.level()",
                        "level == s.level()"),
                plan("all generic tokens are one", "GenericOptions", "return here;", "return Math.min(here, 1);"),
                plan(
                        "generic tokens that are taken stay",
                        "GenericOptions",
                        "option.arcs.remove(places.of(place, PlanToken.GENERIC).getAsInt(), gone)",
                        "option.arcs.atLeast(places.of(place, PlanToken.GENERIC).getAsInt(), gone)"),
                plan(
                        "add makes one generic token",
                        "GenericOptions",
                        "fresh[s.edge()] += r.n()",
                        "fresh[s.edge()] += 1"),
                plan(
                        "an end does not end the mission",
                        "FiringEffects",
                        "arcs.remove(running, 1)",
                        "arcs.atLeast(running, 1)"),
                plan(
                        "an event that names nobody is for who must be named",
                        "TransitionCases",
                        "if (mustHaveRelevant && ",
                        "if (!mustHaveRelevant && "),
                plan(
                        "nobody looks where tokens entered",
                        "FiringEffects",
                        "entered.forEach(edge -> work.places().occasions(work.plan(), selections.target(edge), true,"
                                + " arcs))",
                        ""),
                plan(
                        "nobody looks where tokens left",
                        "FiringEffects",
                        "left.forEach(place -> work.places().occasions(work.plan(), place, false, arcs))",
                        ""),
                plan(
                        "nobody looks at the start",
                        "MissionPlaces",
                        "to look at \" + transition, atStart ? 1 : 0",
                        "to look at \" + transition, 0"),
                plan(
                        "those at the start are not counted",
                        "MissionPlaces",
                        "counted.stream().mapToInt(token -> initialIn(place, token)).sum()",
                        "0"),
                plan("a token in two places is one", "PossibleTokens", "return entered > 1", "return entered > 2"),
                plan(
                        "a task is any task",
                        "PossibleTokens",
                        "case TASK -> token.isTask(r.task())",
                        "case TASK -> true"),
                single(
                        "a group may hold a token twice",
                        "present.size() - others.size() <= 1",
                        "present.size() - others.size() <= 0"),
                single("nobody who is named is looked at", "(!t.inputs().isEmpty()", "(false"),
                single("no group takes in more than leaves", "if (entering > leaving(", "if (entering > 1 + leaving("),
                single("what enters is not counted", "entering += entering(", "entering += 0 * entering("),
                single("who is picked does not enter", "isPicked ? Math.min(r.n(), present) : 0", "0"),
                single(
                        "who is added is not counted",
                        "? Math.min(r.n(), Math.max(1, present)) : Math.max(1, present)",
                        "? 0 : 0"),
                single("who is picked by an addition leaves", "s.requirement().action() != Action.ADD", "true"),
                single(
                        "what is added leaves too",
                        "s.removes() && s.requirement().takesAll()",
                        "s.requirement().takesAll()"),
                plan(
                        "several copies are lost count of nowhere",
                        "PossibleTokens",
                        "return isCopied(token)",
                        "return false"),
                single(
                        "who is taken with all of them does not enter",
                        "s.level() == 0 ? present :",
                        "s.level() == 0 ? 0 :"),
                single(
                        "who is named is never relevant",
                        "isNamed || !s.isOf(TokenKind.RELEVANT)",
                        "!s.isOf(TokenKind.RELEVANT)"),
                plan(
                        "what comes directly needs a marked place",
                        "WakenedCases",
                        "ins.isEmpty() || comesDirectly()",
                        "ins.isEmpty()"),
                plan("an answer ends no visit by nobody", "WakenedCases", "if (asks) {", "if (false) {"),
                search(
                        "an inhibitor arc lets one more stay",
                        "EnabledTransitions",
                        ">= inhibitors.weight(arc)",
                        "> inhibitors.weight(arc)"),
                search("inhibitor arcs do nothing", "EnabledTransitions", "!inhibits ||", "true ||"),
                search("one token is enough", "EnabledTransitions", "< consumed.weight(arc)", "< 1"),
                search(
                        "a firing produces one token",
                        "PackedFiring",
                        "produced.node(arc), produced.weight(arc));",
                        "produced.node(arc), 1);"));
    }

    private static Arguments single(String spoilt, String right, String wrong) {
        return plan(spoilt, "SinglePlaces", right, wrong);
    }

    private static Arguments plan(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, PLANS.resolve(source + ".java"), right, wrong);
    }

    private static Arguments search(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, SEARCHES.resolve(source + ".java"), right, wrong);
    }

    @Test
    void manyLinesAreSpoilt() {
        assertThat(lines()).hasSizeGreaterThanOrEqualTo(LEAST_SPOILT);
        assertThat(lines().map(row -> row.get()[0])).doesNotHaveDuplicates();
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
