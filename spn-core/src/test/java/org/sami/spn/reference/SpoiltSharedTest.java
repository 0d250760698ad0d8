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

/** The comparison of nets that follow shared sub-missions with the engine notices when one line of that translation is wrong: each row spoils one. */
@Tag("long")
class SpoiltSharedTest {
    private static final Path PLANS = Path.of("../spn-authoring/src/main/java/org/sami/spn/plannet");
    private static final int LEAST_SPOILT = 14;
    private static final int MOST_SEEDS = 400;
    private static final SpoiltNets NETS = new SpoiltNets(SharedJudge.class, MOST_SEEDS);

    /** What is spoilt, and the line. */
    static Stream<Arguments> lines() {
        return Stream.of(
                shared("who enters does not join", "join(joined);", ""),
                shared("an interrupt takes nobody out", "if (isPulled || isByNobody) {", "if (isByNobody) {"),
                shared("nobody enters and changes nothing", "if (isPulled || isByNobody) {", "if (isPulled) {"),
                shared("nobody joins one that runs", "joined.atLeast(running, 1);", "joined.below(running, 1);"),
                shared("nobody enters one that is over", "cases.add(over);", ""),
                shared("what waits in its start place is not told", "inner.isPresent()", "false && inner.isPresent()"),
                shared("who came back is held", "arcs.atLeast(at, 1);", "arcs.atLeast(at, 2);"),
                shared(
                        "a return of nobody lets nothing fire",
                        "ofNobody.remove(unused, 1);",
                        "ofNobody.remove(unused, 9);"),
                shared("a return of nobody is lost", "arcs.add(unused, 1));", "arcs.add(unused, 0));"),
                shared("a robot of whom nothing is said never came back", "cases.add(ofOther);", ""),
                shared("who was returned stays in the end place", ".forEach(arcs::cancel);", ".count();"),
                shared(
                        "a return brings at least one robot more than asked for",
                        "others.size() < robots",
                        "others.size() < robots + 1"),
                plan(
                        "each end place ends it",
                        "PlanNetWork",
                        "(!isShared || end.endsSharedInstance())",
                        "(isShared || end.end())"),
                plan(
                        "it starts with the first visit",
                        "PlanNetWork",
                        "isShared ? parent.places.runsAtFirst()",
                        "isShared ? false"),
                plan(
                        "it does not start with a sub-mission",
                        "FollowedChild",
                        "mission.children().forEach(child -> child.parentStarts(arcs));",
                        ""),
                plan(
                        "who is not back leaves with the others",
                        "PossibleTokens",
                        "mode == SubMode.RETURNED ||",
                        "mode == SubMode.VACANT ||"));
    }

    private static Arguments shared(String spoilt, String right, String wrong) {
        return plan(spoilt, "SharedChild", right, wrong);
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
