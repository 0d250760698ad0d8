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

/** The comparison of nets that follow copies of robots into sub-missions with the engine notices when one line of that translation is wrong: each row spoils one. */
@Tag("long")
class SpoiltCopiesTest {
    private static final Path PLANS = Path.of("../spn-authoring/src/main/java/org/sami/spn/plannet");
    private static final int LEAST_SPOILT = 8;
    private static final int MOST_SEEDS = 400;
    private static final SpoiltNets NETS = new SpoiltNets(CopiedChildJudge.class, MOST_SEEDS);

    /** What is spoilt, and the line. */
    static Stream<Arguments> lines() {
        return Stream.of(
                plan(
                        "several copies are lost count of nowhere",
                        "PossibleTokens",
                        "return isCopied(token)",
                        "return false"),
                plan(
                        "a child's start has one copy at most",
                        "PlanNetWork",
                        "token -> possible.isLoose(token, at.id())",
                        "token -> false"),
                plan("no copy visits", "VisitChild", "visitors.add(at);", ""),
                plan(
                        "it is known who is back of several copies",
                        "FollowedChildren",
                        "&& isKnownWhoIsBack(place.id())",
                        ""),
                plan("the start has one copy at most", "SinglePlaces", "return several.test(token)", "return false"),
                plan("nobody enters where copies are", "VisitChild", "edges > 1 || isByNobody", "edges > 1"),
                plan(
                        "an interrupt takes nobody out",
                        "VisitChild",
                        "if (edges == 0) {\n            leaveOpen(arcs);",
                        "if (edges == 0) {"),
                plan(
                        "a copy that leaves takes all with it",
                        "TokenOptions",
                        "boolean isOnce = option.present.stream().noneMatch(spot -> possible.isLoose(option.token, spot));",
                        "boolean isOnce = true;"));
    }

    private static Arguments plan(String spoilt, String source, String right, String wrong) {
        return arguments(spoilt, PLANS.resolve(source + ".java"), right, wrong);
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
